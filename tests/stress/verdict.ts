// Does what was measured keep the contract?
import { CATEGORIES } from './categories.js';
import { EXACT, WORST_CATEGORY_SHARE, WORST_SHARE } from './contract.js';
import type { Measured } from './measure.js';

/**
 * Each way in which one category breaks the contract, in words; none where it keeps it. `worst`: on
 * a worst lawful driver.
 */
function verdictOf(measured: Measured, worst: boolean): string[] {
  const { title, bound, notFinite, max, wrongCodes } = measured;
  const words: string[] = [];
  if (notFinite > 0) {
    words.push(`${String(notFinite)} channels not finite`);
  }
  if (!(max <= bound)) {
    words.push(`error ${max.toPrecision(3)} above ${String(bound)}`);
  }
  if (wrongCodes > 0) {
    words.push(`${String(wrongCodes)} codes off by more than one`);
  }
  const share = worst ? WORST_CATEGORY_SHARE : EXACT.share;
  if (bound <= EXACT.upTo && !exactEnough(measured, share)) {
    words.push(exactness(measured));
  }
  return words.map((word) => `${title}: ${word}`);
}

/**
 * The same of a run, on a `worst` lawful driver or a real one; the codes of all ordinary categories
 * together only where all took part.
 */
export function verdict(all: readonly Measured[], worst: boolean): string[] {
  const sum = { exact: 0, channels: 0 };
  for (const { exact, channels, bound } of all) {
    if (bound > EXACT.upTo) continue;
    sum.exact += exact;
    sum.channels += channels;
  }
  const broken = all.flatMap((measured) => verdictOf(measured, worst));
  const share = worst ? WORST_SHARE : EXACT.share;
  if (all.length === CATEGORIES.length && !exactEnough(sum, share)) {
    broken.push(`all together: ${exactness(sum)}`);
  }
  return broken;
}

/**
 * Few channels may fall on the wrong side by chance: four standard deviations of as rare an event
 * are let pass. The event is a fragment, whose three channels fall together: of 640 that an H200
 * counted, all but ten came in threes.
 */
function exactEnough(
  { exact, channels }: Pick<Measured, 'exact' | 'channels'>,
  share: number,
): boolean {
  const expected = ((1 - share) * channels) / 3;
  return (channels - exact) / 3 <= expected + 4 * Math.sqrt(expected + 1);
}

const exactness = ({ exact, channels }: Pick<Measured, 'exact' | 'channels'>): string =>
  `${((100 * exact) / channels).toFixed(3)} % of codes exact`;
