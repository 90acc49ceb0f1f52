// A shape where the rays see it: from the eye, along the world's axes. Vertices are placed when they
// are asked for, so that a thousand meshes of one geometry take the memory of one.
import {
  cross,
  dot,
  type Mat4,
  scale,
  subtract,
  transformed,
  type Vec3,
} from '../../phong/math/vector.js';
import type { CastObject, CastShape } from './cast-scene.js';

export const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** How many triangles. */
export const countOf = ({ index, positions }: CastShape): number =>
  (index?.length ?? positions.length / 3) / 3;

export class PlacedShape {
  readonly shape: CastShape;
  readonly mirrored: boolean;
  /** To the eye's space. */
  readonly #matrix: Mat4;
  readonly #cofactors: Mat4;

  constructor({ shape, matrix = IDENTITY }: CastObject, eye: Vec3) {
    const [x, y, z] = [vectorAt(matrix, 0), vectorAt(matrix, 4), vectorAt(matrix, 8)];
    const across = cross(y, z);
    this.shape = shape;
    this.mirrored = dot(x, across) < 0;
    this.#matrix = [...x, 0, ...y, 0, ...z, 0, ...subtract(vectorAt(matrix, 12), eye), 1];
    this.#cofactors = [...across, 0, ...cross(z, x), 0, ...cross(x, y), 0, 0, 0, 0, 1];
  }

  verticesOf(triangle: number): readonly [number, number, number] {
    const { index } = this.shape;
    const i = 3 * triangle;
    return index === undefined ? [i, i + 1, i + 2] : [index[i]!, index[i + 1]!, index[i + 2]!];
  }

  /** Relative to the eye. */
  cornersOf(triangle: number): [Vec3, Vec3, Vec3] {
    const [a, b, c] = this.verticesOf(triangle);
    return [this.place(a), this.place(b), this.place(c)];
  }

  place(vertex: number): Vec3 {
    return through(this.#matrix, this.shape.positions, 3 * vertex, 1);
  }

  /** Unit, or zero. */
  normal(vertex: number): Vec3 {
    const normal = through(this.#cofactors, this.shape.normals, 3 * vertex, 0);
    return unit(normal, this.mirrored ? -1 : 1);
  }

  /** Unit, or zero. */
  tangent(vertex: number): Vec3 {
    return unit(through(this.#matrix, this.shape.tangents!, 4 * vertex, 0));
  }
}

/** A place (w = 1) or a direction (w = 0) of a list. */
const through = (m: Mat4, list: ArrayLike<number>, i: number, w: number): Vec3 =>
  transformed(m, list[i]!, list[i + 1]!, list[i + 2]!, w);

export const vectorAt = (list: ArrayLike<number>, i: number): Vec3 => [
  list[i]!,
  list[i + 1]!,
  list[i + 2]!,
];

/** The unit vector, times `side`. Zero stays zero. */
export function unit(v: Vec3, side = 1): Vec3 {
  // Components up to 1e24 and down to 1e-60: the squares neither overflow nor vanish.
  const far = Math.sqrt(dot(v, v));
  return scale(v, far > 0 ? side / far : 0);
}
