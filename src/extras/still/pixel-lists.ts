// By pixel: the triangles that its rays may meet, so that most need not be asked. The nearest come
// first, so that a ray ends its search where all others are farther than what it has met.
import { cross, dot, length, type Vec3 } from '../../phong/math/vector.js';
import { countOf } from './placed.js';
import type { Screen } from './screen.js';
import type { ObjectSurface } from './surfaces.js';

export type PixelLists = ReturnType<typeof pixelLists>;

/** Pixels by which boxes are larger than they are, for the rounding of their corners. */
const SLACK = 1e-6;

/** Corners nearer to the eye's plane than this share of their distance have no sure pixel. */
const LEAST_DEPTH = 1e-9;

/** Most entries of all lists: 256 MB. 16 in each pixel on average are never too many. */
const MOST_ENTRIES = 2 ** 26;
const ALWAYS_DEEP = 16;

/**
 * Most entries of a pixel's list on average: at an edge each of up to 336 rays asks all of them.
 * 2,000 boxes in one place, 40 × 30 pixels, take 4 s of CPU time.
 */
const MOST_DEEP = 4096;

/** The bits of a depth that give way to a triangle's number. */
const NUMBER = 2 ** 24 - 1;

/**
 * Made once, and read by all threads: in shared memory where there is such. @throws RangeError if too
 * many surfaces are one before the other.
 */
export function pixelLists(screen: Screen, surfaces: readonly ObjectSurface[]) {
  const { width, height } = screen;
  const most = surfaces.reduce((sum, { shape }) => sum + countOf(shape), 0);
  const boxes = new Int32Array(4 * most);
  // By depth, whose last digits are the triangle's number: numbers alone are sorted fast.
  const order = new Float64Array(most);
  const bits = new Uint32Array(order.buffer);
  const objects = sharedList(most);
  const starts = sharedList(width * height + 1);
  let [thing, count, entries, reach] = [0, 0, 0, 0];
  for (const [i, surface] of surfaces.entries()) {
    const { mirrored, object } = surface;
    const isSingle = object.material.single === true;
    for (let triangle = 0; triangle < countOf(surface.shape); triangle++, thing++) {
      objects[thing] = i;
      const corners = surface.cornersOf(triangle);
      const [a, b, c] = corners;
      if (isSingle && dot(a, cross(b, c)) < 0 === mirrored) continue;
      reach = Math.max(reach, length(a), length(b), length(c));
      const pixels = writeBox(corners, screen, boxes, 4 * thing);
      if (pixels === 0) continue;
      entries += pixels;
      order[count] = Math.max(0, nearOf(corners, screen));
      bits[2 * count] = (bits[2 * count]! & ~NUMBER) | thing;
      count += 1;
    }
  }
  const limit = Math.min(MOST_ENTRIES, MOST_DEEP * width * height);
  if (entries > Math.max(limit, ALWAYS_DEEP * width * height)) {
    const size = `${String(width)} × ${String(height)}`;
    throw new RangeError(
      `a still of ${size} pixels cannot hold so many surfaces before and behind each other: ${entries.toLocaleString('en')} in all pixels together`,
    );
  }
  order.subarray(0, count).sort();
  const each = (visit: (pixel: number, thing: number) => void): void => {
    for (let i = 0; i < count; i++) {
      const number = bits[2 * i]! & NUMBER;
      const at = 4 * number;
      for (let y = boxes[at + 2]!; y <= boxes[at + 3]!; y++) {
        for (let x = boxes[at]!; x <= boxes[at + 1]!; x++) {
          visit(y * width + x, number);
        }
      }
    }
  };
  each((pixel) => (starts[pixel + 1]! += 1));
  for (let i = 0; i < width * height; i++) {
    starts[i + 1]! += starts[i]!;
  }
  const things = sharedList(entries);
  const next = starts.slice();
  each((pixel, number) => (things[next[pixel]!++] = number));
  return {
    /** The things of pixel i are those from `starts[i]` to before `starts[i + 1]`. */
    starts,
    /** Numbers of triangles, counted through all objects. */
    things,
    /** By thing. */
    objects,
    /** Distance of the farthest corner. */
    reach,
  };
}

const sharedList = (size: number) => {
  const Memory = 'SharedArrayBuffer' in globalThis ? SharedArrayBuffer : ArrayBuffer;
  return new Int32Array(new Memory(4 * size));
};

/** Depth of the nearest corner. */
export const nearOf = ([a, b, c]: [Vec3, Vec3, Vec3], { camera: { back } }: Screen): number =>
  -Math.max(dot(a, back), dot(b, back), dot(c, back));

/**
 * Writes the left, right, top and bottom pixel of the rays that may meet what lies between these
 * corners, as seen from the eye, and returns how many pixels that are. Behind the eye nothing is
 * sure: all pixels may. Without lists of its own: there may be millions of triangles.
 */
function writeBox(corners: readonly Vec3[], screen: Screen, boxes: Int32Array, at: number): number {
  const { width, height } = screen;
  let [left, right, top, bottom] = [Infinity, -Infinity, Infinity, -Infinity];
  let far = 0;
  for (const corner of corners) {
    const { x, y, depth } = screen.project(corner);
    far = Math.max(far, depth);
    if (depth <= LEAST_DEPTH * length(corner)) {
      left = top = -Infinity;
      right = bottom = Infinity;
      continue;
    }
    left = Math.min(left, x);
    right = Math.max(right, x);
    top = Math.min(top, y);
    bottom = Math.max(bottom, y);
  }
  left = boxes[at] = Math.max(0, Math.floor(left - SLACK));
  right = boxes[at + 1] = Math.min(width - 1, Math.floor(right + SLACK));
  top = boxes[at + 2] = Math.max(0, Math.floor(top - SLACK));
  bottom = boxes[at + 3] = Math.min(height - 1, Math.floor(bottom + SLACK));
  return far > 0 ? Math.max(0, right - left + 1) * Math.max(0, bottom - top + 1) : 0;
}
