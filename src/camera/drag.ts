// Where does the camera go when pointers have travelled so far? Pure laws from the noted pose and the total travel to a new
// pose: nothing accumulates, and no travel gives the noted pose itself. Travel in CSS pixels, right and down positive;
// angles in degrees, lengths in scene units. Whatever the numbers, the result is finite: where it would not be, nothing moves.

import { cosDegrees, sinDegrees, wrapDegrees } from '../math/angle.js';
import { basisOf, clampLength } from './orbit.js';
import type { Pose } from './orbit.js';

/** The picture that is dragged on. */
export interface View {
  /** CSS pixels. 0 where nothing is shown: no travel moves the camera then. */
  readonly width: number;
  readonly height: number;
  /** Vertical field of view, degrees, 1 to 170. */
  readonly fov: number;
}

/** How near and how far zooming may go, scene units, both above 0. */
export interface RadiusLimits {
  readonly min: number;
  readonly max: number;
}

/** One width is 360° of azimuth, one height 180° of polar angle; the shape follows the pointer. φ stops at the poles. */
export function turn(noted: Pose, dx: number, dy: number, { width, height }: View): Pose {
  if (!(width > 0 && height > 0)) return noted;
  return turnBy(noted, -(360 * dx) / width, -(180 * dy) / height);
}

/** Angles added to the noted ones, in degrees; φ stops at the poles. */
export function turnBy(noted: Pose, dTheta: number, dPhi: number): Pose {
  if ((dTheta === 0 && dPhi === 0) || !Number.isFinite(dTheta) || !Number.isFinite(dPhi)) return noted;
  return {
    ...noted,
    // Wrapped first: a turn added to 1e20 degrees would be lost in rounding.
    theta: dTheta === 0 ? noted.theta : wrapDegrees(noted.theta) + dTheta,
    phi: clamp(noted.phi + dPhi, 0, 180),
  };
}

/** The target moves in the picture's plane so that the point of its plane that was under the pointer stays there. */
export function shift(noted: Pose, dx: number, dy: number, view: View): Pose {
  if (dx === 0 && dy === 0) return noted;
  const step = worldPerPixel(noted.radius, view);
  const { right, up } = basisOf(noted);
  const along = (i: 0 | 1 | 2): number => clampLength(noted.target[i] + step * (up[i] * dy - right[i] * dx));
  const target = [along(0), along(1), along(2)] as const;
  return target.every(Number.isFinite) ? { ...noted, target } : noted;
}

/** Scene units that one CSS pixel spans in the plane through the target; not finite where no picture is shown. */
export function worldPerPixel(radius: number, { height, fov }: View): number {
  return height > 0 ? (2 * radius * sinDegrees(fov / 2)) / (cosDegrees(fov / 2) * height) : NaN;
}

/** Two fingers: their distance at the start over the present one, so that what they hold grows and shrinks with them. */
export function pinch(noted: Pose, startGap: number, gap: number, limits: RadiusLimits): Pose {
  // Fingers that started on one spot have no ratio.
  return startGap > 0 && startGap !== gap ? zoomBy(noted, startGap / gap, limits) : noted;
}

/** The radius times a factor, kept within the limits; a radius already beyond them may come back, and go no further. */
export function zoomBy(noted: Pose, factor: number, limits: RadiusLimits): Pose {
  const nearest = Math.min(limits.min, noted.radius);
  const farthest = Math.max(limits.max, noted.radius);
  const radius = clamp(noted.radius * factor, nearest, farthest);
  return radius > 0 && Number.isFinite(radius) ? { ...noted, radius } : noted;
}

const clamp = (x: number, low: number, high: number): number => Math.min(Math.max(x, low), high);
