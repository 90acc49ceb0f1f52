// The corners of a triangle that was hit, as the vertex shader computes them: places and unit normals in shading space, in
// float64. Knows neither materials nor lights.
import { Matrix3, Vector3 } from 'three';
import { normalMatrix } from '../../material/normal-matrix.js';
import { normalize, scale, type Vec3 } from '../../math/vector.js';
import type { Hit } from './pick.js';

/** A corner in shading space. */
export interface Corner {
  /** Place relative to the frame's origin. */
  readonly p: Vec3;
  /** Unit length, or zero; flipped on back faces. */
  readonly N: Vec3;
}

export function cornersOf({ drawn, corners, front, frame }: Hit): readonly [Corner, Corner, Corner] {
  const { geometry, matrixWorld } = drawn;
  const toShading = matrixWorld.clone();
  const e = toShading.elements;
  for (let i = 0; i < 3; i++) e[12 + i]! -= frame.origin[i]!;
  const turn = new Matrix3();
  normalMatrix(toShading, turn);
  const place = geometry.getAttribute('position');
  const normal = geometry.hasAttribute('normal') ? geometry.getAttribute('normal') : null;
  const corner = (vertex: number): Corner => {
    const p = new Vector3().fromBufferAttribute(place, vertex).applyMatrix4(toShading);
    const N = new Vector3();
    if (normal !== null) N.fromBufferAttribute(normal, vertex).applyMatrix3(turn);
    return { p: p.toArray(), N: scale(normalize(N.toArray()), front ? 1 : -1) };
  };
  return [corner(corners[0]), corner(corners[1]), corner(corners[2])];
}
