// The numbers of a camera as markup has them.
import { wrapDegrees } from '../math/angle.js';
import type { Pose } from './orbit.js';

/** A pose as markup has it: angles and lengths of eight digits, the azimuth in [-180, 180). */
export function writtenPose({ theta, phi, radius, target }: Pose): Pose {
  const near = eightDigits(radius, radius);
  const written = (value: number) => eightDigits(value, near);
  return {
    theta: wrapDegrees(written(wrapDegrees(theta))),
    phi: written(phi),
    radius: near,
    target: [written(target[0]), written(target[1]), written(target[2])],
  };
}

/**
 * Rounds to eight digits, counted from the first digit of the value or of the camera's radius,
 * whichever is smaller. The error is below half a step of the float32 numbers that the GPU gets,
 * which are relative to the camera's target.
 */
export function eightDigits(value: number, radius: number): number {
  if (value === 0) return 0;
  const larger = Math.floor(Math.log10(Math.abs(value))) - Math.floor(Math.log10(radius));
  return Number(value.toPrecision(Math.min(8 + Math.max(larger, 0), 17)));
}
