// Measures how far each pixel of a picture is from the equation in float64. From coarse to fine, in short tasks. In
// steps of 1/255, as 8-bit codes are.
import type { LightValues } from '../../light/light-state.js';
import type { LightShare } from '../../reference/index.js';
import { dot, type Vec3 } from '../../math/vector.js';
import type * as ShadeAt from '../../element/viewer/shade-at.js';
import type { Equation } from '../../element/viewer/shade-hit.js';
import type { Slices } from '../../model/slices.js';
import type { Hit } from '../../scene/snapshot/pick.js';
import type { SceneSnapshot } from '../../scene/snapshot/scene-snapshot.js';

/** Side of the first pass's blocks in pixels; each later pass halves it. */
const COARSEST = 16;

/**
 * Cosine of 12°: neighbours whose normals differ by more lie on both sides of an edge. A sphere has less up to 5 pixels
 * from its outline if it is 100 pixels wide.
 */
const EDGE_COSINE = 0.978;

/** What explains a pixel. */
export type PixelCode = Pick<typeof ShadeAt, 'pick' | 'relative' | 'shadedAt'> & {
  readonly equation: Equation;
};

export interface Picture {
  readonly width: number;
  readonly height: number;
  /** Straight r, g, b, a of each pixel, row by row from the top. */
  readonly data: Uint8ClampedArray;
}

/** What a measurement fills in. */
export interface Measured {
  /** For each pixel the difference of the worst channel; NaN where it is not known. */
  readonly errors: Float32Array;
  /** Share of the pixels that the current pass has measured, 0–1. */
  readonly done: number;
  /** Largest difference away from edges; NaN until all is done. */
  readonly largest: number;
}

export class ErrorMeasure implements Measured {
  readonly errors: Float32Array;
  readonly #picture: Picture;
  readonly #scene: SceneSnapshot;
  readonly #lights: readonly Readonly<LightValues>[];
  readonly #code: PixelCode;
  /**
   * By pixel: which surface is seen in which cones, as a hash; 0 for none. Each triangle is a surface unless shading is
   * `phong`.
   */
  readonly #surfaces: Int32Array;
  readonly #normals: Float32Array;
  #done = 0;
  #largest = NaN;

  /** `scene` has the picture's size, and `lights` are those that it was drawn with. */
  constructor(
    picture: Picture,
    scene: SceneSnapshot,
    lights: readonly Readonly<LightValues>[],
    code: PixelCode,
  ) {
    const pixels = picture.width * picture.height;
    this.#picture = picture;
    this.#scene = scene;
    this.#lights = lights.map((light) => code.relative(light, scene.frame.origin));
    this.#code = code;
    this.errors = new Float32Array(pixels).fill(NaN);
    this.#surfaces = new Int32Array(pixels);
    this.#normals = new Float32Array(3 * pixels);
  }

  get done(): number {
    return this.#done;
  }

  get largest(): number {
    return this.#largest;
  }

  /**
   * Measures everything. `shown` is called for each measured block, `paused` before each pause.
   * @throws the reason of the slices' signal after an abort.
   */
  async run(
    slices: Slices,
    shown: (x: number, y: number, side: number, error: number) => void,
    paused: () => void,
  ): Promise<void> {
    const { width, height } = this.#picture;
    let count = 0;
    for (let side = COARSEST; side >= 1; side /= 2) {
      for (let y = 0; y < height; y += side) {
        for (let x = 0; x < width; x += side) {
          // Measured by a coarser pass.
          if (side < COARSEST && x % (2 * side) === 0 && y % (2 * side) === 0) continue;
          shown(x, y, side, this.#measure(x, y));
          count += 1;
          if (!slices.due) continue;
          this.#done = count / (width * height);
          paused();
          await slices.pause();
        }
      }
    }
    await this.#leaveOutEdges(slices, shown);
    this.#done = 1;
    paused();
  }

  #measure(x: number, y: number): number {
    const { width, data } = this.#picture;
    const at = y * width + x;
    // Pixels at an outline are averages.
    if (data[4 * at + 3] !== 255) return NaN;
    const { pick, shadedAt, equation } = this.#code;
    const hit = pick(this.#scene, x, y);
    if (hit === null || hit.base.opacity < 1 || hit.filtered) return NaN;
    const { color, N, shares } = shadedAt(equation, hit, this.#lights).shaded;
    this.#surfaces[at] = this.#surfaceOf(hit, shares);
    this.#normals.set(N, 3 * at);
    let error = 0;
    for (let i = 0; i < 3; i++) error = Math.max(error, Math.abs(data[4 * at + i]! - 255 * color[i]!));
    this.errors[at] = error;
    return error;
  }

  #surfaceOf({ drawn, triangle }: Hit, shares: readonly (LightShare | null)[]): number {
    let key = this.#scene.objects.indexOf(drawn) + 1;
    // Beyond the border of a triangle the colour is another one (flat), or changes at another rate (Gouraud).
    if (drawn.phong.style.shading !== 'phong') key = hashed(key, triangle);
    shares.forEach((share, i) => {
      if (share?.insideCone === false) key = hashed(key, i);
    });
    return key;
  }

  /** Beside an edge a pixel may be the average of both sides, which the equation makes no promise about. */
  async #leaveOutEdges(
    slices: Slices,
    shown: (x: number, y: number, side: number, error: number) => void,
  ): Promise<void> {
    const { width, height } = this.#picture;
    let largest = 0;
    for (let y = 0; y < height; y++) {
      for (let x = 0; x < width; x++) {
        const at = y * width + x;
        if (Number.isNaN(this.errors[at]!)) continue;
        if (this.#isEdge(x, y)) shown(x, y, 1, NaN);
        else largest = Math.max(largest, this.errors[at]!);
      }
      if (slices.due) await slices.pause();
    }
    this.#largest = largest;
  }

  #isEdge(x: number, y: number): boolean {
    const { width, height } = this.#picture;
    const at = y * width + x;
    const N = this.#normalAt(at);
    for (const [dx, dy] of NEIGHBOURS) {
      const [nx, ny] = [x + dx, y + dy];
      if (nx < 0 || ny < 0 || nx >= width || ny >= height) continue;
      const other = ny * width + nx;
      if (this.#surfaces[other] !== this.#surfaces[at]) return true;
      if (dot(N, this.#normalAt(other)) < EDGE_COSINE * dot(N, N)) return true;
    }
    return false;
  }

  #normalAt(at: number): Vec3 {
    const normals = this.#normals;
    return [normals[3 * at]!, normals[3 * at + 1]!, normals[3 * at + 2]!];
  }
}

const hashed = (key: number, n: number): number => (Math.imul(key, 31) + n + 1) | 0;

const NEIGHBOURS = [[-1, -1], [0, -1], [1, -1], [-1, 0], [1, 0], [-1, 1], [0, 1], [1, 1]] as const; // prettier-ignore
