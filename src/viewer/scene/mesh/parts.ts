// The three.js meshes that show a content, with their geometries and surfaces.
import { type BufferGeometry, Group, Mesh, type Object3D } from 'three';
import { flatGeometry, forgetFlatGeometry } from '../../../phong/material/flat-geometry.js';
import type { PhongMaterial } from '../../../phong/material/phong-material.js';
import { shareSize, sizeOf } from '../../../phong/geometry/geometry-size.js';
import type { Claim, Need } from '../../../phong/model/budget.js';
import type { Content, ContentPart } from '../../../phong/model/model.js';
import type { MeshState } from '../../../phong/model/mesh-fields.js';
import type { SharedMaterials } from './shared-materials.js';
import { appearanceOf } from '../../../phong/model/appearance.js';
import { IDENTITY, type ShapeContent } from './shared-shapes.js';

export interface Part {
  readonly mesh: Mesh;
  source: ContentPart;
  material: PhongMaterial;
}

/**
 * The measured geometries that show a content, smooth or flat. Allocates all memory that showing it
 * takes, except the GPU's. Throws if there is not enough, or if flat copies exceed the limit of
 * `claim`.
 */
export function geometriesOf(
  content: Content,
  flat: boolean,
  claim: Claim | null,
): BufferGeometry[] {
  if (flat) {
    claim?.add(flatNeedsOf(content));
  }
  return content.parts.map(({ geometry }) => {
    sizeOf(geometry);
    const shown = flat ? flatGeometry(geometry) : geometry;
    // three.js would send what a page added to Object.prototype.
    Object.setPrototypeOf(shown.attributes, null);
    if (flat) {
      shareSize(geometry, shown);
    }
    return shown;
  });
}

/** What flat copies of a content's geometries hold. */
const flatNeedsOf = (content: Content): readonly Need[] =>
  (content as Partial<ShapeContent>).needs ??
  [...new Set(content.parts.map(({ geometry }) => geometry))].map((geometry) => ({
    key: geometry,
    claims: { values: flatValues(geometry) },
    flat: true,
  }));

/** The values of a geometry's flat copy: every corner has its own, as floats. */
function flatValues({ attributes, index }: BufferGeometry): number {
  const sizes = Object.entries(attributes).map(([name, { itemSize }]) =>
    name === 'normal' ? 0 : itemSize,
  );
  const corners = index?.count ?? attributes['position']?.count ?? 0;
  return corners * sizes.reduce((sum, size) => sum + size, 3);
}

/**
 * Parts that show a flat copy, by the copy's source. The last one frees it: it takes more than
 * three times the source's memory.
 */
const flatUsers = new WeakMap<BufferGeometry, number>();

function countFlat({ mesh, source }: Pick<Part, 'mesh' | 'source'>, change: 1 | -1): void {
  const { geometry } = source;
  if (mesh.geometry === geometry) return;
  const users = (flatUsers.get(geometry) ?? 0) + change;
  flatUsers.set(geometry, users);
  if (users === 0) {
    forgetFlatGeometry(geometry);
  }
}

/** Shows a content by these geometries, as {@link geometriesOf} gave them. */
export function setGeometries(
  parts: readonly Part[],
  content: Content,
  geometries: readonly BufferGeometry[],
): void {
  parts.forEach((part, i) => {
    const geometry = geometries[i]!;
    if (part.mesh.geometry === geometry) return;
    countFlat(part, -1);
    part.source = content.parts[i]!;
    part.mesh.geometry = geometry;
    countFlat(part, 1);
  });
}

export function releaseParts(parts: readonly Part[], materials: SharedMaterials): void {
  for (const part of parts) {
    materials.release(part.material);
    countFlat(part, -1);
  }
}

/** Throws if there is no memory for them, and keeps no material then. */
export function partsOf(
  content: Content,
  geometries: readonly BufferGeometry[],
  materials: SharedMaterials,
  state: MeshState,
): Part[] {
  const parts: Part[] = [];
  try {
    content.parts.forEach((source, i) => {
      const mesh = new Mesh(geometries[i], materials.acquire(appearanceOf(state, source)));
      mesh.name = source.name;
      mesh.matrixAutoUpdate = false;
      countFlat({ mesh, source }, 1);
      parts.push({ mesh, material: mesh.material, source });
    });
    return parts;
  } catch (error) {
    releaseParts(parts, materials);
    throw error;
  }
}

/**
 * A part that its content does not move needs no group around it: 2,000 boxes are 2,000 objects.
 */
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
