// Cuts polygons into triangles: a fan for convex ones; ears are cut off others.
import { type CornerLists, NONE, setItem, UNSTATED } from './corner-lists.js';

/**
 * Corners of the largest polygon whose ears are cut, which takes up to n³ steps. Larger ones become
 * fans.
 */
const EAR_LIMIT = 256;

/** Steps of cutting ears in one polygon after which any triangle is cut off: 5 ms. */
const POLYGON_STEPS = 2 ** 20;

/**
 * Takes the corners of a file's polygons, one after the other, and adds their triangles to its
 * lists.
 */
export class Polygons {
  readonly #lists: CornerLists;
  /**
   * Position, texture coordinates and normal of each corner; of a fan, the first and the last
   * corner only.
   */
  readonly #v = new Int32Array(EAR_LIMIT + 1);
  readonly #t = new Int32Array(EAR_LIMIT + 1);
  readonly #n = new Int32Array(EAR_LIMIT + 1);
  /** Corners in these lists. */
  #count = 0;
  #isFan = false;
  #begun = false;
  /** Steps of cutting ears so far. */
  steps = 0;
  #group = UNSTATED;
  #color = 0;

  constructor(lists: CornerLists) {
    this.#lists = lists;
  }

  /** @param color number of its colour among those of faces. */
  begin(group = UNSTATED, color = 0): void {
    this.#count = 0;
    this.#isFan = this.#begun = false;
    this.#group = group;
    this.#color = color;
  }

  /** @throws ModelError `too-large` for too many triangles. */
  add(vertex: number, uv = NONE, normal = NONE): void {
    this.#v[this.#count] = vertex;
    this.#t[this.#count] = uv;
    this.#n[this.#count] = normal;
    this.#count += 1;
    if (!this.#isFan && this.#count <= EAR_LIMIT) return;
    this.#fan();
    this.#isFan = true;
    // The next triangle needs the first and the last corner.
    for (const list of [this.#v, this.#t, this.#n]) {
      list[1] = list[this.#count - 1]!;
    }
    this.#count = 2;
  }

  /** Points and lines have no triangles. With a vertex that has not come yet it is a fan. */
  end(): void {
    const count = this.#count;
    if (this.#isFan || count < 3) return;
    if (count > 3 && !this.#isConvex(count)) {
      this.#cutEars(flattened(this.#lists.places.array, this.#v.subarray(0, count)), count);
    } else {
      this.#fan();
    }
  }

  #fan() {
    for (let i = 2; i < this.#count; i += 1) {
      this.#emit(0, i - 1, i);
    }
  }

  #emit(a: number, b: number, c: number) {
    const lists = this.#lists;
    if (this.#group !== UNSTATED) {
      setItem(lists.groups, lists.triangles, this.#group);
    }
    if (this.#color > 0) {
      lists.triangleColors.fillTo(lists.triangles, 0);
      lists.triangleColors.push(this.#color);
    }
    lists.beginTriangle(this.#begun);
    this.#begun = true;
    this.#corner(a);
    this.#corner(b);
    this.#corner(c);
  }

  #corner(i: number) {
    this.#lists.pushCorner(this.#v[i]!, this.#t[i], this.#n[i]);
  }

  /**
   * Whether every corner turns the same way. Also true if a vertex is missing: nothing is better
   * than a fan then.
   */
  #isConvex(size: number): boolean {
    const { array, count } = this.#lists.places;
    const vertices = this.#v;
    let [nx, ny, nz] = [0, 0, 0];
    for (let i = 0; i < size; i += 1) {
      const a = vertices[i]!;
      if (a >= count) return true;
      const b = vertices[i + 1 === size ? 0 : i + 1]!;
      faceVector(array, 3 * vertices[0]!, 3 * a, 3 * b, turned);
      nx += turned.x;
      ny += turned.y;
      nz += turned.z;
    }
    for (let i = 0; i < size; i += 1) {
      const a = vertices[i]!;
      const b = vertices[(i + 1) % size]!;
      const c = vertices[(i + 2) % size]!;
      faceVector(array, 3 * b, 3 * c, 3 * a, turned);
      if (turned.x * nx + turned.y * ny + turned.z * nz < 0) return false;
    }
    return true;
  }

  #cutEars(flat: Float64Array, count: number) {
    const most = this.steps + POLYGON_STEPS;
    const rest = Array.from({ length: count }, (_, i) => i);
    const at = (i: number) => rest[i % rest.length]!;
    while (rest.length > 3) {
      let ear = rest.findIndex((b, i) => {
        this.steps += rest.length;
        return this.steps > most || isEar(flat, rest, at(i + rest.length - 1), b, at(i + 1));
      });
      if (ear < 0) {
        ear = 1; // it crosses itself: any triangle will do
      }
      this.#emit(at(ear + rest.length - 1), at(ear), at(ear + 1));
      rest.splice(ear, 1);
    }
    this.#emit(at(0), at(1), at(2));
  }
}

const turned: FaceVector = { x: 0, y: 0, z: 0 };

/**
 * x y of each corner in the plane of the coordinate axes that the polygon faces most,
 * counter-clockwise.
 */
function flattened(positions: Float32Array, vertices: Int32Array): Float64Array {
  const count = vertices.length;
  const at = (i: number, axis: number) => positions[3 * vertices[i]! + axis] ?? NaN;
  // Newell's normal: twice the areas of the projections.
  const normal = [0, 0, 0];
  for (let i = 0; i < count; i += 1) {
    const j = (i + 1) % count;
    for (let axis = 0; axis < 3; axis += 1) {
      const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
      normal[axis] = normal[axis]! + (at(i, u) - at(j, u)) * (at(i, v) + at(j, v));
    }
  }
  const sizes = normal.map(Math.abs);
  const axis = sizes.indexOf(Math.max(...sizes));
  const flipped = normal[axis]! < 0;
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
  const x = flat[2 * a]!;
  const y = flat[2 * a + 1]!;
  return (flat[2 * b]! - x) * (flat[2 * c + 1]! - y) - (flat[2 * b + 1]! - y) * (flat[2 * c]! - x);
}

function isEar(
  flat: Float64Array,
  rest: readonly number[],
  a: number,
  b: number,
  c: number,
): boolean {
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
 * Writes the cross product of two edges to `out`, in float64, and returns its length: twice the
 * area of the triangle. The side from which its corners turn left is outside. `a`, `b` and `c` are
 * the corners' indices in `positions`.
 */
export function faceVector(
  positions: Float32Array,
  a: number,
  b: number,
  c: number,
  out: FaceVector,
): number {
  const ax = positions[a]!;
  const ay = positions[a + 1]!;
  const az = positions[a + 2]!;
  const ux = positions[b]! - ax;
  const uy = positions[b + 1]! - ay;
  const uz = positions[b + 2]! - az;
  const vx = positions[c]! - ax;
  const vy = positions[c + 1]! - ay;
  const vz = positions[c + 2]! - az;
  out.x = uy * vz - uz * vy;
  out.y = uz * vx - ux * vz;
  out.z = ux * vy - uy * vx;
  return Math.sqrt(out.x * out.x + out.y * out.y + out.z * out.z);
}
