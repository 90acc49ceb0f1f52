// Results of benches that never ran: for tests of what is made of results.
import type { Front, Point } from '../bench/front.mjs';
import type { BenchResult } from '../bench/result-file.mjs';
import type { Spread } from '../bench/statistics.mjs';

/** Quartiles are 5 % below and 10 % above the median; figures of error go with the first, unless given. */
export const pointOf = (id: string, ms: number, rmse: number, more: Partial<Point['error']> = {}): Point => ({
  id,
  label: `variant ${id}`,
  time: { median: ms, low: 0.95 * ms, high: 1.1 * ms, count: 9 },
  ratio: { median: ms / 10, low: ms / 10.5, high: ms / 9, count: 9 },
  error: {
    ...{ pixels: 100, rmse, p999: 3 * rmse, max: 5 * rmse, share: rmse / 100 },
    ...{ deltaE: rmse / 9, deltaEMax: rmse, flip: rmse / 200, ...more },
  },
});

/** Its base is called `exact`, what ships `fast`. */
export const frontOf = (points: Point[]): Front => ({
  ...{ axis: 'loops', scene: '8 mixed', title: 'Eight mixed lights', base: 'exact', shipped: 'fast' },
  ...{ truth: 'the equation in float64', measure: 'GPU timer', size: [480, 360], errorSize: [240, 180] },
  points,
});

/** A run that measured no more than it is given. */
export const resultOf = (parts: Partial<BenchResult>): BenchResult => ({
  machine: { cpu: '2 × some CPU', browser: 'Chromium 140', renderer: 'some GPU', revision: 'abc1234' },
  ...{ seed: 1, launches: 5, rounds: 3 },
  ...{ fronts: [], growth: [], peers: [], figures: {} },
  ...parts,
});

/** Quartiles 2 % about the median. */
export const about = (median: number, count = 9): Spread => ({
  ...{ median, count },
  low: 0.98 * median,
  high: 1.02 * median,
});
