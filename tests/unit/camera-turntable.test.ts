// Turning by itself: a pure function of elapsed time, noted anew whenever someone else turns the camera.

import { describe, expect, it } from 'vitest';
import { Orbit } from '../../src/camera/orbit.js';
import { turnedBy, Turntable } from '../../src/camera/turntable.js';
import { wrapDegrees } from '../../src/math/angle.js';

const HOUR = 3_600_000;

const between = (a: number, b: number): number => Math.abs(wrapDegrees(a - b));

describe('a turntable', () => {
  it('is exact to 1e-9 degrees after twelve hours of uneven frames', () => {
    for (const speed of [30, 7.3, -0.1, 359.9, 1e-3]) {
      const orbit = new Orbit({ theta: 12.5 });
      const table = new Turntable();
      const begin = 1234.567;
      table.step(orbit, begin, speed);
      let time = begin;
      let frame = 0;
      while (time < begin + 12 * HOUR) {
        time += 8 + ((frame++ * 7919) % 13) * 100.1;
        table.step(orbit, time, speed);
      }
      table.step(orbit, begin + 12 * HOUR, speed);
      // speed in whole micro-degrees a second: the turned angle is exact in integers.
      const micro = (BigInt(Math.round(speed * 1e6)) * 43_200n) % 360_000_000n;
      expect(between(orbit.theta, 12.5 + Number(micro) / 1e6)).toBeLessThan(1e-9);
    }
  });

  it('does not depend on the frames between', () => {
    const few = new Orbit();
    const many = new Orbit();
    const [a, b] = [new Turntable(), new Turntable()];
    a.step(few, 0, 20);
    for (let time = 0; time <= 1000; time += 10) b.step(many, time, 20);
    a.step(few, 1000, 20);
    expect(many.theta).toBe(few.theta);
    expect(few.theta).toBe(50);
  });

  it('goes on from where the user left the camera', () => {
    const orbit = new Orbit({ theta: 0 });
    const table = new Turntable();
    table.step(orbit, 0, 10);
    table.step(orbit, 1000, 10);
    expect(orbit.theta).toBe(10);
    orbit.set({ theta: 90 });
    expect(table.step(orbit, 2000, 10)).toBe(false);
    expect(orbit.theta).toBe(90);
    expect(table.step(orbit, 3000, 10)).toBe(true);
    expect(orbit.theta).toBe(100);
  });

  it('is not disturbed by zooming, tilting or shifting', () => {
    const orbit = new Orbit({ theta: 0 });
    const table = new Turntable();
    table.step(orbit, 0, 10);
    orbit.set({ radius: 2, phi: 5, target: [1, 1, 1] });
    table.step(orbit, 1000, 10);
    expect(orbit.pose).toStrictEqual({ theta: 10, phi: 5, radius: 2, target: [1, 1, 1] });
  });

  it('does not jump after a rest or a change of speed', () => {
    const orbit = new Orbit({ theta: 0 });
    const table = new Turntable();
    table.step(orbit, 0, 10);
    table.step(orbit, 1000, 10);
    table.rest();
    table.step(orbit, 9000, 10);
    expect(orbit.theta).toBe(10);
    table.step(orbit, 10_000, -10);
    expect(orbit.theta).toBe(10);
    table.step(orbit, 11_000, -10);
    expect(orbit.theta).toBe(0);
  });

  it('moves nothing for times and speeds that are no numbers', () => {
    const orbit = new Orbit();
    const table = new Turntable();
    table.step(orbit, 0, 10);
    for (const bad of [NaN, Infinity, 1e300]) {
      expect(table.step(orbit, 5, bad)).toBe(false);
      if (bad !== 1e300) expect(table.step(orbit, bad, 10)).toBe(false);
    }
    expect(orbit.theta).toBe(30);
  });

  it('keeps its angle small for ever', () => {
    expect(Math.abs(turnedBy(360.001, 1e12))).toBeLessThan(360);
  });
});
