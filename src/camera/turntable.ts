// What azimuth does a scene that turns by itself show at a time? The angle noted when it began, plus speed times elapsed
// time: never a sum of frames, so nothing drifts. Degrees, degrees per second, times in milliseconds of one clock. It asks for no
// frame itself.

import type { Orbit } from './orbit.js';

export class Turntable {
  #noted: { readonly theta: number; readonly time: number; readonly speed: number } | undefined;
  #shown = NaN;
  readonly #change = { theta: 0 };

  /**
   * Turns the orbit to its place at `time`; `speed` in degrees per second, positive raises θ. The first step after `rest`, after
   * someone else changed θ or after a change of speed notes anew and moves nothing. Gives true where the orbit moved.
   */
  step(orbit: Orbit, time: number, speed: number): boolean {
    if (!Number.isFinite(time) || !(Math.abs(speed) <= FASTEST)) return false;
    const noted = this.#noted;
    if (noted === undefined || noted.speed !== speed || orbit.theta !== this.#shown) {
      this.#noted = { theta: orbit.theta % 360, time, speed };
      this.#shown = orbit.theta;
      return false;
    }
    const before = orbit.version;
    this.#change.theta = (noted.theta + turnedBy(speed, time - noted.time)) % 360;
    orbit.set(this.#change);
    this.#shown = orbit.theta;
    return orbit.version !== before;
  }

  /** The turning stands still from here (a drag, off screen, speed 0): the time until the next `step` does not count. */
  rest(): void {
    this.#noted = undefined;
  }
}

/** Degrees per second; beyond it nothing turns, for the products below would leave float64. */
const FASTEST = 1e15;

/**
 * Speed times elapsed time, less whole turns. The product is split so that its large part is exact in float64 (24 bits of
 * speed times up to 29 bits of whole milliseconds) and loses its whole turns before anything is rounded: after six days,
 * and at any usual speed, the error is still near 1e-12 degrees.
 */
export function turnedBy(degreesPerSecond: number, milliseconds: number): number {
  const coarse = Math.fround(degreesPerSecond);
  const whole = Math.trunc(milliseconds);
  const large = (coarse * whole) % 360_000;
  const small = (degreesPerSecond - coarse) * whole + degreesPerSecond * (milliseconds - whole);
  return ((large + small) / 1000) % 360;
}
