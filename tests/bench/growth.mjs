// @ts-check
// How a time grows with a count: the slope of its logarithm against the count's, 1 where twice as much takes twice as long.

import { spread } from './statistics.mjs';

/**
 * @typedef {object} Growth
 * @property {string} name
 * @property {string} unit of `at`: lights, pixels, …
 * @property {import('./front.mjs').Measure} measure
 * @property {{ at: number, time: import('./statistics.mjs').Spread }[]} points ms, fewest first
 * @property {number} slope least squares over the medians of all points
 * @property {number} slopeUpper the same over the upper half, where what a frame costs at the least counts for little
 * @property {string} [note]
 */

/**
 * @param {string} name @param {string} unit @param {import('./front.mjs').Measure} measure
 * @param {readonly { at: number, ms: readonly number[] }[]} samples of at least two counts; counts and times > 0
 * @param {string} [note]
 * @returns {Growth}
 */
export function growthOf(name, unit, measure, samples, note) {
  const points = [...samples].sort((a, b) => a.at - b.at).map(({ at, ms }) => ({ at, time: spread(ms) }));
  for (const { at, time } of points) {
    if (!(at > 0 && time.median > 0)) throw new RangeError(`${name}: ${time.median} ms at ${at} ${unit}`);
  }
  const counts = new Set(points.map(({ at }) => at)).size;
  if (counts < 2) throw new RangeError(`${name}: one count has no slope`);
  if (counts < points.length) throw new RangeError(`${name}: a count twice`);
  const upper = points.slice(Math.min(Math.floor(points.length / 2), points.length - 2));
  return {
    ...{ name, unit, measure, points },
    slope: slopeOf(points),
    slopeUpper: slopeOf(upper),
    ...(note === undefined ? {} : { note }),
  };
}

/**
 * A slope with how far the quartiles of its times let it tilt: the lower counts up and the higher ones down, and the other
 * way round.
 * @param {Growth['points']} points fewest first
 * @returns {import('./statistics.mjs').Spread}
 */
export function slopeSpread(points) {
  const middle = mean(points.map(({ at }) => Math.log(at)));
  /** @param {'low' | 'high'} few @param {'low' | 'high'} many */
  const tilted = (few, many) => slopeOf(points, ({ at, time }) => time[Math.log(at) < middle ? few : many]);
  return {
    median: slopeOf(points),
    low: tilted('high', 'low'),
    high: tilted('low', 'high'),
    count: points.length,
  };
}

/** @param {Growth['points']} points @param {(point: Growth['points'][number]) => number} [msOf] */
function slopeOf(points, msOf = ({ time }) => time.median) {
  const x = points.map(({ at }) => Math.log(at));
  const y = points.map((point) => Math.log(msOf(point)));
  const [centerX, centerY] = [mean(x), mean(y)];
  const along = x.reduce((sum, value, i) => sum + (value - centerX) * ((y[i] ?? NaN) - centerY), 0);
  return along / x.reduce((sum, value) => sum + (value - centerX) ** 2, 0);
}

/** @param {readonly number[]} numbers */
const mean = (numbers) => numbers.reduce((sum, x) => sum + x, 0) / numbers.length;
