// Which of the packed lights can bring anything to a box: by their cones at no cost to the picture, and by how little they
// could bring within a budget. All in shading space and float64, from the very rows that the GLSL reads. Always on the
// safe side: a light that is left out brings nothing (or what the budget allows) to any point of the box.
import { Cone } from './cone.js';
import { HEADER, ROWS, SHAPE } from './light-layout.js';
import { KINDS, type PackedLights } from './pack-lights.js';

/** Axis-aligned, in shading space: low x y z, high x y z. */
export type Box = readonly [number, number, number, number, number, number];

/** The most that a surface gives back, a channel each: Ka, Kd and Ks with all that they are multiplied with. */
export interface Reflectance {
  readonly ka: ArrayLike<number>;
  readonly kd: ArrayLike<number>;
  readonly ks: ArrayLike<number>;
}

/** Places are float32 on the GPU: half a step of 2^-23 of the largest coordinate each, of light and fragment; with a margin. */
export const ROUNDING = 1e-6;

/** What {@link reachedLights} has found. */
export interface Reached {
  /** 1 for every sent light that can reach the box, in their order; longer than there are lights. */
  mask: Uint8Array;
  /** How many those are. */
  count: number;
  /** The most that what was left out for the budget can bring together, in any channel. */
  given: number;
}

/**
 * Which of the packed lights can reach `box`. `budget` is the colour that may be given up, 1 being full; 0 leaves out
 * only what is exactly nothing.
 */
export function reachedLights(
  packed: PackedLights,
  box: Box,
  surface: Reflectance,
  budget: number,
  into: Reached,
): void {
  if (into.mask.length < packed.sent) into.mask = new Uint8Array(packed.shapes.length);
  const { mask } = into;
  mask.fill(1, 0, packed.sent);
  into.count = packed.sent;
  into.given = 0;
  const { directional, point } = packed.counts;
  if (budget > 0) {
    leaveOutFaint(packed, box, surface, budget, into);
    return;
  }
  let row = HEADER.rows + directional * ROWS.directional.rows + point * ROWS.point.rows;
  for (let light = directional + point; light < packed.sent; light++, row += ROWS.spot.rows) {
    cone.take(packed, row);
    if (cone.reaches(box[0], box[1], box[2], box[3], box[4], box[5])) continue;
    mask[light] = 0;
    into.count -= 1;
  }
}

/** Kept from light to light. */
const cone = /* @__PURE__ */ new Cone();

/** The same where something may be given up. */
function leaveOutFaint(
  packed: PackedLights,
  box: Box,
  surface: Reflectance,
  budget: number,
  into: Reached,
): void {
  const { mask } = into;
  const small: { readonly light: number; readonly bound: Bound }[] = [];
  forEachLight(packed, (light, kind, row) => {
    if (kind === 'directional') return;
    if (kind === 'spot') cone.take(packed, row);
    if (kind === 'spot' && !cone.reaches(...box)) {
      mask[light] = 0;
      into.count -= 1;
      return;
    }
    const bound = mostOf(packed, row, packed.shapes[light] ?? 0, kind === 'spot' ? cone : null, box, surface);
    if (Math.max(...bound) <= budget) small.push({ light, bound });
  });
  small.sort((a, b) => Math.max(...a.bound) - Math.max(...b.bound));
  const sum: [number, number, number] = [0, 0, 0];
  for (const { light, bound } of small) {
    for (const i of [0, 1, 2] as const) sum[i] += bound[i];
    if (Math.max(...sum) > budget) break;
    into.given = Math.max(...sum);
    mask[light] = 0;
    into.count -= 1;
  }
}

/** Calls `visit` with each sent light's number, kind and first row. */
export function forEachLight(
  packed: PackedLights,
  visit: (light: number, kind: (typeof KINDS)[number], row: number) => void,
): void {
  let row: number = HEADER.rows;
  let light = 0;
  for (const kind of KINDS) {
    for (let i = 0; i < packed.counts[kind]; i++, row += ROWS[kind].rows) visit(light++, kind, row);
  }
}

/**
 * Each number of a packed axis is off by 2^-25 at most, its product with a unit vector by √3 times as much, (1 + c) / 2 by half of
 * that. Straight behind a spot it could come out below 0, and a small exponent makes much of little.
 */
const AXIS_ROUNDING = Math.sqrt(3) * 2 ** -26;

type Bound = readonly [number, number, number];

/** The most that a positional light can bring to a point of the box, a channel each. */
export function mostOf(
  { data }: PackedLights,
  row: number,
  shape: number,
  cone: Cone | null,
  box: Box,
  { ka, kd, ks }: Reflectance,
): Bound {
  const value = (offset: number, i: number): number => data[(row + offset) * 4 + i] ?? 0;
  const { position, diffuse, specular } = ROWS.spot; // a point light's rows begin alike
  const gap = (i: 0 | 1 | 2): number => {
    const place = value(position, i);
    const rounding = ROUNDING * (Math.abs(place) + Math.max(Math.abs(box[i]), Math.abs(box[i + 3]!)));
    return Math.max(box[i] - place - rounding, place - box[i + 3]! - rounding, 0);
  };
  const d = Math.hypot(gap(0), gap(1), gap(2));
  const att = 1 / Math.max(value(position, 3) + d * (value(diffuse, 3) + d * value(specular, 3)), 1);
  let decay = 1;
  if (cone !== null) {
    const half = Math.hypot(box[3] - box[0], box[4] - box[1], box[5] - box[2]) / 2;
    const middle = (i: 0 | 1 | 2): number => (box[i] + box[i + 3]!) / 2;
    const cosine = cone.nearestCosine(middle(0), middle(1), middle(2), half);
    decay = Math.min((1 + cosine) / 2 + AXIS_ROUNDING, 1) ** value(ROWS.spot.axis, 3);
  }
  const ambient = (i: number): number =>
    cone !== null && (shape & SHAPE.ambient) !== 0 ? (ka[i] ?? 0) * value(ROWS.spot.ambient, i) : 0;
  const channel = (i: 0 | 1 | 2): number =>
    decay * (ambient(i) + att * ((kd[i] ?? 0) * value(diffuse, i) + (ks[i] ?? 0) * value(specular, i)));
  return [channel(0), channel(1), channel(2)];
}
