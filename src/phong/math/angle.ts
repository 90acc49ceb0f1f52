// Degrees to radians, and sine and cosine of degrees that are exact at multiples of 90°.
import { cosSmall, sinSmall } from './elementary.js';

const RADIANS_PER_DEGREE = Math.PI / 180;
export const radians = (degrees: number): number => degrees * RADIANS_PER_DEGREE;

/** The same direction in [-180, 180), for any finite number of degrees. Exact: the remainder is. */
export function wrapDegrees(degrees: number): number {
  const turned = degrees % 360;
  if (turned >= 180) return turned - 360;
  return turned < -180 ? turned + 360 : turned;
}

/**
 * Sine of degrees. The angle is reduced before it becomes radians, so that multiples of 90° give 0
 * and ±1 exactly.
 */
export function sinDegrees(degrees: number): number {
  const d = wrapDegrees(degrees);
  if (d > 90) return sinFirstQuadrants(180 - d);
  if (d < -90) return sinFirstQuadrants(-180 - d);
  return sinFirstQuadrants(d);
}

/** Cosine of degrees, exact at multiples of 90°. */
export function cosDegrees(degrees: number): number {
  const d = Math.abs(wrapDegrees(degrees));
  return d <= 90 ? sinFirstQuadrants(90 - d) : -sinFirstQuadrants(d - 90);
}

/** Sine for |d| ≤ 90. Beyond 45° the cosine of the complement is better conditioned. */
function sinFirstQuadrants(d: number): number {
  if (d > 45) return cosSmall(radians(90 - d));
  if (d < -45) return -cosSmall(radians(90 + d));
  return sinSmall(radians(d));
}
