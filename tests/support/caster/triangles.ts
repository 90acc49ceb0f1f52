// Rays from the eye against triangles. All rays share their origin, so a triangle's three signed
// volumes are linear in the direction; neighbours use the same numbers with opposite signs, so
// there are no gaps. A list for each pixel names the triangles whose box meets it.
import {
  add,
  cross,
  dot,
  length,
  normalize,
  scale,
  subtract,
  type Vec3,
} from '../../../src/phong/math/vector.js';
import type { Hit } from './hit.js';
import type { TrianglesShape } from './scene.js';
import type { Screen } from './screen.js';

/** Numbers of a triangle: b×c, c×a and a×b of its corners as seen from the eye, and a·(b×c). */
const STRIDE = 10;

/** Pixels by which boxes are larger than they are, for the rounding of their corners. */
const SLACK = 1e-6;

export class Triangles {
  readonly #screen: Screen;
  readonly #volumes: number[] = [];
  /** Of each corner of each triangle: a unit normal, then u and v. */
  readonly #corners: number[] = [];
  /** Index of the object. */
  readonly #objects: number[] = [];
  /** Index in the object: what cannot be seen is left out here. */
  readonly #indices: number[] = [];
  readonly #mirrored: boolean[] = [];
  /** Left, right, top and bottom pixel of each triangle. */
  readonly #boxes: number[] = [];
  #starts = new Int32Array();
  #lists = new Int32Array();

  constructor(screen: Screen) {
    this.#screen = screen;
  }

  add(shape: TrianglesShape, at: number, matrix: Vec3Matrix): void {
    const { positions, normals, uvs, index } = shape;
    const { eye } = this.#screen.camera;
    const count = (index ?? positions).length / (index === undefined ? 9 : 3);
    const mirrored = dot(matrix.x, cross(matrix.y, matrix.z)) < 0;
    const cofactors: Vec3Matrix = {
      x: cross(matrix.y, matrix.z),
      y: cross(matrix.z, matrix.x),
      z: cross(matrix.x, matrix.y),
      origin: [0, 0, 0],
    };
    const side = mirrored ? -1 : 1;
    const place = subtract(matrix.origin, eye);
    const moved = Array.from({ length: positions.length / 3 }, (_, i) =>
      add(place, times(matrix, triple(positions, i))),
    );
    const turned = Array.from({ length: normals.length / 3 }, (_, i) =>
      scale(normalize(times(cofactors, triple(normals, i))), side),
    );
    for (let triangle = 0; triangle < count; triangle++) {
      const corner = (k: number): number => index?.[3 * triangle + k] ?? 3 * triangle + k;
      const [i, j, k] = [corner(0), corner(1), corner(2)];
      const [a, b, c] = [moved[i]!, moved[j]!, moved[k]!];
      const box = this.#boxOf(a, b, c);
      if (box === null) continue;
      const bc = cross(b, c);
      this.#volumes.push(...bc, ...cross(c, a), ...cross(a, b), dot(a, bc));
      for (const vertex of [i, j, k]) {
        this.#corners.push(...turned[vertex]!, uvs?.[2 * vertex] ?? 0, uvs?.[2 * vertex + 1] ?? 0);
      }
      this.#objects.push(at);
      this.#indices.push(triangle);
      this.#mirrored.push(mirrored);
      this.#boxes.push(...box);
    }
  }

  /** Makes the pixels' lists; after the last {@link add}. */
  sort(): void {
    const { width, height } = this.#screen;
    const starts = new Int32Array(width * height + 1);
    const each = (visit: (pixel: number, triangle: number) => void): void => {
      const boxes = this.#boxes;
      for (let triangle = 0; triangle < this.#objects.length; triangle++) {
        for (let y = boxes[4 * triangle + 2]!; y <= boxes[4 * triangle + 3]!; y++) {
          for (let x = boxes[4 * triangle]!; x <= boxes[4 * triangle + 1]!; x++) {
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
   * Writes the nearest hit of the pixel's ray with this direction, if it is nearer than `hit`'s.
   */
  intersect(pixel: number, [dx, dy, dz]: Vec3, hit: Hit): void {
    const volumes = this.#volumes;
    let nearest = -1;
    let [wa, wb, wc] = [0, 0, 0];
    for (let i = this.#starts[pixel]!; i < this.#starts[pixel + 1]!; i++) {
      const triangle = this.#lists[i]!;
      const at = STRIDE * triangle;
      const a = dx * volumes[at]! + dy * volumes[at + 1]! + dz * volumes[at + 2]!;
      const b = dx * volumes[at + 3]! + dy * volumes[at + 4]! + dz * volumes[at + 5]!;
      const c = dx * volumes[at + 6]! + dy * volumes[at + 7]! + dz * volumes[at + 8]!;
      if (!((a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0))) continue;
      const sum = a + b + c;
      const t = volumes[at + 9]! / sum;
      if (!(t > 0 && t < hit.t)) continue;
      const front = sum < 0 !== this.#mirrored[triangle];
      hit.t = t;
      hit.front = front;
      nearest = triangle;
      [wa, wb, wc] = [a / sum, b / sum, c / sum];
    }
    if (nearest < 0) return;
    const corners = this.#corners;
    const mixed = (k: number): number =>
      wa * corners[15 * nearest + k]! +
      wb * corners[15 * nearest + 5 + k]! +
      wc * corners[15 * nearest + 10 + k]!;
    hit.nx = mixed(0);
    hit.ny = mixed(1);
    hit.nz = mixed(2);
    hit.u = mixed(3);
    hit.v = mixed(4);
    hit.object = this.#objects[nearest]!;
    hit.triangle = this.#indices[nearest]!;
  }

  /**
   * The pixels whose rays may meet the triangle; null if none do. Behind the eye nothing is sure:
   * all of them.
   */
  #boxOf(
    ...corners: readonly [Vec3, Vec3, Vec3]
  ): readonly [number, number, number, number] | null {
    const { width, height } = this.#screen;
    const places = corners.map((corner) => this.#screen.project(corner));
    const depths = places.map(({ depth }) => depth);
    if (depths.every((depth) => depth <= 0)) return null;
    const size = Math.max(...corners.map(length));
    // Nearer than this a corner's pixel is not to be trusted.
    if (depths.some((depth) => depth <= 1e-9 * size)) return [0, width - 1, 0, height - 1];
    const xs = places.map(({ x }) => x);
    const ys = places.map(({ y }) => y);
    const left = Math.max(0, Math.floor(Math.min(...xs) - SLACK));
    const right = Math.min(width - 1, Math.floor(Math.max(...xs) + SLACK));
    const top = Math.max(0, Math.floor(Math.min(...ys) - SLACK));
    const bottom = Math.min(height - 1, Math.floor(Math.max(...ys) + SLACK));
    return left > right || top > bottom ? null : [left, right, top, bottom];
  }
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

/** Without the matrix's origin. */
export const times = ({ x, y, z }: Vec3Matrix, [a, b, c]: Vec3): Vec3 =>
  add(add(scale(x, a), scale(y, b)), scale(z, c));

const triple = (list: ArrayLike<number>, i: number): Vec3 => [
  list[3 * i]!,
  list[3 * i + 1]!,
  list[3 * i + 2]!,
];
