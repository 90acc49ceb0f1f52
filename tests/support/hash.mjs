// @ts-check

/**
 * A hash of a text, 32 bits: FNV-1a (Fowler, Noll, Vo), which spreads short texts well enough to
 * start a generator from.
 * @param {string} text
 * @param {number} [start] another one gives other hashes
 */
export function hashOf(text, start = 0x811c9dc5) {
  let hash = start;
  for (let i = 0; i < text.length; i++) {
    hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  }
  return hash >>> 0;
}
