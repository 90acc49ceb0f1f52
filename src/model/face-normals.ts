// The normal of each triangle, for files without normals. In slices, as millions of triangles take seconds. Positions
// and normals are in the same space.
import { BufferAttribute } from 'three';
import type { Slices } from './slices.js';

/**
 * The unit normal of every triangle, three times each: counter-clockwise is outside. Computed in float64. A triangle
 * without area gets zero, which shades as ambient only.
 * @param positions x, y, z of the corners, three corners per triangle.
 */
export async function faceNormals(positions: ArrayLike<number>, slices: Slices): Promise<BufferAttribute> {
  const normals = new Float32Array(positions.length);
  await slices.over(positions.length / 9, (from, to) => writeFaceNormals(positions, normals, from, to));
  return new BufferAttribute(normals, 3);
}

/** As {@link faceNormals}, for the triangles from `from` to before `to`, into `normals`. */
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
    const size = Math.hypot(x, y, z);
    for (let corner = at; corner < at + 9; corner += 3) {
      normals[corner] = size > 0 ? x / size : 0;
      normals[corner + 1] = size > 0 ? y / size : 0;
      normals[corner + 2] = size > 0 ? z / size : 0;
    }
  }
}
