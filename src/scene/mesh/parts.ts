// Which three.js meshes show a content, with which geometries and surfaces? Knows neither loads nor frames.
import { type BufferGeometry, Group, Matrix4, Mesh, type Object3D } from 'three';
import type { FieldStore } from '../../fields/field-store.js';
import { flatGeometry, updateFlatGeometry } from '../../material/flat-geometry.js';
import type { SurfaceValues } from '../../material/material-values.js';
import type { BaseLook, PhongMaterial } from '../../material/phong-material.js';
import { radians } from '../../math/angle.js';
import type { Vec3 } from '../../math/vector.js';
import { hasMovingVertices } from '../bounds.js';
import { extremePointsOf, shareExtremePoints } from '../extreme-points.js';
import { VALUE_LIMIT } from '../model/limits.js';
import { ModelError } from '../model/model.js';
import type { MeshAnimation } from './animation.js';
import { type Content, type ContentPart, NOTHING } from './content.js';
import type { ShapeValues } from './mesh-fields.js';
import type { Appearance, SharedMaterials } from './shared-materials.js';

export interface Part {
  readonly mesh: Mesh;
  readonly source: ContentPart;
  material: PhongMaterial;
  look: BaseLook;
  surface: Readonly<SurfaceValues>;
}

/** Content in the scene. */
export interface Shown {
  readonly content: Content;
  readonly parts: readonly Part[];
  /** Null where there is nothing to show. */
  readonly root: Object3D | null;
  /** Where a model came from; null for a shape. */
  readonly url: URL | null;
  /** Null where nothing in it moves. */
  readonly animation: MeshAnimation | null;
}

export const EMPTY: Shown = { content: NOTHING, parts: [], root: null, url: null, animation: null };

/**
 * The geometries that show these parts, smooth or flat, and measured: all memory that showing them takes, but for the GPU's.
 * Throws if there is not enough.
 */
export function geometriesOf(parts: readonly ContentPart[], flat: boolean): BufferGeometry[] {
  if (flat) checkFlat(parts);
  return parts.map(({ geometry }) => {
    extremePointsOf(geometry);
    if (!flat) return geometry;
    const copy = flatGeometry(geometry);
    shareExtremePoints(geometry, copy);
    return copy;
  });
}

/** Flat shading gives every corner values of its own. They may be as many as those of a file. */
function checkFlat(parts: readonly ContentPart[]): void {
  let values = 0;
  for (const { attributes, index } of new Set(parts.map(({ geometry }) => geometry))) {
    const floats = Object.entries(attributes).map(([name, { itemSize }]) =>
      name === 'normal' ? 0 : itemSize,
    );
    const corners = index?.count ?? attributes['position']?.count ?? 0;
    values += corners * floats.reduce((sum, size) => sum + size, 3);
  }
  if (values > VALUE_LIMIT)
    throw new ModelError('too-large', 'The model has too many triangles for shading="flat".');
}

export function partsOf(
  content: Content,
  geometries: readonly BufferGeometry[],
  materials: SharedMaterials,
  appearanceOf: (source: ContentPart) => Appearance,
): Part[] {
  return content.parts.map((source, i) => {
    const appearance = appearanceOf(source);
    const material = materials.acquire(appearance);
    const mesh = new Mesh(geometries[i], material);
    mesh.name = source.name;
    mesh.matrixAutoUpdate = false;
    return { mesh, material, look: appearance.look, surface: appearance.surface, source };
  });
}

/** A part that its content does not move needs no group around it: 2,000 boxes are 2,000 objects. */
export function rootOf(parts: readonly Part[], moves: boolean): Object3D | null {
  const [first] = parts;
  if (first === undefined) return null;
  if (parts.length === 1 && !moves && first.source.matrix.equals(IDENTITY)) return first.mesh;
  const group = new Group();
  group.matrixAutoUpdate = false;
  for (const { mesh, source } of parts) {
    mesh.matrix.copy(source.matrix);
    group.add(mesh);
  }
  return group;
}

/** `rotation` in degrees. */
export function placeRoot(root: Object3D, position: Vec3, rotation: Vec3, scale: Vec3): void {
  root.position.set(...position);
  root.rotation.set(radians(rotation[0]), radians(rotation[1]), radians(rotation[2]));
  root.scale.set(...scale);
  root.updateMatrix();
}

/** Updates meshes to their content's current pose. */
export function followPose(parts: readonly Part[]): void {
  for (const { mesh, source } of parts) {
    mesh.matrix.copy(source.matrix);
    mesh.matrixWorldNeedsUpdate = true;
    if (mesh.geometry !== source.geometry && hasMovingVertices(source.geometry))
      updateFlatGeometry(source.geometry);
  }
}

const IDENTITY = /* @__PURE__ */ new Matrix4();

/** Attributes win, then the file's values, then the defaults. */
export function surfaceOf(state: FieldStore<ShapeValues>, { surface }: ContentPart): SurfaceValues {
  const { values } = state;
  const valueOf = <K extends keyof SurfaceValues>(key: K): SurfaceValues[K] =>
    (state.given(key) ? undefined : surface[key]) ?? values[key];
  return { ka: valueOf('ka'), kd: valueOf('kd'), ks: valueOf('ks'), shininess: valueOf('shininess') };
}

/** The file's look. An exponent that the author gives replaces the file's roughness. */
export function lookOf(state: FieldStore<ShapeValues>, { look }: ContentPart): BaseLook {
  if (look.roughness === null || !state.given('shininess')) return look;
  const known = smooth.get(look) ?? { ...look, roughness: null };
  smooth.set(look, known);
  return known;
}

/** Looks without their roughness: the same object each time, because materials are compared by it. */
const smooth = new WeakMap<BaseLook, BaseLook>();

export const sameSurface = (a: SurfaceValues, b: SurfaceValues): boolean =>
  a.ka === b.ka && a.kd === b.kd && a.ks === b.ks && a.shininess === b.shininess;
