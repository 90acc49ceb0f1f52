// Rays from the eye against triangles. All rays share their origin, so a triangle's three signed
// volumes are linear in the direction; neighbours use the same numbers with opposite signs, so
// there are no gaps. A list for each pixel names the triangles whose box meets it.
import { cross, dot, length, subtract, type Vec3 } from '../../phong/math/vector.js';
import { type Hit, newHit } from './hit.js';
import type { TrianglesShape } from './cast-scene.js';
import type { Screen } from './screen.js';

/** Numbers of a triangle: b×c, c×a and a×b of its corners as seen from the eye, and a·(b×c). */
const STRIDE = 10;

/** Pixels by which boxes are larger than they are, for the rounding of their corners. */
const SLACK = 1e-6;

/** Corners nearer to the eye's plane than this share of their distance have no sure pixel. */
const LEAST_DEPTH = 1e-9;

/** An object's vertices as the rays see them. */
export interface Placed {
  /** From the eye, along the world's axes. */
  readonly places: Float64Array;
  /** World space; unit, or zero. */
  readonly normals: Float64Array;
  readonly mirrored: boolean;
  readonly index: ArrayLike<number> | undefined;
}

/** False: the surface is not there; see {@link Triangles.intersect}. */
export type Accepts = (hit: Hit) => boolean;

interface PlacedObject extends Placed {
  readonly object: number;
  readonly accepts: Accepts | undefined;
}

export class Triangles {
  readonly #screen: Screen;
  readonly #placed: PlacedObject[] = [];
  #count = 0;
  #volumes = new Float64Array();
  /** Index of each triangle's object in `#placed`, and of the triangle in it. */
  #owners = new Int32Array();
  #indices = new Int32Array();
  /** Left, right, top and bottom pixel of each triangle. */
  #boxes = new Int32Array();
  #starts = new Int32Array();
  #lists = new Int32Array();

  constructor(screen: Screen) {
    this.#screen = screen;
  }

  /** `accepts`: asked for each hit, of some objects only. */
  add(shape: TrianglesShape, object: number, matrix: Vec3Matrix, accepts?: Accepts): Placed {
    const placed = placedShape(shape, matrix, this.#screen.camera.eye);
    this.#placed.push({ ...placed, object, accepts });
    return placed;
  }

  /** Makes the pixels' lists; after the last {@link add}. */
  sort(): void {
    const most = this.#placed.reduce((sum, placed) => sum + countOf(placed), 0);
    this.#volumes = new Float64Array(STRIDE * most);
    this.#owners = new Int32Array(most);
    this.#indices = new Int32Array(most);
    this.#boxes = new Int32Array(4 * most);
    this.#placed.forEach((placed, owner) => this.#measure(placed, owner));
    const { width, height } = this.#screen;
    const starts = new Int32Array(width * height + 1);
    const boxes = this.#boxes;
    const each = (visit: (pixel: number, triangle: number) => void): void => {
      for (let triangle = 0; triangle < this.#count; triangle++) {
        const [left, right] = [boxes[4 * triangle]!, boxes[4 * triangle + 1]!];
        const bottom = boxes[4 * triangle + 3]!;
        for (let y = boxes[4 * triangle + 2]!; y <= bottom; y++) {
          for (let x = left; x <= right; x++) {
            visit(y * width + x, triangle);
          }
        }
      }
    };
    each((pixel) => (starts[pixel + 1]! += 1));
    for (let i = 0; i < width * height; i++) {
      starts[i + 1]! += starts[i]!;
    }
    const lists = new Int32Array(starts[width * height]!);
    const next = starts.slice();
    each((pixel, triangle) => (lists[next[pixel]!++] = triangle));
    this.#starts = starts;
    this.#lists = lists;
  }

  /** Whether any triangle's box meets the pixel. */
  meets(pixel: number): boolean {
    return this.#starts[pixel]! < this.#starts[pixel + 1]!;
  }

  /**
   * Whether any triangle covers a part of the pixel, or may: not if the pixel's corners are all
   * beyond one of its sides.
   */
  touches(pixel: number): boolean {
    const { width } = this.#screen;
    const [x, y] = [pixel % width, Math.floor(pixel / width)];
    const corners = [0, 1, 2, 3].map((k) =>
      this.#screen.direction(
        x + (k & 1) * (1 + 2 * SLACK) - SLACK,
        y + (k >> 1) * (1 + 2 * SLACK) - SLACK,
      ),
    );
    for (let i = this.#starts[pixel]!; i < this.#starts[pixel + 1]!; i++) {
      const at = STRIDE * this.#lists[i]!;
      let [above, below] = [false, false];
      for (let side = at; side < at + 9; side += 3) {
        const [bx, by, bz] = [
          this.#volumes[side]!,
          this.#volumes[side + 1]!,
          this.#volumes[side + 2]!,
        ];
        const volume = ([dx, dy, dz]: Vec3): number => dx * bx + dy * by + dz * bz;
        above ||= corners.every((d) => volume(d) > 0);
        below ||= corners.every((d) => volume(d) < 0);
      }
      if (!(above && below)) return true;
    }
    return false;
  }

  /**
   * Writes the nearest hit of the pixel's ray with this direction, if it is not farther than
   * `hit`'s. Normals are left to {@link normalOf}.
   */
  intersect(pixel: number, dx: number, dy: number, dz: number, hit: Hit): void {
    const volumes = this.#volumes;
    const end = this.#starts[pixel + 1]!;
    for (let i = this.#starts[pixel]!; i < end; i++) {
      const triangle = this.#lists[i]!;
      const at = STRIDE * triangle;
      const a = dx * volumes[at]! + dy * volumes[at + 1]! + dz * volumes[at + 2]!;
      const b = dx * volumes[at + 3]! + dy * volumes[at + 4]! + dz * volumes[at + 5]!;
      const c = dx * volumes[at + 6]! + dy * volumes[at + 7]! + dz * volumes[at + 8]!;
      if (!((a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0))) continue;
      const sum = a + b + c;
      const t = volumes[at + 9]! / sum;
      if (!(t > 0 && t <= hit.t)) continue;
      const owner = this.#placed[this.#owners[triangle]!]!;
      const into = owner.accepts === undefined ? hit : candidate;
      into.t = t;
      into.front = sum < 0 !== owner.mirrored;
      into.object = owner.object;
      into.triangle = this.#indices[triangle]!;
      into.a = a / sum;
      into.b = b / sum;
      into.c = c / sum;
      if (owner.accepts?.(candidate) === true) {
        Object.assign(hit, candidate);
      }
    }
  }

  #measure(placed: PlacedObject, owner: number): void {
    const { places, index } = placed;
    const count = countOf(placed);
    const corner = (i: number): Vec3 => {
      const at = 3 * (index === undefined ? i : index[i]!);
      return [places[at]!, places[at + 1]!, places[at + 2]!];
    };
    for (let triangle = 0; triangle < count; triangle++) {
      const [a, b, c] = [corner(3 * triangle), corner(3 * triangle + 1), corner(3 * triangle + 2)];
      const box = this.#boxOf(a, b, c);
      if (box === null) continue;
      const bc = cross(b, c);
      this.#volumes.set([...bc, ...cross(c, a), ...cross(a, b), dot(a, bc)], STRIDE * this.#count);
      this.#owners[this.#count] = owner;
      this.#indices[this.#count] = triangle;
      this.#boxes.set(box, 4 * this.#count);
      this.#count += 1;
    }
  }

  /**
   * The pixels whose rays may meet the triangle; null if none do. Behind the eye nothing is sure:
   * all of them.
   */
  #boxOf(...corners: readonly [Vec3, Vec3, Vec3]): readonly number[] | null {
    const { width, height } = this.#screen;
    let [left, right, top, bottom] = [Infinity, -Infinity, Infinity, -Infinity];
    let [behind, unsure] = [0, false];
    for (const corner of corners) {
      const { x, y, depth } = this.#screen.project(corner);
      behind += Number(depth <= 0);
      unsure ||= depth <= LEAST_DEPTH * Math.max(...corner.map(Math.abs));
      left = Math.min(left, x);
      right = Math.max(right, x);
      top = Math.min(top, y);
      bottom = Math.max(bottom, y);
    }
    if (behind === 3) return null;
    if (unsure) return [0, width - 1, 0, height - 1];
    left = Math.max(0, Math.floor(left - SLACK));
    right = Math.min(width - 1, Math.floor(right + SLACK));
    top = Math.max(0, Math.floor(top - SLACK));
    bottom = Math.min(height - 1, Math.floor(bottom + SLACK));
    return left > right || top > bottom ? null : [left, right, top, bottom];
  }
}

/** Used within one call of {@link Triangles.intersect}. */
const candidate = newHit();

const countOf = ({ places, index }: Placed): number => (index?.length ?? places.length / 3) / 3;

function placedShape(
  { positions, normals, index }: TrianglesShape,
  matrix: Vec3Matrix,
  eye: Vec3,
): Placed {
  const { x, y, z } = matrix;
  const mirrored = dot(x, cross(y, z)) < 0;
  const side = mirrored ? -1 : 1;
  const cofactors = { x: cross(y, z), y: cross(z, x), z: cross(x, y) };
  const origin = subtract(matrix.origin, eye);
  const places = transformedAll(positions, 3, { x, y, z }, origin);
  const turned = transformedAll(normals, 3, cofactors, [0, 0, 0]);
  for (let i = 0; i < turned.length; i += 3) {
    unitAt(turned, i, side);
  }
  return { places, normals: turned, mirrored, index };
}

/** The first three of every `size` numbers through a matrix. */
export function transformedAll(
  list: ArrayLike<number>,
  size: number,
  { x, y, z }: Pick<Vec3Matrix, 'x' | 'y' | 'z'>,
  origin: Vec3,
): Float64Array {
  const out = new Float64Array((3 * list.length) / size);
  for (let from = 0, i = 0; i < out.length; i += 3, from += size) {
    const [a, b, c] = [list[from]!, list[from + 1]!, list[from + 2]!];
    for (let k = 0; k < 3; k++) {
      out[i + k] = origin[k as 0] + x[k as 0] * a + y[k as 0] * b + z[k as 0] * c;
    }
  }
  return out;
}

/** Makes the vector at `i` unit, times `side`. Zero stays zero. */
export function unitAt(list: Float64Array, i: number, side = 1): void {
  const [x, y, z] = [list[i]!, list[i + 1]!, list[i + 2]!];
  // Components up to 1e24 and down to 1e-60: the squares neither overflow nor vanish.
  const length = Math.sqrt(x * x + y * y + z * z);
  const factor = length > 0 ? side / length : 0;
  list[i] = x * factor;
  list[i + 1] = y * factor;
  list[i + 2] = z * factor;
}

/** The columns of a 4×4 matrix. */
export interface Vec3Matrix {
  readonly x: Vec3;
  readonly y: Vec3;
  readonly z: Vec3;
  readonly origin: Vec3;
}

export function columnsOf(m: ArrayLike<number> | undefined): Vec3Matrix {
  if (m === undefined) return { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1], origin: [0, 0, 0] };
  const column = (i: number): Vec3 => [m[4 * i]!, m[4 * i + 1]!, m[4 * i + 2]!];
  return { x: column(0), y: column(1), z: column(2), origin: column(3) };
}

/** Determinants below this share of the column lengths' product are 0 up to rounding. */
const FLATTENED = 1e-9;

/** The mesh has no volume left: its two sides coincide, and it has no inverse. */
export const isFlattened = ({ x, y, z }: Vec3Matrix): boolean =>
  !(Math.abs(dot(x, cross(y, z))) > FLATTENED * length(x) * length(y) * length(z));
