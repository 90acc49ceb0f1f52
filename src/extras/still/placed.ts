// Shapes where the rays see them: from the eye, along the world's axes.
import { add, cross, dot, scale, subtract, type Vec3 } from '../../phong/math/vector.js';
import type { CastShape } from './cast-scene.js';

export interface PlacedTriangles {
  readonly places: Float64Array;
  /** World space; unit, or zero. */
  readonly normals: Float64Array;
  /** Unit, or zero; none where the shape has none. */
  readonly tangents: Float64Array;
  readonly mirrored: boolean;
  readonly index: ArrayLike<number> | undefined;
}

/** The columns of a 4×4 matrix. */
export interface Vec3Matrix {
  readonly x: Vec3;
  readonly y: Vec3;
  readonly z: Vec3;
  readonly origin: Vec3;
}

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** A triangle's corners relative to the eye. */
export function cornersOf(
  { places, index }: PlacedTriangles,
  triangle: number,
): [Vec3, Vec3, Vec3] {
  const corner = (i: number): Vec3 => vectorAt(places, 3 * (index === undefined ? i : index[i]!));
  return [corner(3 * triangle), corner(3 * triangle + 1), corner(3 * triangle + 2)];
}

/** How many triangles. */
export const countOf = ({ index, positions }: CastShape): number =>
  (index?.length ?? positions.length / 3) / 3;

export function placed(
  { positions, normals, tangents = [], index }: CastShape,
  m: ArrayLike<number> | undefined,
  eye: Vec3,
): PlacedTriangles {
  const matrix = columnsOf(m);
  const { x, y, z } = matrix;
  const origin = subtract(matrix.origin, eye);
  const cofactors = { x: cross(y, z), y: cross(z, x), z: cross(x, y), origin };
  const mirrored = dot(x, cofactors.x) < 0;
  return {
    places: eachOf(positions, 3, (v) => add(origin, turned(matrix, v))),
    normals: eachOf(normals, 3, (v) => unit(turned(cofactors, v), mirrored ? -1 : 1)),
    tangents: eachOf(tangents, 4, (v) => unit(turned(matrix, v))),
    mirrored,
    index,
  };
}

export const vectorAt = (list: ArrayLike<number>, i: number): Vec3 => [
  list[i]!,
  list[i + 1]!,
  list[i + 2]!,
];

/** `of` the first three of every `size` numbers. */
function eachOf(list: ArrayLike<number>, size: number, of: (v: Vec3) => Vec3): Float64Array {
  const out = new Float64Array((3 * list.length) / size);
  for (let i = 0; 3 * i < out.length; i++) {
    out.set(of(vectorAt(list, size * i)), 3 * i);
  }
  return out;
}

/** A direction through a matrix. */
export const turned = ({ x, y, z }: Vec3Matrix, v: Vec3): Vec3 => [
  x[0] * v[0] + y[0] * v[1] + z[0] * v[2],
  x[1] * v[0] + y[1] * v[1] + z[1] * v[2],
  x[2] * v[0] + y[2] * v[1] + z[2] * v[2],
];

/** The unit vector, times `side`. Zero stays zero. */
export function unit(v: Vec3, side = 1): Vec3 {
  // Components up to 1e24 and down to 1e-60: the squares neither overflow nor vanish.
  const far = Math.sqrt(dot(v, v));
  return scale(v, far > 0 ? side / far : 0);
}

export function columnsOf(m: ArrayLike<number> = IDENTITY): Vec3Matrix {
  const [x, y, z, origin] = [0, 4, 8, 12].map((i) => vectorAt(m, i)) as [Vec3, Vec3, Vec3, Vec3];
  return { x, y, z, origin };
}
