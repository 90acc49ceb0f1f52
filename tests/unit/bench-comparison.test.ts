// What moved between two bench runs: only what moved by more than the noise of both, and all that cannot be compared is said.
import { describe, expect, test, vi } from 'vitest';
import { comparisonOf, movedBeyondNoise, printComparison, type Change } from '../bench/compare-results.mjs';
import { comparisonText } from '../bench/comparison-text.mjs';
import { growthOf } from '../bench/growth.mjs';
import { about, frontOf, pointOf, resultOf } from './bench-made-up.js';

describe('what moved between two runs', () => {
  const front = frontOf([pointOf('exact', 10, 0.5), pointOf('fast', 4, 0.2), pointOf('rough', 2, 9)]);
  const changed = (
    id: string,
    change: (point: (typeof front.points)[0]) => (typeof front.points)[0],
  ): typeof front => ({
    ...front,
    points: front.points.map((point) => (point.id === id ? change(point) : point)),
  });
  const compare = (a: Parameters<typeof resultOf>[0], b: Parameters<typeof resultOf>[0]) =>
    comparisonOf(resultOf(a), resultOf(b));
  const moved = (changes: readonly Change[]): string[] =>
    changes.filter((change) => change.moved).map(({ name, what }) => `${name}: ${what}`);

  test('is more than both ranges: apart, and by more than the wider', () => {
    const spread = (median: number, low: number, high: number) => ({ ...{ median, low, high }, count: 9 });
    expect(movedBeyondNoise(spread(10, 9, 11), spread(13, 12, 14))).toBe(true);
    expect(movedBeyondNoise(spread(13, 12, 14), spread(10, 9, 11))).toBe(true);
    expect(movedBeyondNoise(spread(10, 9, 11), spread(12, 11, 13))).toBe(false);
    expect(movedBeyondNoise(spread(10, 9.9, 11), spread(12, 11.1, 14))).toBe(false);
  });

  test('is nothing between a run and itself', () => {
    const run = {
      ...{
        fronts: [front],
        growth: [
          growthOf(
            'all',
            'lights',
            'GPU timer',
            [1, 8].map((at) => ({ at, ms: [at] })),
          ),
        ],
      },
      peers: [
        { what: 'start', peer: 'A-Frame', version: '1', unit: 'ms', value: about(80), ratio: about(3) },
      ],
      figures: {
        frame: [{ name: '8', unit: 'ms', value: about(1), peer: about(2), ratio: about(0.5), atMost: 0.6 }],
      },
    };
    const { changes, machine, onlyBefore, onlyAfter, incomparable } = compare(run, run);
    expect(moved(changes)).toEqual([]);
    expect([machine, onlyBefore, onlyAfter, incomparable]).toEqual([[], [], [], []]);
    // Three points' milliseconds and RMSE, two ratios to the base, a slope, two counts, a peer and a figure.
    expect(changes).toHaveLength(3 * 2 + 2 + 1 + 2 + 1 + 1);
  });

  test('is a time, as the ratio to the base', () => {
    const slower = changed('fast', (point) => ({ ...point, ratio: about(0.9) }));
    const { changes } = compare({ fronts: [front] }, { fronts: [slower] });
    expect(moved(changes)).toEqual(['variant fast: time / base']);
  });

  test('is no time within the noise', () => {
    const noisy = changed('fast', (point) => ({ ...point, ratio: about(0.42) }));
    expect(moved(compare({ fronts: [front] }, { fronts: [noisy] }).changes)).toEqual([]);
  });

  test('is a time in milliseconds only where the GPU’s own timer counted', () => {
    const run = (measure: typeof front.measure, factor: number) => ({
      fronts: [
        {
          ...front,
          measure,
          points: front.points.map((point) => ({ ...point, time: about(factor * point.time.median) })),
        },
      ],
    });
    const timer = compare(run('GPU timer', 1), run('GPU timer', 2));
    expect(moved(timer.changes)).toEqual(['variant exact: ms', 'variant fast: ms', 'variant rough: ms']);
    const clock = compare(run('clock', 1), run('clock', 2));
    expect(clock.changes.map(({ what }) => what)).not.toContain('ms');
    expect(moved(clock.changes)).toEqual([]);
  });

  test('is an error by more than a hundredth, each figure by itself', () => {
    const error = (factor: number) =>
      changed('fast', (point) => ({ ...point, error: { ...point.error, flip: factor * point.error.flip } }));
    expect(moved(compare({ fronts: [front] }, { fronts: [error(1.009)] }).changes)).toEqual([]);
    expect(moved(compare({ fronts: [front] }, { fronts: [error(0.98)] }).changes)).toEqual([
      'variant fast: FLIP',
    ]);
  });

  test('is an error that was nothing', () => {
    const exact = changed('fast', (point) => ({ ...point, error: { ...point.error, rmse: 0 } }));
    const comparison = compare({ fronts: [exact] }, { fronts: [front] });
    expect(moved(comparison.changes)).toEqual(['variant fast: RMSE']);
    expect(comparisonText(comparison)).toMatch(/variant fast +RMSE +0 +0\.2 +from 0 +MOVED/);
  });

  test('leaves alone what was measured of something else, and says so', () => {
    const other = { ...front, size: [800, 600] as const, truth: 'another truth' };
    const { changes, incomparable } = compare({ fronts: [front] }, { fronts: [other] });
    expect(changes).toEqual([]);
    expect(incomparable).toEqual([
      'loops, 8 mixed: times, of another size: 480,360 before, 800,600 after',
      'loops, 8 mixed: errors, of another truth: the equation in float64 before, another truth after',
    ]);
  });

  test('lists what only one run has', () => {
    const fewer = { ...front, points: front.points.slice(0, 2) };
    const { onlyBefore, onlyAfter } = compare(
      { fronts: [front] },
      { fronts: [fewer, { ...front, scene: '64 mixed' }] },
    );
    expect(onlyBefore).toEqual(['loops, 8 mixed: rough']);
    expect(onlyAfter).toEqual(['loops, 64 mixed']);
  });

  test('is a slope, over the counts that both have', () => {
    const growth = (power: number, counts: readonly number[]) => ({
      growth: [
        growthOf(
          'all',
          'lights',
          'clock',
          counts.map((at) => ({ at, ms: [at ** power, 1.02 * at ** power] })),
        ),
      ],
    });
    const { changes } = compare(growth(1, [1, 4, 16]), growth(1.5, [4, 16, 64]));
    expect(moved(changes)).toEqual(['all: slope']);
    expect(changes[0]!.after.median).toBeCloseTo(1.5, 12);
    expect(compare(growth(1, [1, 4]), growth(1, [4, 16])).incomparable).toEqual([
      'growth with lights: all: slopes, of other counts',
    ]);
  });

  test('is a peer’s ratio, with its versions; its milliseconds alone are not compared', () => {
    const row = (version: string, ratio: number | null, unit = 'ms') => ({
      peers: [
        {
          what: 'start',
          peer: 'A-Frame',
          ...{ version, unit, value: about(80) },
          ...(ratio === null ? {} : { ratio: about(ratio) }),
        },
      ],
    });
    const { changes } = compare(row('1.7', 3), row('1.8', 4));
    expect(changes).toMatchObject([{ moved: true, note: '1.7 before, 1.8 after' }]);
    expect(compare(row('1.7', null), row('1.7', null)).incomparable).toEqual([
      'start, ms: A-Frame: ms without a ratio',
    ]);
    expect(compare(row('1.7', null, 'KiB'), row('1.7', null, 'KiB')).changes).toHaveLength(1);
  });

  test('is a peer that could be measured only once', () => {
    const row = (count: number) => ({
      peers: [{ what: 'lit', peer: 'X_ITE', version: '1', unit: 'ms', value: about(80, count) }],
    });
    expect(compare(row(0), row(3)).incomparable).toEqual(['lit, ms: X_ITE: measured only after']);
  });

  test('is a figure’s ratio, with the aim that it now misses or meets', () => {
    const figure = (ratio: number) => ({
      figures: {
        frame: [
          { name: '8 lights', unit: 'ms', value: about(1), peer: about(2), ratio: about(ratio), atMost: 0.5 },
        ],
      },
    });
    expect(compare(figure(0.49), figure(0.51)).changes).toMatchObject([
      { moved: false, note: 'misses 0.5 now' },
    ]);
    expect(compare(figure(0.6), figure(0.4)).changes).toMatchObject([{ moved: true, note: 'meets 0.5 now' }]);
  });

  test('is printed as a table, after what differs of the machines', () => {
    const slower = changed('fast', (point) => ({ ...point, ratio: about(0.9) }));
    const before = resultOf({ fronts: [front] });
    const after = resultOf({
      fronts: [slower],
      seed: 2,
      machine: { ...before.machine, revision: 'def5678' },
    });
    const log = vi.spyOn(console, 'log').mockImplementation(() => undefined);
    printComparison(before, after);
    const text = log.mock.calls.flat().join('\n');
    log.mockRestore();
    expect(text).toContain('revision: abc1234 before, def5678 after');
    expect(text).toContain('seed: 1 before, 2 after');
    expect(text).toMatch(
      /variant fast +time \/ base +0\.4 \(0\.381–0\.444\) +0\.9 \(0\.882–0\.918\) +\+125\.0 % +MOVED/,
    );
    expect(text).toContain('1 of 8 moved by more than the noise of both runs:');
  });

  test('tells rows of one name apart by their order, and by what was asked', () => {
    const row = (rmse: number, note: string) => ({
      ...{ what: 'distance', peer: 'A-Frame', version: '1', unit: '/255', note },
      value: { median: rmse, low: rmse, high: rmse, count: 1 },
    });
    const { changes } = compare(
      { peers: [row(24, 'as it comes'), row(1.6, 'unencoded')] },
      { peers: [row(24, 'as it comes'), row(1.2, 'unencoded')] },
    );
    expect(changes).toMatchObject([
      { name: 'A-Frame', moved: false },
      { name: 'A-Frame (2)', moved: true, note: 'unencoded' },
    ]);
  });
});
