// Numbers that are easy to read.

/** The smallest of 1, 2 or 5 times a power of ten that is at least `n`; `n` > 0. */
export function niceCeil(n: number): number {
  const power = 10 ** Math.floor(Math.log10(n));
  // The tolerance keeps 0.3 / 0.1 from counting as more than 3.
  const factor = [1, 2, 5, 10].find((f) => n <= f * power * (1 + 1e-9)) ?? 10;
  return tidy(factor * power);
}

/** Removes the stray digits of binary fractions: 0.30000000000000004 becomes 0.3. */
export const tidy = (n: number): number => Number(n.toPrecision(12));
