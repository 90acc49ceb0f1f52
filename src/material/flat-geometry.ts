// A geometry's triangles with a normal of their own each, for flat shading without derivatives in the shader.
// Positions stay as they are, in the geometry's own space. Made once a source, and freed with it.
import { BufferAttribute, BufferGeometry, type InterleavedBufferAttribute } from 'three';

const made = new WeakMap<BufferGeometry, BufferGeometry>();

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
  // It stays the source's copy: a source disposed of may be drawn again, and so may its copy.
  source.addEventListener('dispose', () => {
    flat.dispose();
  });
  return flat;
}

function separateTriangles(source: BufferGeometry): BufferGeometry {
  const { index } = source;
  const position = source.getAttribute('position');
  const corners = index ? index.count : position.count;
  const count = corners - (corners % 3);
  const vertexAt = index ? (i: number): number => index.getX(i) : (i: number): number => i;
  const flat = new BufferGeometry();
  flat.name = source.name;
  for (const [name, attribute] of Object.entries(source.attributes)) {
    if (name !== 'normal') flat.setAttribute(name, gather(attribute, vertexAt, count));
  }
  flat.setAttribute('normal', new BufferAttribute(faceNormals(position, vertexAt, count), 3));
  return flat;
}

type Attribute = BufferAttribute | InterleavedBufferAttribute;

function gather(attribute: Attribute, vertexAt: (i: number) => number, count: number): BufferAttribute {
  const { itemSize } = attribute;
  const values = new Float32Array(count * itemSize);
  for (let i = 0; i < count; i += 1) {
    const vertex = vertexAt(i);
    for (let c = 0; c < itemSize; c += 1) values[i * itemSize + c] = attribute.getComponent(vertex, c);
  }
  return new BufferAttribute(values, itemSize);
}

function faceNormals(position: Attribute, vertexAt: (i: number) => number, count: number): Float32Array {
  const normals = new Float32Array(count * 3);
  for (let i = 0; i < count; i += 3) {
    const a = vertexAt(i);
    const b = vertexAt(i + 1);
    const c = vertexAt(i + 2);
    const ax = position.getX(a);
    const ay = position.getY(a);
    const az = position.getZ(a);
    const ux = position.getX(b) - ax;
    const uy = position.getY(b) - ay;
    const uz = position.getZ(b) - az;
    const vx = position.getX(c) - ax;
    const vy = position.getY(c) - ay;
    const vz = position.getZ(c) - az;
    const x = uy * vz - uz * vy;
    const y = uz * vx - ux * vz;
    const z = ux * vy - uy * vx;
    const size = Math.hypot(x, y, z);
    if (!(size > 0)) continue;
    for (let corner = i * 3; corner < i * 3 + 9; corner += 3) {
      normals[corner] = x / size;
      normals[corner + 1] = y / size;
      normals[corner + 2] = z / size;
    }
  }
  return normals;
}
