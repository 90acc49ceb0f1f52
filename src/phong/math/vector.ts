// Numbers and small float64 vectors for the CPU. Unitless; the caller's names give the space.
// Functions of vectors allocate: do not use them in a viewer's per-vertex or per-frame loops.

export type Vec3 = readonly [number, number, number];
export type Vec4 = readonly [number, number, number, number];

/** A 4×4 matrix by columns, as WebGL and three.js keep it. */
export type Mat4 = ArrayLike<number>;

export const ORIGIN: Vec3 = [0, 0, 0];

export const clamp = (x: number, low: number, high: number): number =>
  Math.min(Math.max(x, low), high);

export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

export const add = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];

export const subtract = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

export const scale = (a: Vec3, s: number): Vec3 => [a[0] * s, a[1] * s, a[2] * s];

export const negate = (a: Vec3): Vec3 => [-a[0], -a[1], -a[2]];

export const multiply = (a: Vec3, b: Vec3): Vec3 => [a[0] * b[0], a[1] * b[1], a[2] * b[2]];

/** A place (w = 1) or a direction (w = 0) through a matrix that keeps w. */
export const transformed = (m: Mat4, x: number, y: number, z: number, w = 1): Vec3 => [
  m[0]! * x + m[4]! * y + m[8]! * z + m[12]! * w,
  m[1]! * x + m[5]! * y + m[9]! * z + m[13]! * w,
  m[2]! * x + m[6]! * y + m[10]! * z + m[14]! * w,
];

/** `f` of each component. */
export const map = (a: Vec3, f: (x: number) => number): Vec3 => [f(a[0]), f(a[1]), f(a[2])];

export const cross = (a: Vec3, b: Vec3): Vec3 => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** Squares from here to its inverse neither overflow nor lose digits to subnormal numbers. */
const SAFE_SQUARE = 1e-280;

/** Euclidean length, without intermediate overflow or underflow. The same bits in every engine. */
export function length(a: Vec3): number {
  const squared = dot(a, a);
  if (squared > SAFE_SQUARE && squared < 1 / SAFE_SQUARE) return Math.sqrt(squared);
  const largest = Math.max(Math.abs(a[0]), Math.abs(a[1]), Math.abs(a[2]));
  if (!(largest > 0 && largest < Infinity)) return largest;
  const s: Vec3 = [a[0] / largest, a[1] / largest, a[2] / largest];
  return largest * Math.sqrt(dot(s, s));
}

/**
 * The unit vector along `a`, or the zero vector if `a` is zero. Scales by the largest component
 * first, so that a denormal vector keeps its direction.
 */
export function normalize(a: Vec3): Vec3 {
  const largest = Math.max(Math.abs(a[0]), Math.abs(a[1]), Math.abs(a[2]));
  if (!(largest > 0)) return [0, 0, 0];
  const s: Vec3 = [a[0] / largest, a[1] / largest, a[2] / largest];
  return scale(s, 1 / Math.sqrt(dot(s, s)));
}

/** A unit vector across `a`, which is not zero. */
export function perpendicular(a: Vec3): Vec3 {
  const [x, y, z] = map(a, Math.abs);
  // The world axis that is farthest from parallel.
  return normalize(cross(a, x <= y && x <= z ? [1, 0, 0] : y <= z ? [0, 1, 0] : [0, 0, 1]));
}
