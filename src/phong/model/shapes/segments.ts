// How many segments a round shape needs in a view, and how a flat one that is large for the eye's
// distance is cut.
import { type Extent, stretch } from '../../geometry/bounds.js';
import type { Frustum } from '../../geometry/frustum-clip.js';
import { add, length, subtract, type Vec3 } from '../../math/vector.js';
import type { Cut, CutName } from './cut-faces.js';
import { coarsestOf, type GeometryName, type Round, roundOf, trianglesOf } from './shapes.js';

/** Most that an outline may be off the round shape, in device pixels: in the plain picture. */
const OUTLINE_TOLERANCE = 1 / 4;

/**
 * The same in the samples of a still picture, whose mean shows an eighth of a plain picture's
 * error.
 */
const SAMPLED_TOLERANCE = 1 / 64;

/** The same in the pixels of a picture that moves with fewer: a triangle costs as much as 16. */
const REDUCED_TOLERANCE = 1;

/**
 * Fewest pixels of a plain picture that a triangle covers, on average over its shape. Smaller ones
 * cost as much.
 */
const PIXELS_PER_TRIANGLE = 16;

/**
 * Most of the triangles that are never too many, for each pixel that a shape covers: a dot needs
 * none.
 */
const FREE_PER_PIXEL = 8;

/**
 * A flat shape is large if its longest side is more than this many times the eye's distance from
 * its box. Rasterisers interpolate positions over a triangle with errors that grow with the
 * triangle. In SwiftShader, under near lamps, 17 of 68,805 channels are off by more than one code
 * at 8, by up to 3; at 10 they are off by up to 134, at 1,000 34 % are off.
 */
const LARGE = 8;

/** Whether a flat shape under its world matrix is {@link LARGE} for the eye. */
export function isLargeFor(view: Frustum, name: GeometryName, m: readonly number[]): boolean {
  measureFrom(view, name, m);
  return measured.longest > LARGE * measured.distance;
}

/** Whether none of the flat shapes inside these bounds can be {@link LARGE} for the eye. */
export function hasNoLarge({ frame: { origin, eye } }: Frustum, bounds: Extent['bounds']): boolean {
  if (bounds === null) return true;
  const { center, radius } = bounds;
  const distance = length(subtract(add(origin, eye), center)) - radius;
  return LARGE * distance > 2 * radius;
}

/**
 * How a large box or plane is cut for this eye. Cubes stand on a grid of half their unit, a power
 * of two near the eye's distance, so that an eye that moves a little finds the same cut.
 */
export function cutFor(view: Frustum, name: CutName, m: readonly number[]): Cut {
  measureFrom(view, name, m);
  const { along, length, longest, distance } = measured;
  const near = Math.max(distance, longest * LEAST_UNIT);
  let unit = 1;
  while (1.5 * unit < near) {
    unit *= 2;
  }
  while (0.75 * unit > near) {
    unit /= 2;
  }
  const place = (axis: 0 | 1 | 2) =>
    length[axis] > 0 ? ((Math.round((2 * along[axis]) / unit) / 2) * unit) / length[axis] : 0;
  const reach = (axis: 0 | 1 | 2) => (length[axis] > 0 ? (2 * unit) / length[axis] : 1);
  return {
    center: [place(0), place(1), place(2)],
    half: [reach(0), reach(1), reach(2)],
  };
}

/** Share of the longest side: coordinates on it are float32. */
const LEAST_UNIT = 2 ** -24;

/** Overwritten by each call of {@link measureFrom}. */
const measured = {
  /** The eye along the axes of the shape, from its middle, and the lengths of its sides. */
  along: [0, 0, 0] as [number, number, number],
  length: [0, 0, 0] as [number, number, number],
  longest: 0,
  /** Distance of the eye from the walls of the shape's box, on either side. */
  distance: 0,
};

function measureFrom(
  { frame: { origin, eye } }: Frustum,
  name: GeometryName,
  m: readonly number[],
) {
  const x = origin[0] + eye[0] - m[12]!;
  const y = origin[1] + eye[1] - m[13]!;
  const z = origin[2] + eye[2] - m[14]!;
  let outside = 0; // squared
  let inside = Infinity;
  measured.longest = 0;
  for (const axis of [0, 1, 2] as const) {
    const length = columnLength(m, axis);
    const half = name === 'plane' && axis === 1 ? 0 : length / 2;
    const along =
      length > 0 ? (x * m[4 * axis]! + y * m[4 * axis + 1]! + z * m[4 * axis + 2]!) / length : 0;
    const beyond = Math.abs(along) - half;
    measured.along[axis] = along;
    measured.length[axis] = length;
    measured.longest = Math.max(measured.longest, 2 * half);
    if (beyond > 0) {
      outside += beyond * beyond;
    } else {
      inside = Math.min(inside, -beyond);
    }
  }
  measured.distance = outside > 0 ? Math.sqrt(outside) : inside;
}

/**
 * The level of a shape; null out of view. `free`: triangles that it may have however small they
 * are.
 */
export function levelIn(
  view: Frustum,
  height: number,
  sampled: boolean,
  name: GeometryName,
  matrix: readonly number[],
  free: number,
): number | null {
  const round = roundOf(name)!;
  const pixels = height / (2 * view.slopeY);
  const tolerance = sampled ? SAMPLED_TOLERANCE : OUTLINE_TOLERANCE;
  const outline = segmentsIn(view, pixels / tolerance, round, matrix);
  if (outline === null) return null;
  const covered = coveredIn(view, height, round, matrix);
  const most = Math.max(covered / PIXELS_PER_TRIANGLE, Math.min(free, FREE_PER_PIXEL * covered));
  const shown = within(most, levelFor(Math.max(outline, round.smooth), name), name);
  return sampled ? Math.max(shown, levelFor(outline, name)) : shown;
}

/** The level of a shape in a reduced picture of this height. Only its outline counts. */
export function reducedLevelIn(
  view: Frustum,
  height: number,
  name: GeometryName,
  matrix: readonly number[],
): number {
  const finest = height / (2 * view.slopeY) / REDUCED_TOLERANCE;
  return levelFor(segmentsIn(view, finest, roundOf(name)!, matrix) ?? 0, name);
}

/**
 * Segments of a shape as fine as in the samples of a still picture, whatever pixels it covers; null
 * unless it is round. `pixels`: of a unit of length at depth 1.
 */
export function sampledSegments(
  view: Frustum,
  pixels: number,
  name: GeometryName,
  matrix: readonly number[],
): number | null {
  const round = roundOf(name);
  if (round === undefined) return null;
  const outline = segmentsIn(view, pixels / SAMPLED_TOLERANCE, round, matrix) ?? 0;
  return levelFor(Math.max(outline, round.smooth), name);
}

/** The step from a level of about this many segments to the next. */
function stepAt(segments: number): number {
  let step = 8;
  while (8 * step < segments) {
    step *= 2;
  }
  return step;
}

/**
 * The least level with at least `segments`. Levels are multiples of 8; above 64, multiples of an
 * eighth of the next power of two. So a level has at most a quarter more than needed, and a camera
 * that comes near passes few levels.
 */
export function levelFor(segments: number, name: GeometryName): number {
  const least = coarsestOf(name);
  const { most } = roundOf(name)!;
  if (segments >= most) return most;
  const step = stepAt(segments);
  const level = Math.ceil(segments / step) * step;
  return level > least ? Math.min(level, most) : least;
}

/**
 * The finest level up to `level` with at most `triangles`; the coarsest one if none has so few.
 */
export function within(triangles: number, level: number, name: GeometryName): number {
  const least = coarsestOf(name);
  if (trianglesOf(name, least) >= triangles) return least;
  while (trianglesOf(name, level) > triangles) {
    level = levelFor(level - stepAt(level), name);
  }
  return level;
}

/**
 * Pixels that a shape covers, about: its mean share of the ellipse that its bounding sphere is seen
 * as, at most the picture. The ellipse grows with the angle from the view's middle: at a fov of 170
 * up to a thousand times.
 */
function coveredIn(
  view: Frustum,
  height: number,
  { cover, radius }: Round,
  m: readonly number[],
): number {
  const { frame, slopeX, slopeY } = view;
  const { origin, eye, back } = frame;
  const picture = (height * height * slopeX) / slopeY;
  const x = m[12]! - origin[0] - eye[0];
  const y = m[13]! - origin[1] - eye[1];
  const z = m[14]! - origin[2] - eye[2];
  const depth = -(x * back[0] + y * back[1] + z * back[2]);
  const reach = radius * stretch(m);
  if (depth <= reach) return picture;
  const ahead = depth * depth - reach * reach;
  const beyond = x * x + y * y + z * z - reach * reach; // squared: from the eye to where its rays touch the sphere
  const disc = (reach * height) / (2 * slopeY);
  const ellipse = (Math.PI * disc * disc * Math.sqrt(beyond / ahead)) / ahead;
  return Math.min(picture, cover * ellipse);
}

/**
 * Segments that keep a round shape's outline close enough to the true one; 0: no outline is in
 * view; null: the shape is not. `finest`: how many times the allowed distance goes into a unit of
 * length at depth 1.
 */
export function segmentsIn(
  view: Frustum,
  finest: number,
  round: Round,
  m: readonly number[],
): number | null {
  const { frame, slopeX, slopeY } = view;
  const { gap, half, radius } = round;
  const { origin, eye, right, up, back } = frame;
  // From the eye to the shape's middle.
  const x = m[12]! - origin[0] - eye[0];
  const y = m[13]! - origin[1] - eye[1];
  const z = m[14]! - origin[2] - eye[2];
  const depth = -(x * back[0] + y * back[1] + z * back[2]);
  const across = Math.abs(x * right[0] + y * right[1] + z * right[2]);
  const upward = Math.abs(x * up[0] + y * up[1] + z * up[2]);
  const size = stretch(m);
  const reach = size * radius;
  if (across - slopeX * depth > reach * Math.sqrt(1 + slopeX * slopeX)) return null;
  if (upward - slopeY * depth > reach * Math.sqrt(1 + slopeY * slopeY)) return null;
  if (depth < -reach) return null;
  const squared = x * x + y * y + z * z;
  const distance = Math.sqrt(squared);
  const ball = isBall(half, m, reach);
  // Where the eye's rays touch a ball; other shapes may reach up to the front of their sphere.
  const away = ball ? Math.sqrt(Math.abs(squared - reach * reach)) : distance - reach;
  const outline = Math.max(away, NEAREST * reach);
  // The farther from the middle of the view, the more pixels an angle has.
  const corner = 1 / Math.sqrt(1 + slopeX * slopeX + slopeY * slopeY);
  let cos = corner;
  if (distance > reach) {
    const sinReach = reach / distance;
    const cosReach = Math.sqrt(1 - sinReach * sinReach);
    // A ball that fills the picture, the farthest corner too, shows no outline.
    if (ball && (depth - slopeX * across - slopeY * upward) * corner > cosReach * distance) {
      return 0;
    }
    const sinMiddle = Math.sqrt(across * across + upward * upward) / distance;
    cos = Math.max(cos, (depth / distance) * cosReach - sinMiddle * sinReach);
  }
  return Math.sqrt((gap * size * finest) / (outline * cos * cos));
}

/**
 * The nearest outline that counts, in radii of the bounding sphere. An eye so close sees faces,
 * most outlines are farther away, and slivers narrower than a pixel are shaded worse than wider
 * triangles.
 */
const NEAREST = 1 / 8;

/** Whether a shape is still a ball, of radius `reach`, under its matrix. */
function isBall(half: Vec3, m: readonly number[], reach: number): boolean {
  for (let axis = 0; axis < 3; axis++) {
    if (Math.abs(half[axis as 0] * columnLength(m, axis) - reach) > ROUNDING * reach) return false;
  }
  return true;
}

function columnLength(m: readonly number[], axis: number): number {
  const x = m[4 * axis]!;
  const y = m[4 * axis + 1]!;
  const z = m[4 * axis + 2]!;
  return Math.sqrt(x * x + y * y + z * z);
}

/** Relative. A turned ball's axes are equal up to float64's rounding. */
const ROUNDING = 1e-9;
