// By pixel: the things that its rays may meet, so that most need not be asked. The nearest come
// first, so that a ray ends its search where all others are farther than what it has met.
import { length, type Vec3 } from '../../phong/math/vector.js';
import type { Screen } from './screen.js';

/** Pixels by which boxes are larger than they are, for the rounding of their corners. */
const SLACK = 1e-6;

/** Corners nearer to the eye's plane than this share of their distance have no sure pixel. */
const LEAST_DEPTH = 1e-9;

/** Share of its depth by which a thing may be met nearer than its corners, by rounding. */
const NEARER = 1e-9;

/** Most entries of all lists: 256 MB. 16 in each pixel on average are never too many. */
const MOST_ENTRIES = 2 ** 26;
const ALWAYS_DEEP = 16;

/**
 * Most entries of a pixel's list on average: at an edge each of up to 336 rays asks all of them.
 * 2,000 boxes in one place, 40 × 30 pixels, take 4 s of CPU time.
 */
const MOST_DEEP = 4096;

export class PixelLists {
  /** The things of pixel i are those from `starts[i]` to before `starts[i + 1]`. */
  readonly starts: Int32Array;
  things = new Int32Array();
  /** No ray meets a thing nearer than this depth. */
  readonly nears: Float64Array;
  count = 0;
  /** Distance of the farthest corner. */
  reach = 0;
  readonly #screen: Screen;
  /** Left, right, top and bottom pixel of each thing. */
  readonly #boxes: Int32Array;

  /** `most`: things. */
  constructor(screen: Screen, most: number) {
    this.starts = new Int32Array(screen.width * screen.height + 1);
    this.nears = new Float64Array(most);
    this.#screen = screen;
    this.#boxes = new Int32Array(4 * most);
  }

  /**
   * Adds the thing that lies between these corners, as seen from the eye. False, and it has no
   * number, if no ray meets it. Behind the eye nothing is sure: all pixels may.
   */
  add(corners: readonly Vec3[]): boolean {
    const { width, height } = this.#screen;
    let [left, right, top, bottom] = [Infinity, -Infinity, Infinity, -Infinity];
    let [near, far, unsure] = [Infinity, -Infinity, false];
    for (const corner of corners) {
      const { x, y, depth } = this.#screen.project(corner);
      const distance = length(corner);
      this.reach = Math.max(this.reach, distance);
      near = Math.min(near, depth);
      far = Math.max(far, depth);
      unsure ||= depth <= LEAST_DEPTH * distance;
      left = Math.min(left, x);
      right = Math.max(right, x);
      top = Math.min(top, y);
      bottom = Math.max(bottom, y);
    }
    if (unsure) {
      [left, right, top, bottom] = [0, width, 0, height];
    }
    left = Math.max(0, Math.floor(left - SLACK));
    right = Math.min(width - 1, Math.floor(right + SLACK));
    top = Math.max(0, Math.floor(top - SLACK));
    bottom = Math.min(height - 1, Math.floor(bottom + SLACK));
    if (!(far > 0 && left <= right && top <= bottom)) return false;
    this.#boxes.set([left, right, top, bottom], 4 * this.count);
    this.nears[this.count++] = near - NEARER * Math.abs(near);
    return true;
  }

  /**
   * Makes the lists; after the last thing. @throws RangeError if too many are one before the other.
   */
  sort(): void {
    const { nears, starts } = this;
    const { width, height } = this.#screen;
    const boxes = this.#boxes;
    const order = Int32Array.from({ length: this.count }, (_, i) => i);
    // Where several coincide, the last one shows: it comes first.
    order.sort((i, j) => nears[i]! - nears[j]! || j - i);
    const entries = order.reduce(
      (sum, i) =>
        sum + (boxes[4 * i + 1]! - boxes[4 * i]! + 1) * (boxes[4 * i + 3]! - boxes[4 * i + 2]! + 1),
      0,
    );
    const most = Math.min(MOST_ENTRIES, MOST_DEEP * width * height);
    if (entries > Math.max(most, ALWAYS_DEEP * width * height)) {
      const size = `${String(width)} × ${String(height)}`;
      throw new RangeError(
        `a still of ${size} pixels cannot hold so many surfaces before and behind each other: ${entries.toLocaleString('en')} in all pixels together`,
      );
    }
    const each = (visit: (pixel: number, thing: number) => void): void => {
      for (const thing of order) {
        const at = 4 * thing;
        for (let y = boxes[at + 2]!; y <= boxes[at + 3]!; y++) {
          for (let x = boxes[at]!; x <= boxes[at + 1]!; x++) {
            visit(y * width + x, thing);
          }
        }
      }
    };
    each((pixel) => (starts[pixel + 1]! += 1));
    for (let i = 0; i < width * height; i++) {
      starts[i + 1]! += starts[i]!;
    }
    const things = new Int32Array(entries);
    const next = starts.slice();
    each((pixel, thing) => (things[next[pixel]!++] = thing));
    this.things = things;
  }
}
