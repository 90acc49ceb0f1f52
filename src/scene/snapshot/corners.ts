// The corners of a triangle that was hit, as the vertex shader computes them: places and unit normals in shading space,
// in float64.
import { Matrix3, Vector3 } from 'three';
import { normalMatrix } from '../../material/normal-matrix.js';
import { normalize, scale, type Vec3, type Vec4 } from '../../math/vector.js';
import type { Hit } from './pick.js';

/** A corner in shading space. */
export interface Corner {
  /** Place relative to the frame's origin. */
  readonly p: Vec3;
  /** Unit length, or zero; flipped on back faces. */
  readonly N: Vec3;
  /** Unit, along the u of a normal map; w is the side of its v. Null where the geometry has none. Not flipped. */
  readonly tangent: Vec4 | null;
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
  const tangents = geometry.hasAttribute('tangent') ? geometry.getAttribute('tangent') : null;
  const sign = toShading.determinant() < 0 ? -1 : 1;
  const linear = new Matrix3().setFromMatrix4(toShading);
  const tangentOf = (vertex: number): Vec4 | null => {
    if (tangents === null) return null;
    const T = new Vector3().fromBufferAttribute(tangents, vertex).applyMatrix3(linear);
    return [...normalize(T.toArray()), sign * tangents.getW(vertex)];
  };
  const corner = (vertex: number): Corner => {
    const p = new Vector3().fromBufferAttribute(place, vertex).applyMatrix4(toShading);
    const N = new Vector3();
    if (normal !== null) N.fromBufferAttribute(normal, vertex).applyMatrix3(turn);
    return { p: p.toArray(), N: scale(normalize(N.toArray()), front ? 1 : -1), tangent: tangentOf(vertex) };
  };
  return [corner(corners[0]), corner(corners[1]), corner(corners[2])];
}
