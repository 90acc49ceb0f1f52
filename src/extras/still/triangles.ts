// Rays from the eye against triangles. All rays share their origin, so a triangle's three signed
// volumes are linear in the direction; neighbours use the same numbers with opposite signs, so
// there are no gaps. A list for each pixel names the triangles whose box meets it.
import { cross, dot, length, subtract, type Vec3 } from '../../phong/math/vector.js';
import { type Hit, newHit } from './hit.js';
import type { TrianglesShape } from './cast-scene.js';
import { boxOf, type PixelLists, pixelLists } from './pixel-lists.js';
import type { Screen } from './screen.js';

/** Numbers of a triangle: b×c, c×a and a×b of its corners as seen from the eye, and a·(b×c). */
const STRIDE = 10;

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
  /** {@link STRIDE} numbers of each triangle. */
  #volumes = new Float64Array();
  /** Index of each triangle's object in `#placed`, and of the triangle in it. */
  #owners = new Int32Array();
  #indices = new Int32Array();
  #count = 0;
  #lists: PixelLists = { starts: new Int32Array(), things: new Int32Array() };

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
    const boxes = new Int32Array(4 * most);
    this.#volumes = new Float64Array(STRIDE * most);
    this.#owners = new Int32Array(most);
    this.#indices = new Int32Array(most);
    this.#placed.forEach((placed, owner) => this.#measure(placed, owner, boxes));
    this.#lists = pixelLists(boxes.subarray(0, 4 * this.#count), this.#screen);
  }

  /** Whether any triangle's box meets the pixel. */
  meets(pixel: number): boolean {
    const { starts } = this.#lists;
    return starts[pixel]! < starts[pixel + 1]!;
  }

  /**
   * Writes the nearest hit of the pixel's ray with this direction, if it is not farther than
   * `hit`'s. Normals are left to {@link normalOf}.
   */
  intersect(pixel: number, dx: number, dy: number, dz: number, hit: Hit): void {
    const volumes = this.#volumes;
    const { starts, things } = this.#lists;
    const end = starts[pixel + 1]!;
    for (let i = starts[pixel]!; i < end; i++) {
      const triangle = things[i]!;
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

  #measure(placed: PlacedObject, owner: number, boxes: Int32Array): void {
    const count = countOf(placed);
    for (let triangle = 0; triangle < count; triangle++) {
      const corners = cornersOf(placed, triangle);
      const [a, b, c] = corners;
      const box = boxOf(corners, this.#screen);
      if (box === null) continue;
      const bc = cross(b, c);
      const at = this.#count;
      this.#volumes.set([...bc, ...cross(c, a), ...cross(a, b), dot(a, bc)], STRIDE * at);
      this.#owners[at] = owner;
      this.#indices[at] = triangle;
      boxes.set(box, 4 * at);
      this.#count += 1;
    }
  }
}

/** Used within one call of {@link Triangles.intersect}. */
const candidate = newHit();

/** As seen from the eye. */
export function cornersOf(
  { places, index }: Placed,
  triangle: number,
): readonly [Vec3, Vec3, Vec3] {
  const corner = (i: number): Vec3 => {
    const at = 3 * (index === undefined ? i : index[i]!);
    return [places[at]!, places[at + 1]!, places[at + 2]!];
  };
  return [corner(3 * triangle), corner(3 * triangle + 1), corner(3 * triangle + 2)];
}

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
