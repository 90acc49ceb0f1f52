// One adversarial category: what it attacks, and the bound that the contract gives it.
import type { StressCase, Variant } from './case.js';
import { BOUNDS } from './contract.js';
import type { Random } from './random.js';

export interface Category {
  readonly id: string;
  /** What is drawn, as a noun phrase: it names the test, and the row of the published table. */
  readonly title: string;
  /** Largest error of the sum in 1/255, over max(1, the sum of intensities). */
  readonly bound: number;
  /** Programs that it runs through. */
  readonly variants: readonly Variant[];
  /** Lights that a fragment has, where they are many: such a category gets fewer fragments. */
  readonly lights?: number;
  readonly make: (random: Random, variant: Variant) => StressCase;
}

export const PHONG: Variant = { reflection: 'phong', linear: false };
const BLINN: Variant = { reflection: 'blinn-phong', linear: false };
export const BOTH: readonly Variant[] = [PHONG, BLINN];
export const LINEAR: readonly Variant[] = BOTH.map(({ reflection }) => ({ reflection, linear: true }));

/** Entries by id. Without a bound they have that of ordinary scenes, without programs they go through `variants`. */
export const categories = (
  entries: Readonly<Record<string, Partial<Category> & Pick<Category, 'title' | 'make'>>>,
  variants: readonly Variant[] = BOTH,
): readonly Category[] =>
  Object.entries(entries).map(([id, entry]) => ({ id, bound: BOUNDS.generic, variants, ...entry }));
