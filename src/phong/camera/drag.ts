// What a drag, a wheel event or a key does to the camera: pure functions to a new pose. Those of a
// drag take the pose at its start and the total travel since then, so zero travel returns the start
// pose itself. Travel in CSS pixels, right and down positive; angles in degrees, lengths in scene
// units. A travel to a pose that is not finite moves nothing.
import { cosDegrees, sinDegrees, wrapDegrees } from '../math/angle.js';
import { clamp } from '../math/vector.js';
import { basisOf, clampLength, type Pose } from './orbit.js';

/** The picture under the pointer. */
export interface PictureFrame {
  /** CSS pixels. 0 while the element is not displayed; a drag then moves nothing. */
  readonly width: number;
  readonly height: number;
  /** Vertical field of view, degrees, 1 to 170. */
  readonly fov: number;
}

/** Limits of the zoom, scene units, both above 0. */
export interface RadiusLimits {
  readonly min: number;
  readonly max: number;
}

/**
 * One width is 360°, one height 180°; the shape follows the pointer. Without a size no angle is
 * finite: no turn.
 */
export const turn = (start: Pose, dx: number, dy: number, { width, height }: PictureFrame): Pose =>
  turnBy(start, -(360 * dx) / width, -(180 * dy) / height);

/** Adds angles in degrees to those of the start pose. φ stops at the poles. */
function turnBy(start: Pose, dTheta: number, dPhi: number): Pose {
  if ((dTheta === 0 && dPhi === 0) || !Number.isFinite(dTheta) || !Number.isFinite(dPhi)) {
    return start;
  }
  return {
    ...start,
    // Wrap first: adding a small turn to 1e20 degrees would lose it to rounding.
    theta: dTheta === 0 ? start.theta : wrapDegrees(start.theta) + dTheta,
    phi: clamp(start.phi + dPhi, 0, 180),
  };
}

/**
 * Moves the target parallel to the picture plane, so that the point under the pointer stays under
 * it.
 */
export function shift(start: Pose, dx: number, dy: number, view: PictureFrame): Pose {
  if (dx === 0 && dy === 0) return start;
  const step = worldPerPixel(start.radius, view);
  const { right, up } = basisOf(start);
  const along = (i: 0 | 1 | 2) =>
    clampLength(start.target[i] + step * (up[i] * dy - right[i] * dx));
  const target = [along(0), along(1), along(2)] as const;
  return target.every(Number.isFinite) ? { ...start, target } : start;
}

/** Scene units per CSS pixel in the plane through the target; NaN if the picture has no height. */
export function worldPerPixel(radius: number, { height, fov }: PictureFrame): number {
  return height > 0 ? (2 * radius * sinDegrees(fov / 2)) / (cosDegrees(fov / 2) * height) : NaN;
}

/** Multiplies the radius by the fingers' distance at the start over their distance now. */
export function pinch(start: Pose, startGap: number, gap: number, limits: RadiusLimits): Pose {
  // Fingers that started on the same pixel have no ratio.
  return startGap > 0 && startGap !== gap ? zoomBy(start, startGap / gap, limits) : start;
}

/**
 * Multiplies the radius within the limits. A radius already outside them can come back but not move
 * farther out.
 */
export function zoomBy(start: Pose, factor: number, limits: RadiusLimits): Pose {
  const nearest = Math.min(limits.min, start.radius);
  const farthest = Math.max(limits.max, start.radius);
  const radius = clamp(start.radius * factor, nearest, farthest);
  return radius > 0 && Number.isFinite(radius) ? { ...start, radius } : start;
}

/**
 * CSS pixels per line of a wheel event: the browsers' default font size, also used by three.js's
 * OrbitControls.
 */
const LINE_PIXELS = 16;

/**
 * Change of the radius's logarithm for each CSS pixel of the wheel; factor of the radius, and
 * degrees of a turn, for each press of a key.
 */
const WHEEL_RATE = 0.001;
/** A trackpad's pinch arrives as a wheel event with Ctrl, and with a tenth of a wheel's pixels. */
const PINCH_RATE = 0.01;
const KEY_ZOOM = 1.1;
const KEY_DEGREES = 5;
const KEY_DEGREES_FINE = 1;

/**
 * Multiplies the radius by exp(0.001 · pixels), by exp(0.01 · pixels) with Ctrl: turning back
 * undoes turning forth. `height`: a page, CSS pixels.
 */
export function wheelZoom(
  start: Pose,
  { deltaY, deltaMode, ctrlKey }: Pick<WheelEvent, 'deltaY' | 'deltaMode' | 'ctrlKey'>,
  height: number,
  limits: RadiusLimits,
): Pose {
  const unit = [1, LINE_PIXELS, height][deltaMode] ?? 1;
  return zoomBy(start, Math.exp((ctrlKey ? PINCH_RATE : WHEEL_RATE) * deltaY * unit), limits);
}

/** What a key does: degrees are added to θ and φ, a factor multiplies the radius. */
type KeyStep =
  | { readonly kind: 'turn'; readonly theta: number; readonly phi: number }
  | { readonly kind: 'zoom'; readonly factor: number }
  | { readonly kind: 'reset' };

/** The step for a `KeyboardEvent.key`; `undefined` if the camera does not use the key. */
export function keyStep(key: string, shiftKey: boolean): KeyStep | undefined {
  const degrees = shiftKey ? KEY_DEGREES_FINE : KEY_DEGREES;
  switch (key) {
    // As a drag in that direction: right lowers θ, down lowers φ.
    case 'ArrowRight':
      return { kind: 'turn', theta: -degrees, phi: 0 };
    case 'ArrowLeft':
      return { kind: 'turn', theta: degrees, phi: 0 };
    case 'ArrowDown':
      return { kind: 'turn', theta: 0, phi: -degrees };
    case 'ArrowUp':
      return { kind: 'turn', theta: 0, phi: degrees };
    // '=' and '_' share the keys of '+' and '-' on most layouts.
    case '+':
    case '=':
    case 'PageUp':
      return { kind: 'zoom', factor: 1 / KEY_ZOOM };
    case '-':
    case '_':
    case 'PageDown':
      return { kind: 'zoom', factor: KEY_ZOOM };
    case 'Home':
      return { kind: 'reset' };
    default:
      return undefined;
  }
}

/** The pose after a turning or zooming key. */
export function keyPose(
  start: Pose,
  step: Exclude<KeyStep, { kind: 'reset' }>,
  limits: RadiusLimits,
): Pose {
  return step.kind === 'turn'
    ? turnBy(start, step.theta, step.phi)
    : zoomBy(start, step.factor, limits);
}
