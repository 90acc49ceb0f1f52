// A geometry's triangles with a normal of their own each, for flat shading without derivatives in
// the shader. Positions stay as they are, in the geometry's own space. Made once a source, and
// freed with it.
import { BufferAttribute, BufferGeometry } from 'three';

const made = new WeakMap<BufferGeometry, BufferGeometry>();
const sources = new WeakMap<BufferGeometry, BufferGeometry>();

/** What {@link flatGeometry} made this geometry from; the geometry itself if it is no such copy. */
export const smoothGeometry = (geometry: BufferGeometry): BufferGeometry =>
  sources.get(geometry) ?? geometry;

/**
 * A non-indexed copy of `source` in which the three vertices of a triangle carry that triangle's
 * unit normal, turned by the winding (counter-clockwise is outside) and computed in float64. A
 * triangle without area gets a zero normal, which shades as ambient only. Other attributes are
 * kept. Cached by source; disposing of the source disposes of the copy.
 */
export function flatGeometry(source: BufferGeometry): BufferGeometry {
  const present = made.get(source);
  if (present) return present;
  const flat = separateTriangles(source, Object.keys(source.attributes));
  flat.name = source.name;
  made.set(source, flat);
  sources.set(flat, source);
  // It stays the source's copy: a source disposed of may be drawn again, and so may its copy.
  source.addEventListener('dispose', disposeFlat);
  return flat;
}

/** Frees the copy of `source`, if there is one, which nothing may show any more. */
export function forgetFlatGeometry(source: BufferGeometry): void {
  disposeFlat({ target: source });
  source.removeEventListener('dispose', disposeFlat);
  made.delete(source);
}

function disposeFlat({ target }: { readonly target: BufferGeometry }): void {
  made.get(target)?.dispose();
}

/** The attributes of these names, with three vertices a triangle, and its unit normal at each. */
export function separateTriangles(
  { attributes, index }: BufferGeometry,
  names: readonly string[],
): BufferGeometry {
  const corners = new BufferGeometry();
  // three.js would separate what a page added to Object.prototype.
  Object.setPrototypeOf(corners.attributes, null);
  Object.setPrototypeOf(corners.morphAttributes, null);
  for (const name of names) {
    if (name !== 'normal' && name in attributes) {
      corners.setAttribute(name, attributes[name]!);
    }
  }
  const { count } = corners.getAttribute('position');
  const inOrder = (): Uint32Array => new Uint32Array(count).map((_, i) => i);
  corners.index = index ?? new BufferAttribute(inOrder(), 1);
  const flat = corners.toNonIndexed();
  for (const [name, attribute] of Object.entries(flat.attributes)) {
    const { usage } = attributes[name] as Partial<BufferAttribute>;
    if (usage !== undefined) {
      (attribute as BufferAttribute).setUsage(usage);
    }
  }
  const positions = flat.getAttribute('position').array;
  const normals = new Float32Array(positions.length);
  writeFaceNormals(positions, normals, 0, Math.floor(positions.length / 9));
  // Another version may list the corners in another order: see extras/models/mesh-animation.ts.
  flat.userData['order'] = index?.version;
  return flat.setAttribute('normal', new BufferAttribute(normals, 3));
}

/**
 * Writes the unit normal of triangles `from` to `to` (excluded), three times each, as {@link
 * flatGeometry} says.
 */
export function writeFaceNormals(
  positions: ArrayLike<number>,
  normals: Float32Array,
  from: number,
  to: number,
): void {
  for (let at = from * 9; at < to * 9; at += 9) {
    const ux = positions[at + 3]! - positions[at]!;
    const uy = positions[at + 4]! - positions[at + 1]!;
    const uz = positions[at + 5]! - positions[at + 2]!;
    const vx = positions[at + 6]! - positions[at]!;
    const vy = positions[at + 7]! - positions[at + 1]!;
    const vz = positions[at + 8]! - positions[at + 2]!;
    const x = uy * vz - uz * vy;
    const y = uz * vx - ux * vz;
    const z = ux * vy - uy * vx;
    const size = Math.sqrt(x * x + y * y + z * z);
    for (let corner = at; corner < at + 9; corner += 3) {
      normals[corner] = size > 0 ? x / size : 0;
      normals[corner + 1] = size > 0 ? y / size : 0;
      normals[corner + 2] = size > 0 ? z / size : 0;
    }
  }
}
