// What a picture shows at one moment: the scene may change while the code of shadeAt is fetched.
// Values that are overwritten are copied, except animated vertices and the page's own objects:
// these count as they are when it runs.
import type { BufferGeometry, Matrix4, Mesh, Object3D, PerspectiveCamera } from 'three';
import { smoothGeometry } from '../material/flat-geometry.js';
import type { ShadingFrame } from '../material/shading-space.js';
import { PhongMaterial } from '../material/phong-material.js';

/** How the Phong material shades an object. */
type DrawnLook = Readonly<Pick<PhongMaterial, 'look' | 'sides' | 'surface' | 'style' | 'linear'>>;

/** An object that an element declares. */
export interface OwnDrawn<Owner = unknown> {
  readonly object: Object3D;
  readonly matrixWorld: Matrix4;
  readonly geometry: BufferGeometry;
  readonly owner: Owner;
  readonly phong: DrawnLook;
}

/**
 * A drawn object; `phong` is null for a page author's own and for other materials than the Phong
 * one.
 */
export type Drawn<Owner = unknown> =
  | OwnDrawn<Owner>
  | { readonly object: Object3D; readonly phong: null };

export interface SceneSnapshot<Owner = unknown> {
  /** Device pixels. */
  readonly width: number;
  readonly height: number;
  readonly frame: ShadingFrame;
  readonly camera: PerspectiveCamera;
  /** In drawing order. */
  readonly objects: readonly Drawn<Owner>[];
}

/**
 * The visible objects below `object`, as three.js draws them. World matrices must be up to date.
 */
export function drawnObjects<Owner>(
  object: Object3D,
  camera: PerspectiveCamera,
  ownerOf: (object: Object3D) => Owner | undefined,
  into: Drawn<Owner>[] = [],
): Drawn<Owner>[] {
  if (!object.visible) return into;
  const { material, geometry, isMesh } = object as Partial<Mesh>;
  const hidden = material !== undefined && !Array.isArray(material) && !material.visible;
  if (!hidden && object.layers.test(camera.layers)) {
    const owner =
      isMesh === true && material instanceof PhongMaterial ? ownerOf(object) : undefined;
    if (owner === undefined) {
      into.push({ object, phong: null });
    } else {
      const { look, sides, surface, style, linear } = material as PhongMaterial;
      // A view may show separate triangles where the shading is smooth.
      const shown = style.shading === 'flat' ? geometry! : smoothGeometry(geometry!);
      const phong = { look, sides, surface, style, linear };
      into.push({ object, matrixWorld: object.matrixWorld.clone(), geometry: shown, owner, phong });
    }
  }
  for (const child of object.children) {
    drawnObjects(child, camera, ownerOf, into);
  }
  return into;
}

/** The frame itself is overwritten when the camera moves. */
export const copyFrame = ({ origin, eye, right, up, back }: ShadingFrame): ShadingFrame => ({
  origin,
  eye: [...eye],
  right: [...right],
  up: [...up],
  back: [...back],
});
