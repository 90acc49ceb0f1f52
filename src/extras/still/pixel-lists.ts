// By pixel: what its rays may meet, so that most things need not be asked.
import type { Vec3 } from '../../phong/math/vector.js';
import type { Screen } from './screen.js';

/** The things of pixel i are those from `starts[i]` to before `starts[i + 1]`, in their order. */
export interface PixelLists {
  readonly starts: Int32Array;
  readonly things: Int32Array;
}

/** Left, right, top and bottom pixel. */
export type Box = readonly [number, number, number, number];

/** Pixels by which boxes are larger than they are, for the rounding of their corners. */
export const SLACK = 1e-6;

/** Corners nearer to the eye's plane than this share of their distance have no sure pixel. */
const LEAST_DEPTH = 1e-9;

/** Most entries of all lists, 256 MB, or of a pixel's list on average: whichever is more. */
const MOST_ENTRIES = 2 ** 26;
const MOST_DEEP = 16;

/**
 * `boxes`: four numbers of each thing, see {@link Box}. @throws RangeError if too many are one before
 * the other.
 */
export function pixelLists(boxes: ArrayLike<number>, { width, height }: Screen): PixelLists {
  const starts = new Int32Array(width * height + 1);
  let entries = 0;
  for (let i = 0; i < boxes.length; i += 4) {
    entries += (boxes[i + 1]! - boxes[i]! + 1) * (boxes[i + 3]! - boxes[i + 2]! + 1);
  }
  if (entries > Math.max(MOST_ENTRIES, MOST_DEEP * width * height)) {
    const size = `${String(width)} × ${String(height)}`;
    throw new RangeError(
      `a still of ${size} pixels cannot hold so many surfaces before and behind each other: ${entries.toLocaleString('en')} in all pixels together`,
    );
  }
  const each = (visit: (pixel: number, thing: number) => void): void => {
    for (let i = 0; i < boxes.length; i += 4) {
      for (let y = boxes[i + 2]!; y <= boxes[i + 3]!; y++) {
        for (let x = boxes[i]!; x <= boxes[i + 1]!; x++) {
          visit(y * width + x, i / 4);
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
  return { starts, things };
}

/**
 * The pixels whose rays may meet what lies between these corners, as seen from the eye; null if none
 * do. Behind the eye nothing is sure: all of them.
 */
export function boxOf(corners: readonly Vec3[], screen: Screen): Box | null {
  const { width, height } = screen;
  let [left, right, top, bottom] = [Infinity, -Infinity, Infinity, -Infinity];
  let [behind, unsure] = [0, false];
  for (const corner of corners) {
    const { x, y, depth } = screen.project(corner);
    behind += Number(depth <= 0);
    unsure ||= depth <= LEAST_DEPTH * Math.max(...corner.map(Math.abs));
    left = Math.min(left, x);
    right = Math.max(right, x);
    top = Math.min(top, y);
    bottom = Math.max(bottom, y);
  }
  if (behind === corners.length) return null;
  if (unsure) return [0, width - 1, 0, height - 1];
  left = Math.max(0, Math.floor(left - SLACK));
  right = Math.min(width - 1, Math.floor(right + SLACK));
  top = Math.max(0, Math.floor(top - SLACK));
  bottom = Math.min(height - 1, Math.floor(bottom + SLACK));
  return left > right || top > bottom ? null : [left, right, top, bottom];
}
