// Which pixels does toShowTheEquation judge, and in which order?
import { describe, expect, it } from 'vitest';
import { tilesOf } from '../../src/playwright/tiles.js';

describe('the tiles of a picture', () => {
  it.each([
    [300, 200],
    [11, 10],
    [3, 40],
  ])('cover each pixel of %i × %i once, without the border', (width, height) => {
    const times = new Uint8Array(width * height);
    for (const { left, top, right, bottom } of tilesOf(width, height, 1))
      for (let y = top; y < bottom; y++) for (let x = left; x < right; x++) times[y * width + x]! += 1;
    const isInside = (i: number): boolean => {
      const [x, y] = [i % width, Math.floor(i / width)];
      return x > 0 && y > 0 && x < width - 1 && y < height - 1;
    };
    expect([...times]).toEqual(Array.from(times, (_, i) => (isInside(i) ? 1 : 0)));
  });

  it('are none in pictures that are all border', () => {
    expect([tilesOf(2, 200, 1), tilesOf(0, 0, 1)]).toEqual([[], []]);
  });

  it('come in the same order for the same seed, and in another for another', () => {
    const order = (seed: number) => JSON.stringify(tilesOf(300, 200, seed));
    expect(order(7)).toBe(order(7));
    expect(new Set([1, 2, -1, 2 ** 40, 7].map(order)).size).toBe(5);
  });

  it('are spread over the picture from the first on', () => {
    const first = tilesOf(300, 200, 1).slice(0, 100);
    const quarters = new Set(first.map(({ left, top }) => `${left < 150} ${top < 100}`));
    expect(quarters.size).toBe(4);
  });
});
