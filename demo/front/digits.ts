// Digits that add up: as few decimals as it takes for the numbers that are shown to give the sum
// that is shown.
export type Triple = readonly [number, number, number];

export interface ShownSum {
  /** Each term's red, green and blue in codes, 255 as full, all with as many decimals. */
  readonly terms: readonly (readonly string[])[];
  /** Their sum in whole codes. It may exceed 255. */
  readonly sum: Triple;
}

/** More decimals than these help nobody; with five terms one sum in a million needs more. */
const MOST_DECIMALS = 6;

/** @param terms 1 is full */
export function shownSum(terms: readonly Triple[]): ShownSum {
  const sum = whole([0, 1, 2].map((i) => 255 * terms.reduce((all, term) => all + term[i]!, 0)));
  for (let decimals = 1; ; decimals++) {
    const scale = 10 ** decimals;
    // Whole numbers, so that adding them is exact.
    const scaled = terms.map((term) => whole(term.map((value) => 255 * value * scale)));
    const adds = sum.every(
      (value, i) => value === Math.round(scaled.reduce((all, term) => all + term[i]!, 0) / scale),
    );
    if (adds || decimals === MOST_DECIMALS) {
      return { terms: scaled.map((term) => term.map((n) => (n / scale).toFixed(decimals))), sum };
    }
  }
}

const whole = (values: readonly number[]): Triple => values.map(Math.round) as unknown as Triple;
