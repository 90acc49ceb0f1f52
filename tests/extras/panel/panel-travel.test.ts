// Do sliders cover the right range, and are numbers formatted as a person would write them?

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { linear, logarithmic, numberText } from '../../../src/extras/panel/travel.js';
import { niceCeil } from '../../../src/phong/math/round-number.js';
import { between } from '../../unit/arbitraries.js';

const positive = between(1e-12, 1e15);

it('rounds up to 1, 2 or 5 times a power of ten, at most 2.5 times as large', () => {
  fc.assert(
    fc.property(positive, (n) => {
      const nice = niceCeil(n);
      expect(nice).toBeGreaterThanOrEqual(n * (1 - 1e-8));
      expect(nice).toBeLessThanOrEqual(2.5 * n * (1 + 1e-8));
      expect(nice.toPrecision(3)).toMatch(/^[0.]*[125][0.]*(e[+-]\d+)?$/);
    }),
  );
  const nice = [0.001, 0.2, 1, 5, 200, 1e15];
  expect(nice.map(niceCeil)).toEqual(nice);
});

describe.each([
  ['linear', linear(-5, 5)],
  ['logarithmic', logarithmic(1, 1e6)],
])('a %s travel', (_name, travel) => {
  it('converts between place and value within a step', () => {
    fc.assert(
      fc.property(between(travel.start, travel.end), (place) => {
        expect(Math.abs(travel.place(travel.value(place)) - place)).toBeLessThanOrEqual(
          travel.step,
        );
      }),
    );
  });

  it('grows to include any value, and does not change if it already does', () => {
    fc.assert(
      fc.property(positive, (value) => {
        const wide = travel.reaching(value);
        expect(wide.place(value)).toBeLessThanOrEqual(wide.end * (1 + 1e-12));
        expect(wide.reaching(value)).toBe(wide);
        expect((wide.end - wide.start) / wide.step).toBeGreaterThan(20);
      }),
    );
    expect(travel.reaching(travel.value(travel.end))).toBe(travel);
  });
});

it('grows downwards too if linear', () => {
  expect(linear(-1, 1).reaching(-30)).toMatchObject({ start: -50, end: 1 });
});

it('starts at exactly 0, ends at exactly its maximum and steps by about a tenth of the value if logarithmic', () => {
  const travel = logarithmic(1, 1e6);
  expect([travel.value(0), travel.value(1)]).toEqual([0, 1e6]);
  expect([0, 0.5, 3, 32, 320, 65536].map(travel.stepAt)).toEqual([0.1, 0.01, 0.1, 1, 10, 1000]);
});

it('writes numbers without stray digits, and rounding noise as 0', () => {
  const numbers = [0.1 + 0.2, 1 / 3, 1e6, 65536, -0, 1e-7, 1e15, 400 / 255];
  expect(numbers.map((n) => numberText(n)).join(' ')).toBe(
    '0.3 0.333333 1000000 65536 0 1e-7 1000000000000000 1.56863',
  );
  expect([6.1e-17, 1e-7].map((n) => numberText(n, 4))).toEqual(['0', '1e-7']);
});
