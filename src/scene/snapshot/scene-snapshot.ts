// What a picture shows at one moment, kept for whoever looks into it later: its code is fetched with the first look, and
// the scene goes on meanwhile. Holds on to what is replaced when it changes and copies what is written to.
import type { BufferGeometry, Material, Matrix4, Mesh, Object3D, PerspectiveCamera } from 'three';
import type { ShadingFrame } from '../../material/lighting.js';
import { type BaseLook, PhongMaterial, type ShadingStyle } from '../../material/phong-material.js';
import type { SurfaceValues } from '../../material/material-values.js';

/** How the Phong material shades. */
export interface DrawnLook {
  readonly look: BaseLook;
  readonly surface: Readonly<SurfaceValues>;
  readonly style: ShadingStyle;
  readonly linear: boolean;
}

/** An object that is drawn, as it is now. */
export interface Drawn<Owner = unknown> {
  readonly object: Object3D;
  readonly matrixWorld: Matrix4;
  readonly geometry: BufferGeometry | undefined;
  readonly material: Material | Material[] | undefined;
  /** Whose it is; undefined where it is none of ours or has another material than the Phong one. */
  readonly owner: Owner | undefined;
  /** Null without an owner. */
  readonly phong: DrawnLook | null;
}

export interface SceneSnapshot<Owner = unknown> {
  /** Device pixels. */
  readonly width: number;
  readonly height: number;
  readonly frame: ShadingFrame;
  readonly camera: PerspectiveCamera;
  /** In the order of the tree. */
  readonly objects: readonly Drawn<Owner>[];
}

/** By three.js's own rules of what is drawn. World matrices must be up to date. */
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
    into.push({
      object,
      matrixWorld: object.matrixWorld.clone(),
      geometry,
      material,
      owner,
      phong: owner === undefined || phong === null ? null : phongLook(phong),
    });
  }
  for (const child of object.children) drawnObjects(child, camera, ownerOf, into);
  return into;
}

const phongLook = ({ look, surface, style, linear }: PhongMaterial): DrawnLook => ({
  look,
  surface,
  style,
  linear,
});

/** A copy: the frame itself goes on with the camera. */
export const frameNow = ({ origin, eye, right, up, back }: ShadingFrame): ShadingFrame => ({
  origin,
  eye: [...eye],
  right: [...right],
  up: [...up],
  back: [...back],
});
