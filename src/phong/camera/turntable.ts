// The azimuth of `auto-rotate` at a given time: the azimuth at the start plus speed times elapsed
// time. Frames are never summed, so nothing drifts. Degrees, degrees per second, milliseconds of
// one clock. Requests no frames itself.
import type { Orbit } from './orbit.js';

export class Turntable {
  #start: { readonly theta: number; readonly time: number; readonly speed: number } | undefined;
  #written = NaN;

  /**
   * Turns the orbit to its azimuth at `time`. `speed` in degrees per second; positive raises θ. The
   * first step after `rest`, after another change of θ and after a change of speed only records a
   * new start. Returns whether the orbit moved.
   */
  step(orbit: Orbit, time: number, speed: number): boolean {
    const start = this.#start;
    if (start === undefined || start.speed !== speed || orbit.theta !== this.#written) {
      this.#start = { theta: orbit.theta % 360, time, speed };
      this.#written = orbit.theta;
      return false;
    }
    const before = orbit.version;
    orbit.set({ theta: (start.theta + (speed * (time - start.time)) / 1000) % 360 });
    this.#written = orbit.theta;
    return orbit.version !== before;
  }

  /**
   * Pauses (during a drag, off screen, at speed 0): the time until the next `step` does not count.
   */
  rest(): void {
    this.#start = undefined;
  }
}
