// Cuts a polygon into triangles: a fan for convex ones; ears are cut off others. Works on vertex numbers, calls back
// for each triangle.
import { ModelError } from '../model.js';
import type { Positions } from './corner-lists.js';

/** Most corners of a polygon. Real ones have hundreds; each takes memory before the triangles do. */
const POLYGON_LIMIT = 2 ** 20;

/** Call before a polygon gets one more corner. @throws ModelError `too-large`. */
export function requirePolygon(corners: number): void {
  if (corners < POLYGON_LIMIT) return;
  const most = POLYGON_LIMIT.toLocaleString('en');
  throw new ModelError('too-large', `A polygon of the model has more than ${most} corners.`);
}

/** Corners of the largest polygon whose ears are cut, which takes up to n³ steps. Larger ones become fans. */
const EAR_LIMIT = 256;

/** Steps of cutting ears in one model, after which polygons become fans: less than a second. */
const STEP_LIMIT = 2 ** 27;

type Emit = (a: number, b: number, c: number) => void;

/** Cuts the polygons of one model. */
export class Triangulator {
  readonly #places: Positions;
  #steps = 0;

  constructor(places: Positions) {
    this.#places = places;
  }

  /**
   * @param vertices the polygon's vertices in order. With one that is not among the places yet it becomes a fan.
   * @param emit called with indices into `vertices`, three per triangle.
   */
  cut(vertices: readonly number[], emit: Emit): void {
    const count = vertices.length;
    if (count > 3 && count <= EAR_LIMIT && this.#steps < STEP_LIMIT && !this.#isConvex(vertices)) {
      this.#cutEars(flattened(this.#places.array, vertices), count, emit);
      return;
    }
    for (let i = 2; i < count; i += 1) emit(0, i - 1, i);
  }

  /** Whether every corner turns the same way. Also true if a vertex is missing: nothing is better than a fan then. */
  #isConvex(vertices: readonly number[]): boolean {
    const { array, count } = this.#places;
    const size = vertices.length;
    let [nx, ny, nz] = [0, 0, 0];
    for (let i = 0; i < size; i += 1) {
      const a = vertices[i] ?? 0;
      if (a >= count) return true;
      const b = vertices[i + 1 === size ? 0 : i + 1] ?? 0;
      faceVector(array, 3 * (vertices[0] ?? 0), 3 * a, 3 * b, turned);
      nx += turned.x;
      ny += turned.y;
      nz += turned.z;
    }
    for (let i = 0; i < size; i += 1) {
      const a = vertices[i] ?? 0;
      const b = vertices[(i + 1) % size] ?? 0;
      const c = vertices[(i + 2) % size] ?? 0;
      faceVector(array, 3 * b, 3 * c, 3 * a, turned);
      if (turned.x * nx + turned.y * ny + turned.z * nz < 0) return false;
    }
    return true;
  }

  #cutEars(flat: Float64Array, count: number, emit: Emit): void {
    const rest = Array.from({ length: count }, (_, i) => i);
    const at = (i: number): number => rest[i % rest.length] ?? 0;
    while (rest.length > 3) {
      let ear = rest.findIndex((b, i) => {
        this.#steps += rest.length;
        return isEar(flat, rest, at(i + rest.length - 1), b, at(i + 1));
      });
      if (ear < 0) ear = 1; // it crosses itself: any triangle will do
      emit(at(ear + rest.length - 1), at(ear), at(ear + 1));
      rest.splice(ear, 1);
    }
    emit(at(0), at(1), at(2));
  }
}

const turned: FaceVector = { x: 0, y: 0, z: 0 };

/** x y of each corner in the plane of the coordinate axes that the polygon faces most, counter-clockwise. */
function flattened(positions: Float32Array, vertices: readonly number[]): Float64Array {
  const count = vertices.length;
  const at = (i: number, axis: number): number => positions[3 * (vertices[i] ?? 0) + axis] ?? NaN;
  // Newell's normal: twice the areas of the projections.
  const normal = [0, 0, 0];
  for (let i = 0; i < count; i += 1) {
    const j = i + 1 === count ? 0 : i + 1;
    for (let axis = 0; axis < 3; axis += 1) {
      const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
      normal[axis] = (normal[axis] ?? 0) + (at(i, u) - at(j, u)) * (at(i, v) + at(j, v));
    }
  }
  const sizes = normal.map(Math.abs);
  const axis = sizes.indexOf(Math.max(...sizes));
  const flipped = (normal[axis] ?? 0) < 0;
  const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
  const flat = new Float64Array(2 * count);
  for (let i = 0; i < count; i += 1) {
    flat[2 * i] = at(i, flipped ? v : u);
    flat[2 * i + 1] = at(i, flipped ? u : v);
  }
  return flat;
}

/** Twice the signed area of a triangle: positive where it turns left. */
function turn(flat: Float64Array, a: number, b: number, c: number): number {
  const x = flat[2 * a] ?? 0;
  const y = flat[2 * a + 1] ?? 0;
  return (
    ((flat[2 * b] ?? 0) - x) * ((flat[2 * c + 1] ?? 0) - y) -
    ((flat[2 * b + 1] ?? 0) - y) * ((flat[2 * c] ?? 0) - x)
  );
}

function isEar(flat: Float64Array, rest: readonly number[], a: number, b: number, c: number): boolean {
  if (!(turn(flat, a, b, c) > 0)) return false;
  return rest.every(
    (p) =>
      p === a ||
      p === b ||
      p === c ||
      // A point on the border does no harm. Holes are often joined to the border by doubled edges.
      turn(flat, a, b, p) <= 0 ||
      turn(flat, b, c, p) <= 0 ||
      turn(flat, c, a, p) <= 0,
  );
}

export interface FaceVector {
  x: number;
  y: number;
  z: number;
}

/**
 * Writes the cross product of two edges to `out`, in float64, and returns its length: twice the area of the triangle.
 * The side from which its corners turn left is outside. `a`, `b` and `c` are the corners' indices in `positions`.
 */
export function faceVector(
  positions: Float32Array,
  a: number,
  b: number,
  c: number,
  out: FaceVector,
): number {
  const ax = positions[a] ?? 0;
  const ay = positions[a + 1] ?? 0;
  const az = positions[a + 2] ?? 0;
  const ux = (positions[b] ?? 0) - ax;
  const uy = (positions[b + 1] ?? 0) - ay;
  const uz = (positions[b + 2] ?? 0) - az;
  const vx = (positions[c] ?? 0) - ax;
  const vy = (positions[c + 1] ?? 0) - ay;
  const vz = (positions[c + 2] ?? 0) - az;
  out.x = uy * vz - uz * vy;
  out.y = uz * vx - ux * vz;
  out.z = ux * vy - uy * vx;
  return Math.hypot(out.x, out.y, out.z);
}
