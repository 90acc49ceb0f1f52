// The normal of each triangle, for files without normals. In slices, as millions of triangles take seconds. Positions
// and normals are in the same space.
import { BufferAttribute } from 'three';
import { writeFaceNormals } from '../material/flat-geometry.js';
import type { Slices } from './slices.js';

/** As {@link writeFaceNormals}, for all triangles of `positions`. */
export async function faceNormals(positions: ArrayLike<number>, slices: Slices): Promise<BufferAttribute> {
  const normals = new Float32Array(positions.length);
  await slices.over(positions.length / 9, (from, to) => writeFaceNormals(positions, normals, from, to));
  return new BufferAttribute(normals, 3);
}
