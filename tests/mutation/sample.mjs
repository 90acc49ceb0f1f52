// @ts-check
// Which mutants are in a sample? The same for the same seed, whatever the order: each is drawn by
// its own name.

import { hashOf } from '../support/hash.mjs';

/** A number from 0 to 1 for a name. @param {string} name @param {number} seed */
export function drawn(name, seed) {
  let hash = hashOf(name, 0x811c9dc5 ^ seed);
  hash = Math.imul(hash ^ (hash >>> 16), 0x85ebca6b);
  hash = Math.imul(hash ^ (hash >>> 13), 0xc2b2ae35);
  return ((hash ^ (hash >>> 16)) >>> 0) / 2 ** 32;
}
