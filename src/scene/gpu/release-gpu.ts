// Gives back what the GPU holds of a scene: buffers, programs, textures. Nothing is lost: drawing sends it again.
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
