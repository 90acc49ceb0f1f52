// @ts-check
// A Vite plugin that makes one mutant's edit while its file is loaded, so that no file of the working tree ever changes.

import { fileURLToPath } from 'node:url';
import { mutated } from './mutants.mjs';

const repository = fileURLToPath(new URL('../..', import.meta.url));

/**
 * @param {import('./mutants.mjs').Mutant} mutant
 * @returns {import('vite').Plugin}
 */
export function mutantPlugin(mutant) {
  return {
    name: 'mutant',
    enforce: 'pre',
    transform(code, id) {
      const [path] = id.split('?');
      return path === repository + mutant.file ? { code: mutated(code, mutant), map: null } : null;
    },
  };
}
