// Do the numbers in the line on the first screen add up as they are shown?
import { describe, expect, it } from 'vitest';
import { shownSum, type Triple } from '../../demo/front/digits.js';
import { Random } from '../stress/random.js';

describe('the digits of a pixel’s sum', () => {
  it.each([3, 5, 11])('give the sum that is shown, with %i terms (seed 53)', (count) => {
    const random = new Random(53);
    let most = 0;
    for (let i = 0; i < 300; i++) {
      const terms = Array.from({ length: count }, (): Triple => {
        const lit = random.chance(0.7);
        return lit ? random.vector(0, 1) : [0, 0, 0];
      });
      const { terms: shown, sum } = shownSum(terms);
      for (const channel of [0, 1, 2] as const) {
        const typed = shown.reduce((all, term) => all + Number(term[channel]), 0);
        expect(Math.round(Number(typed.toFixed(8)))).toBe(sum[channel]);
        expect(Math.abs(sum[channel] - 255 * terms.reduce((all, t) => all + t[channel], 0))).toBeLessThanOrEqual(0.5 + 1e-9); // oxfmt-ignore
        for (const [at, term] of terms.entries()) {
          const decimals = shown[at]![channel]!.split('.')[1]!.length;
          most = Math.max(most, decimals);
          expect(shown[at]![channel]).toBe((Math.round(255 * term[channel] * 10 ** decimals) / 10 ** decimals).toFixed(decimals)); // oxfmt-ignore
        }
      }
    }
    expect(most).toBeLessThanOrEqual(5);
  });

  it('take one decimal where one is enough, and another where it is not', () => {
    const codes = (...values: readonly number[]): readonly Triple[] =>
      values.map((value) => [value / 255, 0, 0]);
    expect(shownSum(codes(12.3, 40.4)).terms.map(([red]) => red)).toEqual(['12.3', '40.4']);
    // 12.3 + 40.2 would be 52.5, which rounds to 53.
    expect(shownSum(codes(12.26, 40.16)).terms.map(([red]) => red)).toEqual(['12.26', '40.16']);
  });
});
