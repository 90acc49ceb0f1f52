// @ts-check
// Variants of one drawing as points of run time against error, and which of them another makes pointless. Knows neither how
// they were timed nor what the error is against: a front says both in words.

/**
 * @typedef {import('./statistics.mjs').Spread} Spread
 * @typedef {import('./error/error-figures.js').ErrorFigures} ErrorFigures
 * @typedef {'GPU timer' | 'CPU time of the GPU process' | 'clock'} Measure
 *
 * @typedef {object} Point
 * @property {string} id
 * @property {string} label
 * @property {Spread} time ms a frame
 * @property {Spread} ratio to the base variant, paired within rounds
 * @property {ErrorFigures} error
 * @property {string} [note]
 *
 * @typedef {object} Front
 * @property {string} axis what the variants differ in
 * @property {string} scene
 * @property {string} title
 * @property {string} base id of the variant that ratios are to
 * @property {string} [shipped] id of the variant that users get
 * @property {string} truth what the error is against, in words
 * @property {Measure} measure
 * @property {readonly [number, number]} size pixels, timed
 * @property {readonly [number, number]} errorSize pixels of the pictures compared
 * @property {Point[]} points
 */

/**
 * Ids of the points that another point makes pointless: it is no slower and no worse, and better in one. Points that are
 * equal in both stand side by side.
 * @param {readonly Point[]} points
 * @param {keyof ErrorFigures} [key] the error that counts
 * @returns {Set<string>}
 */
export function dominated(points, key = 'rmse') {
  const beats = (/** @type {Point} */ one, /** @type {Point} */ other) => {
    const [faster, better] = [one.time.median - other.time.median, one.error[key] - other.error[key]];
    return faster <= 0 && better <= 0 && (faster < 0 || better < 0);
  };
  return new Set(points.filter((point) => points.some((other) => beats(other, point))).map(({ id }) => id));
}

/**
 * What is left, fastest first: along it, less error costs more time.
 * @param {readonly Point[]} points
 * @param {keyof ErrorFigures} [key]
 */
export function frontier(points, key = 'rmse') {
  const pointless = dominated(points, key);
  return points
    .filter(({ id }) => !pointless.has(id))
    .sort((a, b) => a.time.median - b.time.median || b.error[key] - a.error[key]);
}
