// The sRGB transfer curve: its published points, its two branches, and that encoding undoes
// decoding.

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { SRGB, srgbDecode, srgbEncode } from '../../../src/phong/math/color.js';
import { between } from '../arbitraries.js';

describe('the sRGB curve', () => {
  it('has the middle greys of published tables, and goes on above 1 by its power branch', () => {
    expect([srgbDecode(1), srgbEncode(1)]).toStrictEqual([1, expect.closeTo(1, 15)]);
    expect(srgbDecode(0.5)).toBeCloseTo(0.21404114048223255, 15);
    expect(srgbEncode(0.18)).toBeCloseTo(0.46135612950044164, 15);
    expect(srgbDecode(2)).toBeCloseTo((2.055 / 1.055) ** 2.4, 14);
    expect(srgbEncode(9)).toBeCloseTo(1.055 * 9 ** (1 / 2.4) - 0.055, 14);
    expect(srgbDecode(128 / 255) * 1e4).toBeCloseTo(2158.605, 3);
  });

  it('is a straight line below the knee', () => {
    expect(srgbDecode(0.02)).toBe(0.02 / 12.92);
    expect(srgbEncode(0.001)).toBe(0.001 * 12.92);
    expect(srgbDecode(SRGB.encodedKnee)).toBe(SRGB.encodedKnee / SRGB.slope);
    expect(srgbEncode(SRGB.linearKnee)).toBe(SRGB.linearKnee * SRGB.slope);
  });

  it.each([0, -0, -1, -Infinity, NaN])('makes 0 of %d', (x) => {
    expect(srgbDecode(x)).toBe(0);
    expect(srgbEncode(x)).toBe(0);
  });

  it('is undone by its inverse, from black to the brightest light', () => {
    const thousandths = fc.integer({ min: 0, max: 1000 }).map((n) => n / 1000);
    fc.assert(
      fc.property(fc.oneof(thousandths, between(0, 4000)), (x) => {
        // The two published knees do not meet exactly: 2e-9 of step.
        expect(Math.abs(srgbEncode(srgbDecode(x)) - x)).toBeLessThan(3e-8 + 1e-14 * x);
        expect(Math.abs(srgbDecode(srgbEncode(x)) - x)).toBeLessThan(3e-9 + 1e-14 * x);
      }),
    );
  });
});
