// What is the normal of each triangle, for files without normals? In slices, as millions of triangles take seconds. Positions and normals are
// in the same space. Knows no format.
import { BufferAttribute } from 'three';
import type { Slices } from './slices.js';

/**
 * The unit normal of every triangle, three times each: counter-clockwise is outside. Computed in float64. A triangle without area gets
 * zero, which shades as ambient only.
 * @param positions x, y, z of the corners, three corners per triangle.
 */
export async function faceNormals(positions: ArrayLike<number>, slices: Slices): Promise<BufferAttribute> {
  const normals = new Float32Array(positions.length);
  await slices.over(positions.length / 9, (from, to) => {
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
      if (!(size > 0)) continue;
      for (let corner = at; corner < at + 9; corner += 3) {
        normals[corner] = x / size;
        normals[corner + 1] = y / size;
        normals[corner + 2] = z / size;
      }
    }
  });
  return new BufferAttribute(normals, 3);
}
