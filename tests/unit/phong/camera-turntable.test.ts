// Is auto-rotate a pure function of elapsed time that restarts whenever something else turns the
// camera?

import { describe, expect, it } from 'vitest';
import { Orbit } from '../../../src/phong/camera/orbit.js';
import { turnedBy, Turntable } from '../../../src/phong/camera/turntable.js';
import { wrapDegrees } from '../../../src/phong/math/angle.js';
import { repeats, SEED } from '../../support/repeats.js';
import { seeded } from '../../visual/random-scene.js';

const HOUR = 3_600_000;
/** Twelve in a release run. */
const HOURS = repeats(12);

/**
 * Doubles of at least 2^-40 are integer multiples of 2^-92, which a BigInt holds without rounding.
 */
const SCALE = 92;
const fixed = (x: number): bigint => BigInt(x * 2 ** 52 * 2 ** (SCALE - 52));

/** Start plus speed times elapsed time, modulo whole turns, exact until one rounding at the end. */
function exactDegrees(start: number, speed: number, from: number, to: number): number {
  const turn = (360_000n << BigInt(SCALE)) << BigInt(SCALE);
  const thousandfold = (1000n * fixed(start)) << BigInt(SCALE);
  const turned = (thousandfold + fixed(speed) * (fixed(to) - fixed(from))) % turn;
  // 60 fractional bits are far more than the double keeps.
  return Number(turned >> BigInt(2 * SCALE - 60)) / 2 ** 60 / 1000;
}

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
 * Elapsed milliseconds of up to 18 hours (2^26 ms) are rounded to 2^-27 ms, half of it at worst: no
 * more is lost, for any number of frames. Measured: 1.1e-10 degrees at 30 per second, 7.2e-9 at
 * 4321.9; the products add less than 1e-12.
 */
const bound = (speed: number): number => (Math.abs(speed) / 1000) * 2 ** -28 + 1e-12;

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
    // Integers of 200 bits are slow: check one frame in a thousand, and the last.
    if (frame % 1000 > 0 && time < BEGIN + HOURS * HOUR) continue;
    const exact = exactDegrees(12.5, speed, begin, time);
    drift = Math.max(drift, Math.abs(wrapDegrees(orbit.theta - exact)));
  }
  return { drift, outermost };
}

describe(`${HOURS} hours of turning (seed ${SEED})`, () => {
  it.each(FRAMES)(
    'end at the exact angle at $name, within one rounding of the time, and θ stays within a turn',
    ({ next }) => {
      for (const speed of SPEEDS) {
        const { drift, outermost } = turnFor(next, speed);
        expect(drift, `${speed} degrees a second`).toBeLessThan(bound(speed));
        expect(outermost).toBeLessThan(360);
      }
      expect(bound(30)).toBeLessThan(1e-9);
    },
    60_000,
  );
});

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

  it.each([
    [1, 1e15, true],
    [1, -1e15, true],
    [1, 2e15, false],
    [1, NaN, false],
    [1, Infinity, false],
    [NaN, 9, false],
    [Infinity, 9, false],
    [0, 9, false],
  ])('%d ms at %d degrees a second move the camera: %s', (time, speed, moves) => {
    const { orbit, step } = setUp(30);
    step(0, speed);
    expect(step(time, speed)).toBe(moves);
    expect(orbit.theta === 30).toBe(!moves);
  });

  it('ignores one bad frame', () => {
    const { orbit, step } = setUp();
    step(0);
    for (const bad of [NaN, Infinity]) {
      expect([step(bad), step(500, bad)]).toStrictEqual([false, false]);
    }
    step(1000);
    expect(orbit.theta).toBe(10);
  });

  it('keeps its angle small forever', () => {
    expect(Math.abs(turnedBy(360.001, 1e12))).toBeLessThan(360);
  });
});
