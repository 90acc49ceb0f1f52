// What a picture shows at one moment. Taken when shadeAt is called: its code may still have to be fetched, and the
// scene changes meanwhile. Keeps references to values that are replaced when they change, and copies of those that are
// overwritten.
import type { BufferAttribute, BufferGeometry, Material, Matrix4, Mesh, Object3D, PerspectiveCamera } from 'three';
import { smoothGeometry } from '../../material/flat-geometry.js';
import type { ShadingFrame } from '../../material/lighting.js';
import { PhongMaterial } from '../../material/phong-material.js';
import { sameValue } from '../../fields/field-store.js';
import { hasMovingVertices } from '../bounds.js';

/** How the Phong material shades an object. */
export type DrawnLook = Readonly<Pick<PhongMaterial, 'look' | 'sides' | 'surface' | 'style' | 'linear'>>;

/** A drawn object at the moment of the snapshot. */
export interface Drawn<Owner = unknown> {
  readonly object: Object3D;
  readonly matrixWorld: Matrix4;
  readonly geometry: BufferGeometry | undefined;
  readonly material: Material | Material[] | undefined;
  /**
   * The element that declares it; undefined for a page author's own objects and for other materials than the Phong one.
   */
  readonly owner: Owner | undefined;
  /** Null where `owner` is undefined. */
  readonly phong: DrawnLook | null;
}

export interface SceneSnapshot<Owner = unknown> {
  /** Device pixels. */
  readonly width: number;
  readonly height: number;
  readonly frame: ShadingFrame;
  readonly camera: PerspectiveCamera;
  /** In drawing order. */
  readonly objects: readonly Drawn<Owner>[];
}

/** The visible objects below `object`, by three.js's rules. World matrices must be up to date. */
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
    const phong = material instanceof PhongMaterial ? material : null;
    const owner = isMesh === true && phong !== null ? ownerOf(object) : undefined;
    // A view may show separate triangles where the shading is smooth.
    const shown = geometry !== undefined && phong?.style.shading !== 'flat' ? smoothGeometry(geometry) : geometry;
    into.push({
      object,
      matrixWorld: object.matrixWorld.clone(),
      geometry: shown !== undefined && owner !== undefined ? still(shown) : shown,
      material,
      owner,
      phong: owner === undefined || phong === null ? null : phongLook(phong),
    });
  }
  for (const child of object.children) drawnObjects(child, camera, ownerOf, into);
  return into;
}

/** The attributes that an animation changes. */
const MOVING = ['position', 'normal', 'tangent'] as const;

interface Copy {
  /** The attributes and their versions when they were copied. */
  readonly state: readonly unknown[];
  readonly geometry: BufferGeometry;
}

/** The latest copy of each animated geometry: a probe takes a snapshot for each move of the mouse. */
const copies = new WeakMap<BufferGeometry, Copy>();

/** A geometry whose vertices stay as they are: itself, or a copy of one that an animation changes. */
function still(geometry: BufferGeometry): BufferGeometry {
  if (!hasMovingVertices(geometry)) return geometry;
  const moving = MOVING.filter((name) => geometry.hasAttribute(name)).map(
    (name) => [name, geometry.getAttribute(name) as BufferAttribute] as const,
  );
  const state = moving.flatMap(([, attribute]) => [attribute, attribute.version]);
  const known = copies.get(geometry);
  if (sameValue(known?.state, state)) return known!.geometry;
  const Geometry = geometry.constructor as typeof BufferGeometry;
  const copy = new Geometry();
  copy.index = geometry.index;
  Object.assign(copy.attributes, geometry.attributes);
  for (const [name, attribute] of moving) copy.setAttribute(name, attribute.clone());
  copy.boundingBox = geometry.boundingBox?.clone() ?? null;
  copy.boundingSphere = geometry.boundingSphere?.clone() ?? null;
  copies.set(geometry, { state, geometry: copy });
  return copy;
}

const phongLook = ({ look, sides, surface, style, linear }: PhongMaterial): DrawnLook => {
  return { look, sides, surface, style, linear };
};

/** The frame itself is overwritten when the camera moves. */
export const copyFrame = ({ origin, eye, right, up, back }: ShadingFrame): ShadingFrame => ({
  origin,
  eye: [...eye],
  right: [...right],
  up: [...up],
  back: [...back],
});
