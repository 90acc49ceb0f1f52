// What the stress cases reach of the shipped programs: their forms, and the feature masks of their lights.
import { pack, type StressCase, type Variant } from '../stress/case.js';
import { CATEGORIES } from '../stress/categories.js';
import { Random } from '../stress/random.js';
import { programsFor } from './loop-forms.js';

/** Enough that each category shows every kind of light and exponent that it has. */
const CASES = 60;

/**
 * Calls `visit` with some cases of every category but those with very many lights, which are lights of other
 * categories.
 */
export function forSomeCases(visit: (stress: StressCase, variant: Variant) => void): void {
  for (const { make, variants, lights = 1 } of CATEGORIES) {
    for (const variant of variants) {
      const random = new Random(1);
      for (let i = 0; i < (lights > 8 ? 0 : CASES); i++) visit(make(random, variant), variant);
    }
  }
}

/** The names of all programs that a stress run measures. */
export function formsOfAll(): ReadonlySet<string> {
  const names = new Set<string>();
  forSomeCases((stress, variant) => {
    for (const { name } of programsFor(stress, variant)) names.add(name);
  });
  return names;
}

/** The feature masks of all lights. */
export function masksOfAll(): ReadonlySet<number> {
  const masks = new Set<number>();
  forSomeCases((stress, variant) => {
    const { features, sent } = pack(stress, variant);
    for (const mask of features.subarray(0, sent)) masks.add(mask);
  });
  return masks;
}
