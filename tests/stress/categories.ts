// All adversarial categories.
import { degenerateCategories } from './categories-degenerate.js';
import { meshCategories } from './categories-meshes.js';
import { ordinaryCategories } from './categories-ordinary.js';
import { spotCategories } from './categories-spots.js';
import { sumCategories } from './categories-sums.js';
import type { Category } from './category.js';

export const CATEGORIES: readonly Category[] = [
  ...ordinaryCategories,
  ...spotCategories,
  ...degenerateCategories,
  ...meshCategories,
  ...sumCategories,
];
