// Normals and tangents that a file lacks: normals without direction (zero or no number) from the faces around their
// vertices, tangents from texture coordinates.
import { BufferAttribute, type BufferGeometry } from 'three';
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

/**
 * Adds the attribute `tangent` to `geometry`, computed from its texture coordinates `uv` (Lengyel, "Computing Tangent
 * Space Basis Vectors for an Arbitrary Mesh"). A tangent points along
 * growing u. Its w says that N × T · w points up the image, as a normal map's green does: against growing v, because
 * glTF's v runs down the image.
 */
export async function addTangents(geometry: BufferGeometry, uv: string, slices: Slices): Promise<void> {
  const positions = geometry.getAttribute('position').array;
  const normals = geometry.getAttribute('normal').array;
  const uvs = geometry.getAttribute(uv).array;
  const { index } = geometry;
  const { count } = geometry.getAttribute('position');
  // Directions of growing u and v, summed over the triangles of each vertex.
  const alongU = new Float64Array(3 * count);
  const alongV = new Float64Array(3 * count);
  await slices.over(index?.count ?? count, (from, to) => {
    for (let i = from; i < to; i += 3) {
      const [a, b, c] = index ? [index.getX(i), index.getX(i + 1), index.getX(i + 2)] : [i, i + 1, i + 2];
      const ub = uvs[2 * b]! - uvs[2 * a]!;
      const vb = uvs[2 * b + 1]! - uvs[2 * a + 1]!;
      const uc = uvs[2 * c]! - uvs[2 * a]!;
      const vc = uvs[2 * c + 1]! - uvs[2 * a + 1]!;
      const scale = 1 / (ub * vc - uc * vb);
      if (!Number.isFinite(scale)) continue; // its texture coordinates lie on a line
      for (let k = 0; k < 3; k += 1) {
        const pb = positions[3 * b + k]! - positions[3 * a + k]!;
        const pc = positions[3 * c + k]! - positions[3 * a + k]!;
        const u = (pb * vc - pc * vb) * scale;
        const v = (pc * ub - pb * uc) * scale;
        for (const vertex of [a, b, c]) {
          alongU[3 * vertex + k]! += u;
          alongV[3 * vertex + k]! += v;
        }
      }
    }
  });
  const values = new Float32Array(4 * count);
  await slices.over(count, (from, to) => {
    for (let i = from; i < to; i += 1) {
      const [nx, ny, nz] = [normals[3 * i]!, normals[3 * i + 1]!, normals[3 * i + 2]!];
      const [ux, uy, uz] = [alongU[3 * i]!, alongU[3 * i + 1]!, alongU[3 * i + 2]!];
      const along = nx * ux + ny * uy + nz * uz;
      const [x, y, z] = [ux - nx * along, uy - ny * along, uz - nz * along];
      const [vx, vy, vz] = [alongV[3 * i]!, alongV[3 * i + 1]!, alongV[3 * i + 2]!];
      const length = Math.hypot(x, y, z);
      if (length > 0 && length < Infinity) values.set([x / length, y / length, z / length], 4 * i);
      const down = (ny * uz - nz * uy) * vx + (nz * ux - nx * uz) * vy + (nx * uy - ny * ux) * vz;
      values[4 * i + 3] = down > 0 ? -1 : 1;
    }
  });
  geometry.setAttribute('tangent', new BufferAttribute(values, 4));
}
