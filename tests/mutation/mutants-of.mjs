// @ts-check
// How the lists of mutants are written: one row a mutant.

/**
 * Makes a file's mutants from rows of what is removed, the text that goes, and the text that comes.
 * @param {string} file
 * @param {readonly (readonly [removes: string, from: string, to: string])[]} rows
 * @returns {import('./mutants.mjs').Mutant[]}
 */
export function mutantsOf(file, rows) {
  return rows.map(([removes, from, to]) => ({ file, removes, from, to }));
}
