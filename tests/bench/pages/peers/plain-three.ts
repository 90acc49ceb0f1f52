// What plain three.js pages share: a renderer like the element's own (transparent, multisampled), one mesh, one camera.
import {
  BufferAttribute,
  BufferGeometry,
  LinearSRGBColorSpace,
  type Material,
  Mesh,
  PerspectiveCamera,
  Scene,
  WebGLRenderer,
} from 'three';
import type { Triangles } from '../../glb.mjs';
import { CAMERA } from '../scenes.js';
import type { Peer } from './peer.js';

export interface PlainThree {
  readonly renderer: WebGLRenderer;
  readonly scene: Scene;
  readonly camera: PerspectiveCamera;
}

export function geometryOf({ positions, normals, indices }: Triangles): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(positions, 3));
  geometry.setAttribute('normal', new BufferAttribute(normals, 3));
  return geometry.setIndex(new BufferAttribute(indices, 1));
}

/** `encode`: colours are encoded to sRGB in the shader, as three.js does by default; the element does not. */
export function plainThree(
  holder: HTMLElement,
  geometry: BufferGeometry,
  material: Material,
  encode: boolean,
): PlainThree {
  // As the element does, unless the bench asks for one sample a pixel: ?samples=1
  const antialias = new URLSearchParams(location.search).get('samples') !== '1';
  const renderer = new WebGLRenderer({ antialias, alpha: true });
  if (!encode) renderer.outputColorSpace = LinearSRGBColorSpace;
  holder.append(renderer.domElement);
  const scene = new Scene();
  scene.add(new Mesh(geometry, material));
  const camera = new PerspectiveCamera(CAMERA.fov, 1, 0.1, 20);
  camera.position.set(0, 0, CAMERA.radius);
  return { renderer, scene, camera };
}

export function threePeer({ renderer, scene, camera }: PlainThree): Peer {
  return {
    gl: renderer.getContext() as WebGL2RenderingContext,
    draw: () => renderer.render(scene, camera),
    programs: () => renderer.info.programs?.length ?? 0,
    resize(width, height) {
      renderer.setSize(width, height);
      camera.aspect = width / height;
      camera.updateProjectionMatrix();
      return Promise.resolve();
    },
  };
}
