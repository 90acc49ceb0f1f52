// What becomes of a bench run's samples: fronts, growth, charts, comparisons and the report.
import { describe, expect, test } from 'vitest';
import { dominated, frontier } from '../bench/front.mjs';
import { growthOf } from '../bench/growth.mjs';
import { spread } from '../bench/statistics.mjs';
import { pointOf } from './bench-made-up.js';

describe('a front', () => {
  test('leaves out what another variant beats in time or error and loses to in neither', () => {
    const points = [
      pointOf('exact', 10, 0),
      pointOf('slow', 12, 1),
      pointOf('rough', 5, 2),
      pointOf('worse', 5, 3),
      pointOf('late', 6, 2),
    ];
    expect([...dominated(points)].sort()).toEqual(['late', 'slow', 'worse']);
    expect(frontier(points).map(({ id }) => id)).toEqual(['rough', 'exact']);
  });

  test('keeps variants that are equal in both', () => {
    const points = [pointOf('a', 5, 1), pointOf('b', 5, 1), pointOf('c', 7, 1)];
    expect([...dominated(points)]).toEqual(['c']);
  });

  test('keeps the only one', () => {
    expect(dominated([pointOf('a', 5, 1)]).size).toBe(0);
  });

  test('can be of another error', () => {
    const points = [pointOf('a', 5, 1, { flip: 0.3 }), pointOf('b', 6, 2, { flip: 0.1 })];
    expect([...dominated(points)]).toEqual(['b']);
    expect([...dominated(points, 'flip')]).toEqual([]);
  });
});

describe('growth', () => {
  test.each([
    ['linear', 1],
    ['quadratic', 2],
    ['constant', 0],
    ['with the root', 0.5],
  ])('that is %s has the slope %d', (_, power) => {
    const samples = [1, 4, 16, 64, 256].map((at) => ({ at, ms: [3 * at ** power] }));
    const { slope, slopeUpper } = growthOf('shade', 'lights', 'GPU timer', samples);
    // Rounding of the logarithms: measured 4.4e-16.
    expect(slope).toBeCloseTo(power, 14);
    expect(slopeUpper).toBeCloseTo(power, 14);
  });

  test('has its slope from medians, and its upper slope from the larger counts alone', () => {
    const ms = [[4], [4], [9, 8, 7], [16], [32]];
    const samples = [1, 2, 4, 8, 16].map((at, i) => ({ at, ms: ms[i]! })).reverse();
    const { points, slope, slopeUpper } = growthOf('shade', 'lights', 'clock', samples, 'a note');
    expect(points.map(({ at }) => at)).toEqual([1, 2, 4, 8, 16]);
    expect(points[2]!.time).toEqual(spread([7, 8, 9]));
    expect(slopeUpper).toBeCloseTo(1, 14);
    // log2: 2, 2, 3, 4, 5 over 0 … 4.
    expect(slope).toBeCloseTo(0.8, 14);
  });

  test.each([
    ['one count', [{ at: 4, ms: [1] }], 'one count has no slope'],
    [
      'a count twice',
      [
        { at: 4, ms: [1] },
        { at: 4, ms: [2] },
        { at: 8, ms: [2] },
      ],
      'a count twice',
    ],
    [
      'no time',
      [
        { at: 4, ms: [0] },
        { at: 8, ms: [2] },
      ],
      '0 ms at 4 lights',
    ],
    [
      'no samples',
      [
        { at: 4, ms: [] },
        { at: 8, ms: [2] },
      ],
      'NaN ms at 4 lights',
    ],
  ])('is not made of %s', (_, samples, message) => {
    expect(() => growthOf('shade', 'lights', 'clock', samples)).toThrow(message);
  });
});
