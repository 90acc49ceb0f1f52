// @ts-check
// A logarithmic axis: where a value lies on it, and which values are written beside it.

/**
 * @typedef {object} Axis
 * @property {(value: number) => number} at pixel of a value > 0
 * @property {readonly number[]} ticks
 */

/**
 * From the least value at pixel `from` to the largest at `to`, with some room beyond both.
 * @param {readonly number[]} values > 0; none: a decade about 1
 * @param {number} from @param {number} to pixels
 * @param {number} gap least pixels between ticks
 * @returns {Axis}
 */
export function logAxis(values, from, to, gap) {
  const [least, most] = values.length > 0 ? [Math.min(...values), Math.max(...values)] : [0.3, 3];
  // Where all values are about the same, noise is not to fill the chart.
  const room = Math.max((most / least) ** 0.06, 1.1);
  const [low, high] = [Math.log(least / room), Math.log(most * room)];
  const at = (/** @type {number} */ value) => from + ((to - from) * (Math.log(value) - low)) / (high - low);
  return { at, ticks: ticksOf(Math.exp(low), Math.exp(high), at, gap) };
}

/**
 * The most that stand `gap` apart: of decades, of every few decades, of 1-2-5; of even steps where the range is so narrow
 * that these are too few.
 * @param {number} low @param {number} high @param {Axis['at']} at @param {number} gap
 */
function ticksOf(low, high, at, gap) {
  const [first, last] = [Math.floor(Math.log10(low)), Math.ceil(Math.log10(high))];
  const exponents = Array.from({ length: last - first + 1 }, (_, i) => first + i);
  const digits = (/** @type {number} */ e) => [1, 2, 5].map((digit) => Number(`${digit}e${e}`));
  const most = (/** @type {readonly (readonly number[])[]} */ choices) =>
    choices
      .map((choice) => choice.filter((value) => value >= low && value <= high))
      .filter((choice) =>
        choice.every((value, i) => i === 0 || Math.abs(at(value) - at(choice[i - 1] ?? NaN)) >= gap),
      )
      .reduce((best, choice) => (choice.length > best.length ? choice : best), []);
  const decades = [1, 2, 3, 4, 6].map((n) =>
    exponents.filter((e) => e % n === 0).map((e) => Number(`1e${e}`)),
  );
  const usual = most([...decades, exponents.flatMap(digits)]);
  if (usual.length >= ENOUGH) return usual;
  const steps = exponents.flatMap((e) => digits(e - 2)).filter((step) => (high - low) / step < MANY);
  return most([usual, ...steps.map((step) => multiples(step, low, high))]);
}

/** Fewer ticks do not show that the axis is logarithmic; with more even steps than `MANY` it is hard to read. */
const ENOUGH = 3;
const MANY = 7;

/** @param {number} step @param {number} low @param {number} high */
const multiples = (step, low, high) =>
  Array.from({ length: Math.floor(high / step) - Math.ceil(low / step) + 1 }, (_, i) =>
    Number(((Math.ceil(low / step) + i) * step).toPrecision(12)),
  );
