// What does one turn of the wheel, or one key, do to the camera? Pure laws: degrees and zoom factors out, no events kept.

import type { Pose } from './orbit.js';
import { turnBy, zoomBy } from './drag.js';
import type { RadiusLimits } from './drag.js';

/** What of a wheel event counts. */
export interface WheelTurn {
  readonly deltaY: number;
  /** 0 pixels, 1 lines, 2 pages, as in the DOM. */
  readonly deltaMode: number;
}

/** CSS pixels of a wheel's line: what three.js's OrbitControls takes, and the browsers' default font size. */
const LINE_PIXELS = 16;

const WHEEL_RATE = 0.001;
const KEY_ZOOM = 1.1;
const KEY_DEGREES = 5;
const KEY_DEGREES_FINE = 1;

/** The radius times exp(0.001 · pixels): turns add up, and turns back take away. `height` is a page, in CSS pixels. */
export function wheelZoom(noted: Pose, wheel: WheelTurn, height: number, limits: RadiusLimits): Pose {
  const unit = wheel.deltaMode === 1 ? LINE_PIXELS : wheel.deltaMode === 2 ? height : 1;
  return zoomBy(noted, Math.exp(WHEEL_RATE * wheel.deltaY * unit), limits);
}

/** What a key means to the camera; degrees are added to θ and φ, a factor multiplies the radius. */
export type KeyStep =
  | { readonly kind: 'turn'; readonly theta: number; readonly phi: number }
  | { readonly kind: 'zoom'; readonly factor: number }
  | { readonly kind: 'reset' };

/** The meaning of `KeyboardEvent.key`, `undefined` for a key that is none of the camera's. */
export function keyStep(key: string, shiftKey: boolean): KeyStep | undefined {
  const degrees = shiftKey ? KEY_DEGREES_FINE : KEY_DEGREES;
  switch (key) {
    // As a drag that way: to the right lowers θ, down lowers φ.
    case 'ArrowRight':
      return { kind: 'turn', theta: -degrees, phi: 0 };
    case 'ArrowLeft':
      return { kind: 'turn', theta: degrees, phi: 0 };
    case 'ArrowDown':
      return { kind: 'turn', theta: 0, phi: -degrees };
    case 'ArrowUp':
      return { kind: 'turn', theta: 0, phi: degrees };
    // '=' and '_' are the same two keys with Shift the other way round on most layouts.
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
export function keyPose(noted: Pose, step: Exclude<KeyStep, { kind: 'reset' }>, limits: RadiusLimits): Pose {
  return step.kind === 'turn' ? turnBy(noted, step.theta, step.phi) : zoomBy(noted, step.factor, limits);
}
