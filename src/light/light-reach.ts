// Which of the packed lights can bring anything to a box: by their cones at no cost to the picture, and by how little they
// could bring within a budget. All in shading space and float64, from the very rows that the GLSL reads. Always on the
// safe side: a light that is left out brings nothing (or what the budget allows) to any point of the box.
import { HEADER, LIMIT_OPEN, NEAREST, ROWS, SHAPE } from './light-layout.js';
import { cross, dot, length, type Vec3 } from '../math/vector.js';
import { KINDS, type PackedLights } from './pack-lights.js';

/** Axis-aligned, in shading space: low x y z, high x y z. */
export type Box = readonly [number, number, number, number, number, number];

/** The most that a surface gives back, a channel each: Ka, Kd and Ks with all that they are multiplied with. */
export interface Reflectance {
  readonly ka: ArrayLike<number>;
  readonly kd: ArrayLike<number>;
  readonly ks: ArrayLike<number>;
}

/**
 * How far, in radians, what the GPU takes for the cone's edge may be from what it is here: 2e-6 measured on the worst
 * lawful driver (tests/stress), with a margin. As a share of the coordinates it also covers their rounding to float32.
 */
const EDGE = 1e-5;

/** Places are float32 on the GPU: half a step of 2^-23 of the largest coordinate each, of light and fragment; with a margin. */
const ROUNDING = 1e-6;

/** Halvings of a box whose sphere alone is too wide to tell: 64 parts at most. */
const HALVINGS = 6;

/** One spot's cone, taken apart once. */
export class Cone {
  readonly #place: Vec3;
  /** As it was rounded to float32, so by up to 6e-8 too long or short: only ratios to it are taken. */
  readonly #axis: Vec3;
  readonly #sin: number;
  readonly #cos: number;
  readonly #open: boolean;

  /** The spot whose first row is `row`. */
  constructor({ data }: PackedLights, row: number) {
    const three = (offset: number): Vec3 => {
      const at = (row + offset) * 4;
      return [data[at] ?? 0, data[at + 1] ?? 0, data[at + 2] ?? 0];
    };
    this.#place = three(ROWS.spot.position);
    this.#axis = three(ROWS.spot.axis);
    const limit = data[(row + ROWS.spot.ambient) * 4 + 3] ?? 0;
    const half = Math.abs(limit); // sin² of half the aperture, or of half of what it lacks to 180°
    this.#open = limit === LIMIT_OPEN;
    this.#sin = 2 * Math.sqrt(Math.max(half * (1 - half), 0));
    this.#cos = (limit < 0 ? -1 : 1) * (1 - 2 * half);
  }

  /** Whether any point of the box may be inside. */
  reaches(
    x0: number,
    y0: number,
    z0: number,
    x1: number,
    y1: number,
    z1: number,
    halvings = HALVINGS,
  ): boolean {
    if (this.#open) return true;
    const sizeX = x1 - x0;
    const sizeY = y1 - y0;
    const sizeZ = z1 - z0;
    const x = x0 + sizeX / 2;
    const y = y0 + sizeY / 2;
    const z = z0 + sizeZ / 2;
    const radius = Math.hypot(sizeX, sizeY, sizeZ) / 2;
    const outside = this.#distance(x, y, z) - this.#slack(x, y, z, radius);
    if (outside > radius) return false;
    if (halvings === 0 || outside <= 0) return true;
    const next = halvings - 1;
    if (sizeX >= sizeY && sizeX >= sizeZ)
      return this.reaches(x0, y0, z0, x, y1, z1, next) || this.reaches(x, y0, z0, x1, y1, z1, next);
    if (sizeY >= sizeZ)
      return this.reaches(x0, y0, z0, x1, y, z1, next) || this.reaches(x0, y, z0, x1, y1, z1, next);
    return this.reaches(x0, y0, z0, x1, y1, z, next) || this.reaches(x0, y0, z, x1, y1, z1, next);
  }

  /** The largest cosine between the axis and any point of a ball around x y z; 1 where the ball holds the apex. */
  nearestCosine(x: number, y: number, z: number, radius: number): number {
    const { along, across, d } = this.#components(x, y, z);
    const reach = radius + this.#slack(x, y, z, radius);
    if (d <= reach) return 1;
    const sin = reach / d;
    const cos = Math.sqrt(1 - sin * sin);
    const axial = along / d;
    return axial >= cos ? 1 : axial * cos + (across / d) * sin;
  }

  /** From a point to the cone; 0 or less inside. */
  #distance(x: number, y: number, z: number): number {
    const { along, across, d } = this.#components(x, y, z);
    const outside = across * this.#cos - along * this.#sin;
    // Beyond a right angle from the cone's side its nearest point is the apex.
    return outside > 0 && along * this.#cos + across * this.#sin < 0 ? d : outside;
  }

  #components(x: number, y: number, z: number): { along: number; across: number; d: number } {
    const [px, py, pz] = this.#place;
    const v: Vec3 = [x - px, y - py, z - pz];
    return { along: dot(v, this.#axis), across: length(cross(v, this.#axis)), d: length(v) };
  }

  #slack(x: number, y: number, z: number, radius: number): number {
    const [px, py, pz] = this.#place;
    const extent =
      Math.abs(px) + Math.abs(py) + Math.abs(pz) + Math.abs(x) + Math.abs(y) + Math.abs(z) + radius;
    return EDGE * extent + NEAREST; // so near there is no angle, and every cone is reached
  }
}

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
  const small: { readonly light: number; readonly bound: Bound }[] = [];
  forEachLight(packed, (light, kind, row) => {
    if (kind === 'directional') return;
    const cone = kind === 'spot' ? new Cone(packed, row) : null;
    if (cone?.reaches(...box) === false) {
      mask[light] = 0;
      into.count -= 1;
    } else if (budget > 0) {
      const bound = mostOf(packed, row, packed.shapes[light] ?? 0, cone, box, surface);
      if (Math.max(...bound) <= budget) small.push({ light, bound });
    }
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

/** Whether every place of a light is outside the box, by more than float32 can hide. */
export function areApart(packed: PackedLights, box: Box): boolean {
  let apart = true;
  forEachLight(packed, (_light, kind, row) => {
    if (kind === 'directional' || !apart) return;
    const gap = (i: 0 | 1 | 2): number => {
      const place = packed.data[row * 4 + i] ?? 0;
      const slack = ROUNDING * (Math.abs(place) + Math.abs(box[i]) + Math.abs(box[i + 3]!));
      return Math.max(box[i] - place, place - box[i + 3]!) - slack;
    };
    apart = Math.max(gap(0), gap(1), gap(2)) > NEAREST;
  });
  return apart;
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
    decay = ((1 + cosine) / 2) ** value(ROWS.spot.axis, 3);
  }
  const ambient = (i: number): number =>
    cone !== null && (shape & SHAPE.ambient) !== 0 ? (ka[i] ?? 0) * value(ROWS.spot.ambient, i) : 0;
  const channel = (i: 0 | 1 | 2): number =>
    decay * (ambient(i) + att * ((kd[i] ?? 0) * value(diffuse, i) + (ks[i] ?? 0) * value(specular, i)));
  return [channel(0), channel(1), channel(2)];
}
