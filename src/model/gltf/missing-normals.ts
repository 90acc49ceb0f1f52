// Normals of a file that have no direction (zero or no number) are computed anew, from the faces around their vertices.
import type { BufferAttribute } from 'three';
import type { Slices } from '../slices.js';

/** How many vectors have no direction. */
export async function countMissing({ array, count }: BufferAttribute, slices: Slices): Promise<number> {
  let missing = 0;
  await slices.over(count, (from, to) => {
    for (let i = from; i < to; i += 1) if (isMissing(array, i)) missing += 1;
  });
  return missing;
}

interface CompletedNormals {
  readonly normals: BufferAttribute;
  /** Where a corner's normal would not be within 90° of its face's own, 1: it takes that one. Null if all are. */
  readonly split: Uint8Array | null;
}

/** Replaces missing normals by the mean of the faces around the vertex, weighted by area. Computed in float64. */
export async function completeNormals(
  positions: ArrayLike<number>,
  source: BufferAttribute,
  corners: ArrayLike<number> | null,
  slices: Slices,
): Promise<CompletedNormals> {
  const count = corners?.length ?? Math.floor(positions.length / 9) * 3;
  const sums = new Float64Array(source.count * 3);
  const normals = source.clone();
  const face = new Float64Array(3);
  const vertexOf = (corner: number): number => corners?.[corner] ?? corner;
  const readFace = (corner: number): void =>
    writeFace(face, positions, vertexOf(corner), vertexOf(corner + 1), vertexOf(corner + 2));
  await slices.over(count, (from, to) => {
    for (let first = from; first < to; first += 3) {
      readFace(first);
      for (let corner = first; corner < first + 3; corner += 1)
        for (let c = 0; c < 3; c += 1) sums[vertexOf(corner) * 3 + c]! += face[c]!;
    }
  });
  await slices.over(source.count, (from, to) => {
    for (let i = from; i < to; i += 1) {
      if (!isMissing(source.array, i)) continue;
      const [x, y, z] = [sums[i * 3]!, sums[i * 3 + 1]!, sums[i * 3 + 2]!];
      const length = Math.hypot(x, y, z);
      if (length > 0) normals.setXYZ(i, x / length, y / length, z / length);
    }
  });
  const split = new Uint8Array(count);
  await slices.over(count, (from, to) => {
    for (let first = from; first < to; first += 3) {
      readFace(first);
      const hasArea = face.some((c) => c !== 0);
      for (let corner = first; corner < first + 3; corner += 1) {
        const at = vertexOf(corner) * 3;
        if (!hasArea || !isMissing(source.array, at / 3)) continue;
        if (face[0]! * sums[at]! + face[1]! * sums[at + 1]! + face[2]! * sums[at + 2]! > 0) continue;
        split[corner] = 1;
      }
    }
  });
  return { normals, split: split.includes(1) ? split : null };
}

const isMissing = (array: ArrayLike<number>, i: number): boolean =>
  array[i * 3] === 0 && array[i * 3 + 1] === 0 && array[i * 3 + 2] === 0;

/** A triangle's normal, as long as twice its area. */
function writeFace(face: Float64Array, positions: ArrayLike<number>, a: number, b: number, c: number): void {
  const [x, y, z] = [positions[a * 3]!, positions[a * 3 + 1]!, positions[a * 3 + 2]!];
  const [ux, uy, uz] = [positions[b * 3]! - x, positions[b * 3 + 1]! - y, positions[b * 3 + 2]! - z];
  const [vx, vy, vz] = [positions[c * 3]! - x, positions[c * 3 + 1]! - y, positions[c * 3 + 2]! - z];
  face[0] = uy * vz - uz * vy;
  face[1] = uz * vx - ux * vz;
  face[2] = ux * vy - uy * vx;
}
