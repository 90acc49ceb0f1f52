// @ts-check
// Every guard and every hoisted term of the light loop, its packing and its reference, each with one edit that takes it away: a
// test has to fail for each. An edit that no lawful input can tell from the original is no mutant and is not listed.

import { equationMutants } from './mutants-equation.mjs';
import { glslMutants } from './mutants-glsl.mjs';
import { gridMutants } from './mutants-grid.mjs';
import { lightMutants } from './mutants-light.mjs';
import { materialMutants } from './mutants-material.mjs';
import { normalMutants } from './mutants-normals.mjs';
import { packingMutants } from './mutants-packing.mjs';
import { reachMutants } from './mutants-reach.mjs';

/**
 * @typedef {object} Mutant
 * @property {string} file from the repository's root
 * @property {string} removes what the edit takes away, in words; with the file, the mutant's name
 * @property {string} from text that the file holds exactly once
 * @property {string} to
 */

/** @type {readonly Mutant[]} */
export const MUTANTS = [
  ...glslMutants,
  ...packingMutants,
  ...lightMutants,
  ...reachMutants,
  ...gridMutants,
  ...materialMutants,
  ...normalMutants,
  ...equationMutants,
];

/** @param {Pick<Mutant, 'file' | 'removes'>} mutant */
export const nameOf = ({ file, removes }) => `${file}: ${removes}`;

/** The unit tests that concern a file, in the order in which they are tried. @type {Readonly<Record<string, readonly string[]>>} */
export const UNIT_TESTS = {
  'src/light/pack-lights.ts': [
    'pack-lights',
    'light-shapes',
    'pack-lights-directional',
    'pack-lights-domain',
    'repacked-places',
  ],
  'src/light/steady-light.ts': [
    'light-shapes',
    'pack-lights',
    'pack-lights-directional',
    'pack-lights-domain',
    'repacked-places',
  ],
  'src/light/light-kind.ts': ['light-kind', 'pack-lights'],
  'src/light/light-layout.ts': [
    ...['light-layout', 'light-kind', 'light-rows', 'light-shapes', 'pack-lights', 'equation-limits'],
  ],
  'src/light/light-apart.ts': ['lights-apart'],
  'src/light/light-grid.ts': ['light-grid', 'near-lights'],
  'src/light/cone.ts': ['light-reach', 'light-reach-budget', 'light-reach-bound'],
  'src/light/light-reach.ts': ['light-reach', 'light-reach-budget', 'light-reach-bound'],
  'src/material/light-list.ts': ['light-list'],
  'src/material/mesh-lights.ts': ['mesh-lights'],
  'src/material/exact-lights.ts': ['exact-lights'],
  'src/material/light-block.ts': ['light-rows'],
  'src/material/light-rows.ts': ['light-rows'],
  'src/material/normal-matrix.ts': ['normal-matrix'],
  'src/reference/equation.ts': ['equation-limits', 'equation-vectors', 'equation-metamorphic'],
};

/**
 * The text with the mutant's edit. Throws where the text that goes does not stand there exactly once: then the list no
 * longer speaks of this code.
 * @param {string} text
 * @param {Mutant} mutant
 */
export function mutated(text, mutant) {
  const times = text.split(mutant.from).length - 1;
  if (times !== 1) throw new Error(`${nameOf(mutant)}: stands there ${times} times: ${mutant.from}`);
  return text.replace(mutant.from, () => mutant.to);
}
