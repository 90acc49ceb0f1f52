// A geometry's triangles with a normal of their own each, for flat shading without derivatives in the shader.
// Positions stay as they are, in the geometry's own space. Made once a source, and freed with it.
import { BufferAttribute, BufferGeometry, type InterleavedBufferAttribute } from 'three';

const made = new WeakMap<BufferGeometry, BufferGeometry>();
const sources = new WeakMap<BufferGeometry, BufferGeometry>();

/** What {@link flatGeometry} made this geometry from; the geometry itself if it is no such copy. */
export const smoothGeometry = (geometry: BufferGeometry): BufferGeometry => sources.get(geometry) ?? geometry;

/**
 * A non-indexed copy of `source` in which the three vertices of a triangle carry that triangle's unit normal, turned
 * by the winding (counter-clockwise is outside) and computed in float64. A triangle without area gets a zero normal,
 * which shades as ambient only. Other attributes are kept, normalised integers as the floats they stand for. Cached
 * by source; disposing of the source disposes of the copy.
 */
export function flatGeometry(source: BufferGeometry): BufferGeometry {
  const present = made.get(source);
  if (present) return present;
  const flat = separateTriangles(source);
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

/** Call when positions, tangents and bounds of `source` have changed: updates its flat copy, if there is one. */
export function updateFlatGeometry(source: BufferGeometry): void {
  const flat = made.get(source);
  if (!flat) return;
  const position = flat.getAttribute('position') as BufferAttribute;
  const count = position.count;
  for (const name of ['position', 'tangent']) {
    if (!source.hasAttribute(name)) continue;
    const copy = flat.getAttribute(name) as BufferAttribute;
    copy.array.set(gather(source.getAttribute(name), source.index, count));
    copy.needsUpdate = true;
  }
  const normal = flat.getAttribute('normal') as BufferAttribute;
  normal.array.set(faceNormals(position.array as Float32Array));
  normal.needsUpdate = true;
  flat.boundingBox = source.boundingBox;
  flat.boundingSphere = source.boundingSphere;
}

function separateTriangles(source: BufferGeometry): BufferGeometry {
  const { index } = source;
  const corners = index?.count ?? source.getAttribute('position').count;
  const count = corners - (corners % 3);
  const flat = new BufferGeometry();
  flat.name = source.name;
  for (const [name, attribute] of Object.entries(source.attributes)) {
    if (name === 'normal') continue;
    const values = gather(attribute, index, count);
    const copy = new BufferAttribute(values, attribute.itemSize);
    if ('isBufferAttribute' in attribute) copy.setUsage(attribute.usage);
    flat.setAttribute(name, copy);
    if (name === 'position') flat.setAttribute('normal', new BufferAttribute(faceNormals(values), 3));
  }
  return flat;
}

type Attribute = BufferAttribute | InterleavedBufferAttribute;

/** The values of each corner. Plain floats are copied without a call for each: 15 million corners would take 2 s. */
function gather(attribute: Attribute, index: BufferAttribute | null, count: number): Float32Array {
  const { itemSize, array } = attribute;
  const values = new Float32Array(count * itemSize);
  const plain = 'isBufferAttribute' in attribute && array instanceof Float32Array;
  for (let c = 0; c < itemSize; c += 1) {
    for (let i = 0, at = c; i < count; i += 1, at += itemSize) {
      const vertex = index === null ? i : index.array[i]!;
      values[at] = plain ? array[vertex * itemSize + c]! : attribute.getComponent(vertex, c);
    }
  }
  return values;
}

/** In float64. Products of four float32 numbers neither overflow nor vanish there, so plain lengths do. */
function faceNormals(corners: Float32Array): Float32Array {
  const normals = new Float32Array(corners.length);
  for (let i = 0; i < corners.length; i += 9) {
    const ax = corners[i]!;
    const ay = corners[i + 1]!;
    const az = corners[i + 2]!;
    const ux = corners[i + 3]! - ax;
    const uy = corners[i + 4]! - ay;
    const uz = corners[i + 5]! - az;
    const vx = corners[i + 6]! - ax;
    const vy = corners[i + 7]! - ay;
    const vz = corners[i + 8]! - az;
    const x = uy * vz - uz * vy;
    const y = uz * vx - ux * vz;
    const z = ux * vy - uy * vx;
    const size = Math.sqrt(x * x + y * y + z * z);
    if (!(size > 0)) continue;
    for (let corner = i; corner < i + 9; corner += 3) {
      normals[corner] = x / size;
      normals[corner + 1] = y / size;
      normals[corner + 2] = z / size;
    }
  }
  return normals;
}
