// What one wheel event or one key does to the camera. Pure functions to degrees and zoom factors; no event is kept.

import type { Pose } from './orbit.js';
import { type RadiusLimits, turnBy, zoomBy } from './drag.js';

/** The fields of a wheel event that are used. */
interface WheelTurn {
  readonly deltaY: number;
  /** 0 pixels, 1 lines, 2 pages, as in the DOM. */
  readonly deltaMode: number;
}

/** CSS pixels per line of a wheel event: the browsers' default font size, also used by three.js's OrbitControls. */
const LINE_PIXELS = 16;

const WHEEL_RATE = 0.001;
const KEY_ZOOM = 1.1;
const KEY_DEGREES = 5;
const KEY_DEGREES_FINE = 1;

/**
 * Multiplies the radius by exp(0.001 · pixels), so turning back undoes turning forth. `height`: one page, CSS pixels.
 */
export function wheelZoom(start: Pose, wheel: WheelTurn, height: number, limits: RadiusLimits): Pose {
  const unit = wheel.deltaMode === 1 ? LINE_PIXELS : wheel.deltaMode === 2 ? height : 1;
  return zoomBy(start, Math.exp(WHEEL_RATE * wheel.deltaY * unit), limits);
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
export function keyPose(start: Pose, step: Exclude<KeyStep, { kind: 'reset' }>, limits: RadiusLimits): Pose {
  return step.kind === 'turn' ? turnBy(start, step.theta, step.phi) : zoomBy(start, step.factor, limits);
}
