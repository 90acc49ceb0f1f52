// Is auto-rotate a pure function of elapsed time that restarts whenever something else turns the
// camera?

import { describe, expect, it } from 'vitest';
import { Orbit } from '../../../src/phong/camera/orbit.js';
import { Turntable } from '../../../src/phong/camera/turntable.js';
import { wrapDegrees } from '../../../src/phong/math/angle.js';
import { repeats, SEED } from '../../support/repeats.js';
import { seeded } from '../../visual/random-scene.js';

const HOUR = 3_600_000;
/** Twelve in a release run. */
const HOURS = repeats(12);

/**
 * The time of a frame in ms, as from `requestAnimationFrame`, from its number and the time of the
 * last one.
 */
type Next = (frame: number, before: number, random: () => number) => number;

/** When the page was opened, on the page's clock. */
const BEGIN = 1234.567;
const FRAMES: readonly { readonly name: string; readonly next: Next }[] = [
  { name: '60 Hz', next: (frame) => BEGIN + (frame * 1000) / 60 },
  { name: '144 Hz', next: (frame) => BEGIN + (frame * 1000) / 144 },
  // Browsers round the clock to 0.1 ms, unless the page is cross-origin isolated.
  {
    name: '60 Hz by a rounded clock',
    next: (frame) => Math.round(10 * (BEGIN + (frame * 1000) / 60)) / 10,
  },
  // A busy page: most frames come soon, some after a second.
  { name: 'irregular frames', next: (_, before, random) => before + 4 + 1000 * random() ** 8 },
];

/** Degrees per second; the last is twelve turns per second, more than screens can show. */
const SPEEDS = [30, -0.1, 4321.9];

/**
 * Degrees. A double of 2e8 degrees, which the fastest one turns in twelve hours, is rounded by 3e-8.
 */
const BOUND = 1e-7;

/** Largest error of a turning orbit in {@link HOURS}, and its largest |θ|. */
function turnFor(next: Next, speed: number) {
  const orbit = new Orbit({ theta: 12.5 });
  const table = new Turntable();
  const random = seeded(SEED);
  let time = next(0, BEGIN, random);
  const begin = time;
  let drift = 0;
  let outermost = 0;
  table.step(orbit, time, speed);
  for (let frame = 1; time < BEGIN + HOURS * HOUR; frame++) {
    time = next(frame, time, random);
    table.step(orbit, time, speed);
    outermost = Math.max(outermost, Math.abs(orbit.theta));
    const exact = 12.5 + (((time - begin) % (360_000 / speed)) * speed) / 1000;
    drift = Math.max(drift, Math.abs(wrapDegrees(orbit.theta - exact)));
  }
  return { drift, outermost };
}

it.each(FRAMES)(
  `${HOURS} hours of turning (seed ${SEED}) end at the angle of the time at $name, and θ stays within a turn`,
  ({ next }) => {
    for (const speed of SPEEDS) {
      const { drift, outermost } = turnFor(next, speed);
      expect(drift, `${speed} degrees a second`).toBeLessThan(BOUND);
      expect(outermost).toBeLessThan(360);
    }
  },
  60_000,
);

describe('a turntable', () => {
  function setUp(theta = 0) {
    const orbit = new Orbit({ theta });
    const table = new Turntable();
    return { orbit, table, step: (time: number, speed = 10) => table.step(orbit, time, speed) };
  }

  it('continues from where the user left the camera', () => {
    const { orbit, step } = setUp();
    step(0);
    step(1000);
    expect(orbit.theta).toBe(10);
    orbit.set({ theta: 90 });
    expect(step(2000)).toBe(false);
    expect(orbit.theta).toBe(90);
    expect(step(3000)).toBe(true);
    expect(orbit.theta).toBe(100);
  });

  it('is not disturbed by zooming, tilting or shifting', () => {
    const { orbit, step } = setUp();
    step(0);
    orbit.set({ radius: 2, phi: 5, target: [1, 1, 1] });
    step(1000);
    expect(orbit.pose).toStrictEqual({ theta: 10, phi: 5, radius: 2, target: [1, 1, 1] });
  });

  it('counts an hour without frames', () => {
    const { orbit, step } = setUp();
    step(0, 7.31);
    step(HOUR, 7.31);
    expect(orbit.theta).toBeCloseTo(36, 8);
  });

  it('does not jump after a rest or a change of speed', () => {
    const { orbit, table, step } = setUp();
    step(0);
    step(1000);
    table.rest();
    step(9000);
    expect(orbit.theta).toBe(10);
    step(10_000, -10);
    expect(orbit.theta).toBe(10);
    step(11_000, -10);
    expect(orbit.theta).toBe(0);
  });
});
