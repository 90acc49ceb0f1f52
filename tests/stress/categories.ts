// All adversarial categories, those of many lights among them: fragments share a set of lights, as those of a picture do.
import type { LightValues } from '../../src/light/light-state.js';
import type { StressCase } from './case.js';
import { degenerateCategories } from './categories-degenerate.js';
import { meshCategories } from './categories-meshes.js';
import { ordinaryCategories } from './categories-ordinary.js';
import { spotCategories } from './categories-spots.js';
import { categories, type Category, PHONG } from './category.js';
import { anyLight, colors, seen, stressCase, surface } from './fragments.js';
import type { Random } from './random.js';

/** Fragments that see the same lights. */
const SHARED_BY = 32;

function sum(count: number): Category['make'] {
  let lights: readonly LightValues[] = [];
  let left = 0;
  return (random: Random): StressCase => {
    const fragment = seen(random);
    if (left === 0) {
      left = SHARED_BY;
      // Together as bright as four full lights, so that a part of the fragments is not clamped.
      lights = Array.from({ length: count }, () => anyLight(random, fragment.p, colors(random, 1020 / count)));
    }
    left -= 1;
    return stressCase(fragment, surface(random, random.from(1, 100)), lights);
  };
}

const sumOf = (count: number) => ({ title: `sums of ${count} lights`, lights: count, make: sum(count) });

const sumCategories = categories(
  {
    'sum-1': { ...sumOf(1), title: 'one light' },
    'sum-8': sumOf(8),
    'sum-64': sumOf(64),
    'sum-512': sumOf(512),
    'sum-4096': sumOf(4096),
  },
  [PHONG],
);

export const CATEGORIES: readonly Category[] = [
  ...ordinaryCategories,
  ...spotCategories,
  ...degenerateCategories,
  ...meshCategories,
  ...sumCategories,
];
