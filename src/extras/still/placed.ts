// Shapes where the rays see them: from the eye, along the world's axes.
import { add, cross, dot, length, scale, subtract, type Vec3 } from '../../phong/math/vector.js';
import type { CastShape, TrianglesShape, TrueShape } from './cast-scene.js';
import type { Intersect } from './hit.js';
import { trueShape } from './true-shapes.js';

export interface PlacedTriangles {
  readonly kind: 'triangles';
  readonly places: Float64Array;
  /** World space; unit, or zero. */
  readonly normals: Float64Array;
  /** Unit, or zero; none where the shape has none. */
  readonly tangents: Float64Array;
  readonly mirrored: boolean;
  readonly index: ArrayLike<number> | undefined;
}

interface PlacedTrueShape {
  readonly kind: 'true';
  readonly intersect: Intersect;
  /** Directions and normals between world and shape. */
  readonly toShape: Vec3Matrix;
  readonly toWorld: Vec3Matrix;
  /** The eye, in the shape's space. */
  readonly eye: Vec3;
  /** The corners of the cube of side 1 that holds it. */
  readonly cube: readonly Vec3[];
}

/** The columns of a 4×4 matrix. */
export interface Vec3Matrix {
  readonly x: Vec3;
  readonly y: Vec3;
  readonly z: Vec3;
  readonly origin: Vec3;
}

const ZERO: Vec3 = [0, 0, 0];
const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

export function placed(
  shape: CastShape,
  m: ArrayLike<number> | undefined,
  eye: Vec3,
): PlacedTriangles | PlacedTrueShape {
  const matrix = columnsOf(m);
  const fromEye = { ...matrix, origin: subtract(matrix.origin, eye) };
  return shape.kind === 'triangles' ? placedTriangles(shape, fromEye) : placedTrue(shape, fromEye);
}

/** A triangle's corners relative to the eye. */
export function cornersOf({ places, index }: PlacedTriangles, triangle: number): readonly Vec3[] {
  const corner = (i: number): Vec3 => vectorAt(places, 3 * (index === undefined ? i : index[i]!));
  return [corner(3 * triangle), corner(3 * triangle + 1), corner(3 * triangle + 2)];
}

/** How many triangles; 1 for a true shape. */
export const countOf = (shape: CastShape): number =>
  shape.kind === 'triangles' ? (shape.index?.length ?? shape.positions.length / 3) / 3 : 1;

function placedTriangles(
  { positions, normals, tangents = [], index }: TrianglesShape,
  matrix: Vec3Matrix,
): PlacedTriangles {
  const { x, y, z } = matrix;
  const cofactors = { x: cross(y, z), y: cross(z, x), z: cross(x, y), origin: ZERO };
  const mirrored = dot(x, cofactors.x) < 0;
  return {
    kind: 'triangles',
    places: eachOf(positions, 3, (v) => add(matrix.origin, turned(matrix, v))),
    normals: eachOf(normals, 3, (v) => unit(turned(cofactors, v), mirrored ? -1 : 1)),
    tangents: eachOf(tangents, 4, (v) => unit(turned(matrix, v))),
    mirrored,
    index,
  };
}

function placedTrue({ kind }: TrueShape, matrix: Vec3Matrix): PlacedTrueShape {
  const { x, y, z, origin } = matrix;
  const rows = [cross(y, z), cross(z, x), cross(x, y)] as const; // of the adjugate
  const determinant = dot(x, rows[0]);
  // The inverse by its rows is the cofactors' transpose over the determinant; as columns, the
  // inverse transpose.
  const [a, b, c] = rows.map((row) => scale(row, 1 / determinant)) as [Vec3, Vec3, Vec3];
  const column = (i: 0 | 1 | 2): Vec3 => [a[i], b[i], c[i]];
  const toShape = { x: column(0), y: column(1), z: column(2), origin };
  return {
    kind: 'true',
    intersect: trueShape(kind),
    toShape,
    toWorld: { x: a, y: b, z: c, origin },
    eye: turned(toShape, scale(origin, -1)),
    cube: Array.from({ length: 8 }, (_, k) =>
      add(origin, turned(matrix, [(k & 1) - 0.5, ((k >> 1) & 1) - 0.5, (k >> 2) - 0.5])),
    ),
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

/** Determinants below this share of the column lengths' product are 0 up to rounding. */
const FLATTENED = 1e-9;

/** The mesh has no volume left: its two sides coincide, and it has no inverse. */
export const isFlattened = ({ x, y, z }: Vec3Matrix): boolean =>
  !(Math.abs(dot(x, cross(y, z))) > FLATTENED * length(x) * length(y) * length(z));
