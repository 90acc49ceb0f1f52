// Degrees: wrapping without loss, and sines and cosines that are exact at the quarter turns.

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { cosDegrees, radians, sinDegrees, wrapDegrees } from '../../../src/phong/math/angle.js';
import { between } from '../arbitraries.js';

const degrees = fc.oneof(
  between(-1e6, 1e6),
  fc.integer({ min: -100_000, max: 100_000 }),
  fc.double({ noNaN: true, noDefaultInfinity: true }),
);

describe('wrapping degrees', () => {
  it('lands in [-180, 180), and leaves what is inside bit for bit', () => {
    expect([wrapDegrees(-180), wrapDegrees(180)]).toStrictEqual([-180, -180]);
    fc.assert(
      fc.property(
        degrees,
        fc.double({ min: -180, max: 180, maxExcluded: true, noNaN: true }),
        (d, inside) => {
          const wrapped = wrapDegrees(d);
          expect(wrapped >= -180 && wrapped < 180).toBe(true);
          for (const x of [wrapped, inside]) {
            expect(wrapDegrees(x)).toBe(x);
          }
        },
      ),
    );
  });

  it('takes off whole turns and nothing else', () => {
    fc.assert(
      fc.property(
        fc.integer({ min: -180 * 8, max: 180 * 8 - 1 }),
        fc.integer(),
        (eighths, turns) => {
          expect(wrapDegrees(eighths / 8 + 360 * turns) + 0).toBe(eighths / 8);
        },
      ),
    );
  });
});

describe('sine and cosine of degrees', () => {
  it.each([
    [0, 0, 1],
    [-90, -1, 0],
    [1e6 * 360 + 90, 1, 0],
  ])('are exact at %d', (d, sine, cosine) => {
    expect(sinDegrees(d) + 0).toBe(sine);
    expect(cosDegrees(d) + 0).toBe(cosine);
  });

  it('agree with the built-in functions to a few roundings, and lie on the unit circle at any angle', () => {
    fc.assert(
      fc.property(between(-180, 180), degrees, (d, any) => {
        expect(Math.abs(sinDegrees(d) - Math.sin(radians(d)))).toBeLessThan(5e-16);
        expect(Math.abs(cosDegrees(d) - Math.cos(radians(d)))).toBeLessThan(5e-16);
        expect(Math.abs(Math.hypot(sinDegrees(any), cosDegrees(any)) - 1)).toBeLessThan(5e-16);
      }),
    );
  });

  it('keep the symmetries of sine and cosine exactly', () => {
    fc.assert(
      fc.property(fc.integer({ min: -2880, max: 2880 }), (eighths) => {
        const d = eighths / 8;
        expect(sinDegrees(-d) + 0).toBe(-sinDegrees(d) + 0); // at 180° the sign of zero differs
        expect(cosDegrees(-d)).toBe(cosDegrees(d));
        expect(sinDegrees(d + 180) + 0).toBe(-sinDegrees(d) + 0);
        expect(sinDegrees(90 - d) + 0).toBe(cosDegrees(d) + 0);
      }),
    );
  });

  it('keep the precision of small angles, and the same one on both sides of 0', () => {
    expect(sinDegrees(-45)).toBe(-sinDegrees(45));
    expect(sinDegrees(1e-300)).toBe(radians(1e-300));
    expect(cosDegrees(90 - 2 ** -40)).toBeCloseTo(radians(2 ** -40), 25);
  });
});
