// Normals and tangents that a file lacks: corners whose normal is zero take their face's.
import { BufferAttribute, type BufferGeometry, type Texture, type TypedArray } from 'three';
import { writeFaceNormals } from '../../../phong/material/flat-geometry.js';
import { isZero } from '../model-reader.js';
import type { Slices } from '../slices.js';
import { uvNameOf } from './materials.js';

/**
 * `some`: a corner has a normal with a direction. `all`: so has every corner, but for those of
 * triangles without area, which can have none.
 * @param corners null where each vertex is one.
 */
export async function findNormals(
  normals: ArrayLike<number>,
  positions: ArrayLike<number>,
  corners: ArrayLike<number> | null,
  total: number,
  slices: Slices,
) {
  let [some, all] = [false, true];
  const vertexOf = (corner: number) => (corners === null ? corner : corners[corner]!);
  const [face, normal] = [new Float32Array(9), new Float32Array(9)];
  await slices.over(total, (from, to) => {
    for (let i = from; i < to; i += 1) {
      if (!isZero(normals, 3 * vertexOf(i))) {
        some = true;
      } else if (all) {
        const first = i - (i % 3);
        for (let k = 0; k < 9; k += 1) {
          face[k] = positions[3 * vertexOf(first + Math.floor(k / 3)) + (k % 3)]!;
        }
        writeFaceNormals(face, normal, 0, 1);
        all = isZero(normal, 0);
      }
    }
  });
  return { some, all: some && all };
}

/**
 * Replaces the normals of faces, a normal for each corner, by those of the file where these have a
 * direction.
 */
export async function takeFileNormals(
  normals: ArrayLike<number>,
  ofFaces: TypedArray,
  slices: Slices,
): Promise<void> {
  await slices.over(ofFaces.length / 3, (from, to) => {
    for (let i = from; i < to; i += 1) {
      if (isZero(normals, 3 * i)) continue;
      for (let k = 3 * i; k < 3 * i + 3; k += 1) {
        ofFaces[k] = normals[k]!;
      }
    }
  });
}

/**
 * Adds the attribute `tangent`, computed from the map's texture coordinates as its transform leaves
 * them (Lengyel, "Computing Tangent Space Basis Vectors for an Arbitrary Mesh"): along growing u.
 * Its w says that N × T · w points up the image, as a normal map's green does: against growing v,
 * because glTF's v runs down the image. The map's matrix must be up to date.
 */
export async function addTangents(
  geometry: BufferGeometry,
  normalMap: Texture,
  slices: Slices,
): Promise<void> {
  const [uu, uv, , vu, vv] = normalMap.matrix.elements;
  const side = Math.sign(uu * vv - uv * vu);
  const positions = geometry.getAttribute('position').array;
  const normals = geometry.getAttribute('normal').array;
  const uvs = geometry.getAttribute(uvNameOf(normalMap)).array;
  const { index } = geometry;
  const { count } = geometry.getAttribute('position');
  // Directions of growing u and v, summed over the triangles of each vertex.
  const alongU = new Float64Array(3 * count);
  const alongV = new Float64Array(3 * count);
  await slices.over(index?.count ?? count, (from, to) => {
    for (let i = from; i < to; i += 3) {
      const [a, b, c] = index
        ? [index.getX(i), index.getX(i + 1), index.getX(i + 2)]
        : [i, i + 1, i + 2];
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
  /** Along the transformed u or v: the inverse of the transform, whose size does not matter. */
  const sum = (at: number, u: number, v: number) => side * (u * alongU[at]! + v * alongV[at]!);
  await slices.over(count, (from, to) => {
    for (let i = from; i < to; i += 1) {
      const [x0, y0, z0] = [3 * i, 3 * i + 1, 3 * i + 2];
      const [nx, ny, nz] = [normals[x0]!, normals[y0]!, normals[z0]!];
      const [ux, uy, uz] = [sum(x0, vv, -uv), sum(y0, vv, -uv), sum(z0, vv, -uv)];
      const along = nx * ux + ny * uy + nz * uz;
      const [x, y, z] = [ux - nx * along, uy - ny * along, uz - nz * along];
      const [vx, vy, vz] = [sum(x0, -vu, uu), sum(y0, -vu, uu), sum(z0, -vu, uu)];
      const length = Math.sqrt(x * x + y * y + z * z);
      if (length > 0 && length < Infinity) {
        values.set([x / length, y / length, z / length], 4 * i);
      }
      const down = (ny * uz - nz * uy) * vx + (nz * ux - nx * uz) * vy + (nx * uy - ny * ux) * vz;
      values[4 * i + 3] = down > 0 ? -1 : 1;
    }
  });
  geometry.setAttribute('tangent', new BufferAttribute(values, 4));
}
