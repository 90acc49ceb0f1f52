// Is vector algebra in float64 right, with unit vectors for everything that has a direction?

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  add,
  cross,
  dot,
  length,
  multiply,
  negate,
  normalize,
  scale,
  subtract,
  type Vec3,
} from '../../src/math/vector.js';
import { numbers, plainVector, triple } from './arbitraries.js';

const A: Vec3 = [1, 2, 3];
const B: Vec3 = [4, -5, 6];
const anyVector = triple(numbers(-1e15, 1e15));

it('adds, subtracts, scales and multiplies by component', () => {
  expect(add(A, B)).toStrictEqual([5, -3, 9]);
  expect(subtract(A, B)).toStrictEqual([-3, 7, -3]);
  expect(scale(A, -2)).toStrictEqual([-2, -4, -6]);
  expect(multiply(A, B)).toStrictEqual([4, -10, 18]);
  expect(negate(B)).toStrictEqual([-4, 5, -6]);
  expect(dot(A, B)).toBe(12);
  expect(length([2, 3, 6])).toBe(7);
});

describe('the cross product', () => {
  it('is right-handed', () => {
    expect(cross([1, 0, 0], [0, 1, 0])).toStrictEqual([0, 0, 1]);
    expect(cross([0, 1, 0], [0, 0, 1])).toStrictEqual([1, 0, 0]);
    expect(cross(A, B)).toStrictEqual([27, 6, -13]);
  });

  it('is perpendicular to both factors', () => {
    fc.assert(
      fc.property(plainVector, plainVector, (a, b) => {
        const c = cross(a, b);
        expect(Math.abs(dot(c, a)) + Math.abs(dot(c, b))).toBeLessThan(1e-11);
      }),
    );
  });
});

describe('the length', () => {
  it('neither overflows nor underflows in between', () => {
    expect(length([3e200, 4e200, 0])).toBeCloseTo(5e200, -187);
    expect(length([3e-200, 0, 4e-200]) / 5e-200).toBeCloseTo(1, 15);
    expect(length([5e-324, 0, 0])).toBe(5e-324);
    expect(length([0, 0, 0])).toBe(0);
  });
});

describe('normalizing', () => {
  it('gives zero for zero', () => {
    expect(normalize([0, 0, 0])).toStrictEqual([0, 0, 0]);
  });

  it.each<[Vec3, Vec3]>([
    [
      [5e-324, 0, 0],
      [1, 0, 0],
    ],
    [
      [0, -1e308, 0],
      [0, -1, 0],
    ],
    [
      [0, 3e-320, 4e-320],
      [0, 0.6, 0.8],
    ],
    [
      [1e308, 1e308, 1e308],
      [1 / Math.sqrt(3), 1 / Math.sqrt(3), 1 / Math.sqrt(3)],
    ],
  ])('finds the direction of %j', (v, unit) => {
    const got = normalize(v);
    // 3e-320 and 4e-320 are themselves rounded to steps of 5e-324.
    got.forEach((x, i) => {
      expect(Math.abs(x - unit[i]!)).toBeLessThan(1e-4);
    });
    expect(Math.abs(length(got) - 1)).toBeLessThan(4e-16);
  });

  it('gives a unit vector for anything but zero', () => {
    fc.assert(
      fc.property(anyVector, (v) => {
        fc.pre(v.some((x) => x !== 0));
        expect(Math.abs(length(normalize(v)) - 1)).toBeLessThan(5e-16);
      }),
    );
  });

  it('gives the same bits at every power of two, and for every exact multiple', () => {
    const whole = triple(fc.integer({ min: -1000, max: 1000 }));
    fc.assert(
      fc.property(
        whole,
        fc.integer({ min: -900, max: 900 }),
        fc.integer({ min: 1, max: 99 }),
        (v, k, times) => {
          const unit = normalize(v);
          expect(normalize(scale(v, 2 ** k)).map((x) => x + 0)).toStrictEqual(unit.map((x) => x + 0));
          expect(normalize(scale(v, times)).map((x) => x + 0)).toStrictEqual(unit.map((x) => x + 0));
          expect(normalize(negate(v)).map((x) => x + 0)).toStrictEqual(unit.map((x) => 0 - x));
        },
      ),
    );
  });
});
