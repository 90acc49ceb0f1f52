// Releases a scene's buffers, programs and textures on the GPU. Nothing is lost: the next drawing uploads them again.
import { type Mesh, type Object3D, type ShaderMaterial, Texture } from 'three';

export function releaseGpu(root: Object3D): void {
  root.traverse((object) => {
    const { geometry, material } = object as Partial<Mesh>;
    geometry?.dispose();
    for (const one of [material ?? []].flat()) {
      one.dispose();
      const { uniforms = {} } = one as Partial<ShaderMaterial>;
      for (const { value } of Object.values(uniforms)) if (value instanceof Texture) value.dispose();
    }
  });
}
