// @ts-check
// The figures of whole pictures: names of measures and sides in results, and what report, charts
// and the site read from them.

import { ratioOf, rowOf, valueOf } from './results.mjs';

/** What a picture is compared with, as measures. `triangles`: those that it draws itself. */
export const RMSE = /** @type {const} */ ({ triangles: 'RMSE', round: 'RMSE to the round shape' });
export const WITHIN = 'pixels within one code';
export const TIME = 'time to the picture';
/** The side that times are divided by. */
export const PLAIN = 'edges';
/**
 * The end of the names of passes that average the equation's codes; without it they average linear
 * light, as shipped.
 */
export const CODES = ', codes';

/** The numbers of samples of `full`. */
export const FULL = [16, 64, 256];
/** @param {number} samples */
export const full = (samples) => `full, ${samples} samples`;
/** Samples of SSAARenderPass, by its levels. */
export const SSAA = [1, 2, 4, 8, 16, 32];
/** @param {number} samples */
export const ssaa = (samples) => `SSAARenderPass, ${samples}`;
/** Pictures that TAARenderPass shows: of the change, and after each accumulation. */
export const TAA = Array.from({ length: 33 }, (_, k) => k);
export const TAA_PASS = 'TAARenderPass';
/** @param {number} accumulated */
export const taa = (accumulated) => `${TAA_PASS}, ${accumulated}`;
export const MULTISAMPLED = 'three.js, 4 samples';

/** The lines of a chart. Passes have a second line, of the codes' averages. */
export const SERIES = [
  { series: 'phong-viewer', sides: [PLAIN, ...FULL.map(full)] },
  { series: 'SSAARenderPass', sides: SSAA.map(ssaa) },
  { series: TAA_PASS, sides: TAA.map(taa) },
  { series: MULTISAMPLED, sides: [MULTISAMPLED] },
];

/** @typedef {{ time: number, error: number, series: string, codes: boolean }} PicturePoint */

/**
 * Median of a side; undefined where it was not measured. @param
 * {import('./results.mjs').BenchResult} result @param {string} subject @param {string} measure
 * @param {string} side
 */
export function pictureValue(result, subject, measure, side) {
  const row = rowOf(result, subject, measure);
  return row !== undefined && side in row.samples ? valueOf(row, side).median : undefined;
}

/**
 * Time to a side's picture, the plain one = 1. @param {import('./results.mjs').BenchResult} result
 * @param {string} subject @param {string} side
 */
export function pictureTime(result, subject, side) {
  const row = rowOf(result, subject, TIME);
  const shipped = side.endsWith(CODES) ? side.slice(0, -CODES.length) : side;
  if (row === undefined || !(shipped in row.samples)) return undefined;
  return ratioOf(row, shipped)?.median ?? 1;
}

/**
 * All pictures of a subject, line by line. @param {import('./results.mjs').BenchResult} result
 * @param {string} subject @returns {PicturePoint[]}
 */
export const picturePoints = (result, subject) =>
  SERIES.flatMap(({ series, sides }) =>
    ['', CODES].flatMap((end) =>
      sides.flatMap((side) => {
        const time = pictureTime(result, subject, side);
        const error = pictureValue(result, subject, RMSE.triangles, `${side}${end}`);
        return time === undefined || error === undefined
          ? []
          : [{ time, error, series, codes: end !== '' }];
      }),
    ),
  );
