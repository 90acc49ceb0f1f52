// Finds the known word that was probably meant by a misspelled one.
import { clip } from './clip.js';

/**
 * Letters from which on a word may be misspelled twice. In shorter ones two edits make another
 * word.
 */
const TWICE_FROM = 6;

/**
 * The word of `words` that is one edit from `word`, or two from six letters on; undefined for none.
 */
export const nearest = (word: string, words: readonly string[]): string | undefined =>
  words.find((other) => isWithin(1, word, other)) ??
  words.find((other) => other.length >= TWICE_FROM && isWithin(2, word, other));

/** The end of a message about `word`: a question, or nothing. */
export function didYouMean(word: string, words: readonly string[]): string {
  const meant = nearest(word, words);
  return meant === undefined ? '' : ` Did you mean "${clip(meant)}"?`;
}

/**
 * Whether at most `edits` make `a` to `b`: a letter inserted, left out or replaced, or two
 * neighbours swapped.
 */
function isWithin(edits: number, a: string, b: string): boolean {
  if (a === b) return true;
  if (edits === 0) return false;
  let i = 0;
  while (a[i] === b[i]) {
    i++;
  }
  const [shortA, shortB] = [a.slice(i + 1), b.slice(i + 1)];
  const swapped = a[i] === b[i + 1] && a[i + 1] === b[i];
  return (
    isWithin(edits - 1, shortA, b.slice(i)) ||
    isWithin(edits - 1, a.slice(i), shortB) ||
    isWithin(edits - 1, shortA, shortB) ||
    (swapped && isWithin(edits - 1, a.slice(i + 2), b.slice(i + 2)))
  );
}
