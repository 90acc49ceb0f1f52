// @ts-check
// What is said of repeated measurements: quantiles, and ratios of samples that were taken side by
// side. Knows no unit.

/**
 * Linear between neighbours, so that few samples have quartiles too.
 * @param {readonly number[]} numbers @param {number} share 0 to 1
 */
function quantile(numbers, share) {
  const sorted = [...numbers].sort((a, b) => a - b);
  const at = share * (sorted.length - 1);
  const low = sorted[Math.floor(at)] ?? NaN;
  const high = sorted[Math.ceil(at)] ?? NaN;
  return low + (high - low) * (at - Math.floor(at));
}

/** @param {readonly number[]} numbers */
export const median = (numbers) => quantile(numbers, 0.5);

/**
 * @typedef {{ median: number, low: number, high: number, count: number }} Spread
 * The quartiles of `numbers` around their median.
 * @param {readonly number[]} numbers
 * @returns {Spread}
 */
export const spread = (numbers) => ({
  median: median(numbers),
  low: quantile(numbers, 0.25),
  high: quantile(numbers, 0.75),
  count: numbers.length,
});

/**
 * Ratios within rounds: what disturbs a whole round disturbs both of a pair.
 * @param {readonly number[]} ours @param {readonly number[]} theirs of the same rounds
 */
export const pairedRatios = (ours, theirs) => ours.map((sample, i) => sample / (theirs[i] ?? NaN));

/**
 * A list in the order of a round: every other one is backwards, so that no entry always follows the
 * same one.
 * @template T
 * @param {readonly T[]} list @param {number} round
 */
export const inTurns = (list, round) => (round % 2 === 0 ? list : list.toReversed());

/**
 * Rounds of samples, one of each subject a round, in turns.
 * @template S, T
 * @param {readonly S[]} subjects @param {number} rounds
 * @param {(subject: S) => Promise<T>} sample
 * @returns {Promise<T[][]>} [subject][round]
 */
export async function interleaved(subjects, rounds, sample) {
  const samples = subjects.map(() => /** @type {T[]} */ ([]));
  for (let round = 0; round < rounds; round++) {
    for (const [i, subject] of inTurns([...subjects.entries()], round)) {
      samples[i]?.push(await sample(subject));
    }
  }
  return samples;
}
