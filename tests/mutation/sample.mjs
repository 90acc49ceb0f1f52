// @ts-check
// Which mutants are in a sample? The same for the same seed, whatever the order: each is drawn by
// its own name.

/**
 * A number from 0 to 1 for a name (FNV-1a, then mixed). @param {string} name @param {number} seed
 */
export function drawn(name, seed) {
  let hash = 0x811c9dc5 ^ seed;
  for (let i = 0; i < name.length; i++) {
    hash = Math.imul(hash ^ name.charCodeAt(i), 0x01000193);
  }
  hash = Math.imul(hash ^ (hash >>> 16), 0x85ebca6b);
  hash = Math.imul(hash ^ (hash >>> 13), 0xc2b2ae35);
  return ((hash ^ (hash >>> 16)) >>> 0) / 2 ** 32;
}
