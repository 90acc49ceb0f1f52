// Does what was measured keep the contract?
import { CATEGORIES } from './categories.js';
import { EXACT, WORST_CATEGORY_SHARE, WORST_SHARE } from './contract.js';
import type { Measured } from './measure.js';

/**
 * Each way in which one category breaks the contract, in words; none where it keeps it. `worst`: on
 * a worst lawful driver.
 */
function verdictOf(measured: Measured, worst: boolean) {
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
  if (bound <= EXACT.upTo && !exactEnough(countedCodes(measured), share)) {
    words.push(exactness(measured));
  }
  return words.map((word) => `${title}: ${word}`);
}

/**
 * The same of a run, on a `worst` lawful driver or a real one; the codes of all ordinary categories
 * together only where all took part.
 */
export function verdict(all: readonly Measured[], worst: boolean): string[] {
  const sum = { exact: 0, channels: 0, fragments: 0 };
  for (const measured of all) {
    if (measured.bound > EXACT.upTo) continue;
    const { exact, channels, fragments } = countedCodes(measured);
    sum.exact += exact;
    sum.channels += channels;
    sum.fragments += fragments;
  }
  const broken = all.flatMap((measured) => verdictOf(measured, worst));
  const share = worst ? WORST_SHARE : EXACT.share;
  if (all.length === CATEGORIES.length && !exactEnough(sum, share)) {
    broken.push(`all together: ${exactness(sum)}`);
  }
  return broken;
}

interface Codes {
  readonly exact: number;
  readonly channels: number;
  readonly fragments: number;
}

/** Each fragment counts three channels in each form of program. */
const countedCodes = ({ exact, channels, forms }: Measured): Codes => ({
  exact,
  channels,
  fragments: channels / (3 * Math.max(Object.keys(forms).length, 1)),
});

/**
 * Few codes may fall on the wrong side by chance: four standard deviations of as rare an event are
 * let pass. The event is a fragment, whose channels fall together, and in most of its forms: of 640
 * channels on an H200 all but ten came in threes; of 78 through Vulkan, 48 came in twelves, which is
 * three channels in four forms.
 */
function exactEnough({ exact, channels, fragments }: Codes, share: number) {
  const each = channels / Math.max(fragments, 1);
  const expected = (1 - share) * fragments;
  return (channels - exact) / each <= expected + 4 * Math.sqrt(expected + 1);
}

const exactness = ({ exact, channels }: Pick<Measured, 'exact' | 'channels'>) =>
  `${((100 * exact) / channels).toFixed(3)} % of codes exact`;
