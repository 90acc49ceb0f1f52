// Which parts of a picture are judged, and in which order.

/** A rectangle of pixels. `right` and `bottom` are excluded. */
export interface Tile {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/**
 * Sides of a tile, in pixels. A tile also needs the explanations of the pixels around it, half of its own number at
 * this size. Larger tiles need fewer, but spread the same number of pixels over fewer places of the picture.
 */
const TILE = 8;

/** All pixels of a picture but those of its border, as tiles in a random order. The same seed gives the same order. */
export function tilesOf(width: number, height: number, seed: number): Tile[] {
  const tiles: Tile[] = [];
  for (let top = 1; top < height - 1; top += TILE)
    for (let left = 1; left < width - 1; left += TILE)
      tiles.push({
        left,
        top,
        right: Math.min(left + TILE, width - 1),
        bottom: Math.min(top + TILE, height - 1),
      });
  shuffle(tiles, seed);
  return tiles;
}

/** Puts a list into a random order. The same seed gives the same order. */
export function shuffle<T>(list: T[], seed: number): void {
  const random = generator(seed);
  for (let i = list.length - 1; i > 0; i--) {
    const j = Math.floor(random() * (i + 1));
    [list[i], list[j]] = [list[j]!, list[i]!];
  }
}

/** Numbers from 0 to 1 (excluded): the generator "mulberry32", of 32 bits of state. */
function generator(seed: number): () => number {
  let state = seed | 0;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let bits = Math.imul(state ^ (state >>> 15), state | 1);
    bits ^= bits + Math.imul(bits ^ (bits >>> 7), bits | 61);
    return ((bits ^ (bits >>> 14)) >>> 0) / 2 ** 32;
  };
}
