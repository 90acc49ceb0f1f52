// Is vector algebra in float64 right, with unit vectors for everything that has a direction?

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  length,
  negate,
  normalize,
  perpendicular,
  scale,
  transformed,
  type Vec3,
} from '../../../src/phong/math/vector.js';
import { numbers, triple } from '../arbitraries.js';

const anyVector = triple(numbers(-1e308, 1e308));

it('takes places and directions through a matrix', () => {
  // Columns; primes, so that no two sums agree.
  const matrix = [2, 3, 5, 0, 7, 11, 13, 0, 17, 19, 23, 0, 29, 31, 37, 1];
  expect(transformed(matrix, 4, 2, 3)).toStrictEqual([
    8 + 14 + 51 + 29,
    12 + 22 + 57 + 31,
    20 + 26 + 69 + 37,
  ]);
  expect(transformed(matrix, 4, 2, 3, 0)).toStrictEqual([8 + 14 + 51, 12 + 22 + 57, 20 + 26 + 69]);
});

// oxfmt-ignore
it.each<[Vec3, Vec3]>([
  [[1, 2, 3], [0, 3, -2]],
  [[-2, 1, 3], [-3, 0, -2]],
  [[3, 2, -1], [2, -3, 0]],
  [[1, 2, 1], [0, 1, -2]],
  [[2, 1, 1], [-1, 0, 2]],
  [[0, 0, 5], [0, 5, 0]],
])('the vector across %j is turned from the axis that it is farthest from: %j', (v, across) => {
  perpendicular(v).forEach((x, i) => expect(x).toBeCloseTo(normalize(across)[i]!, 15));
});

it('has a length that neither overflows nor underflows in between', () => {
  expect(length([2, 3, 6])).toBe(7);
  expect(length([3e200, 4e200, 0])).toBeCloseTo(5e200, -187);
  expect(length([3e-200, 0, 4e-200]) / 5e-200).toBeCloseTo(1, 15);
  expect(length([5e-324, 0, 0])).toBe(5e-324);
  expect(length([0, 0, 0])).toBe(0);
});

describe('normalizing', () => {
  it('gives a unit vector for anything but zero, and zero for zero', () => {
    expect(normalize([0, 0, 0])).toStrictEqual([0, 0, 0]);
    expect(normalize([0, 0, -5e-324])).toStrictEqual([0, 0, -1]);
    fc.assert(
      fc.property(anyVector, (v) => {
        fc.pre(v.some((x) => x !== 0));
        expect(Math.abs(length(normalize(v)) - 1)).toBeLessThan(5e-16);
      }),
    );
  });

  it('gives the same bits at every power of two, and for every exact multiple', () => {
    const whole = triple(fc.integer({ min: -1000, max: 1000 }));
    const power = fc.integer({ min: -900, max: 900 }).map((k) => 2 ** k);
    const positive = (v: Vec3) => v.map((x) => x + 0);
    fc.assert(
      fc.property(whole, fc.oneof(power, fc.integer({ min: 1, max: 99 })), (v, times) => {
        const unit = normalize(v);
        expect(positive(normalize(scale(v, times)))).toStrictEqual(positive(unit));
        expect(positive(normalize(negate(v)))).toStrictEqual(unit.map((x) => 0 - x));
      }),
    );
  });
});
