import { describe, expect, it } from 'vitest';
import { pixelOffset } from '../../src/math/pixel-offsets.js';
import { tilesOf } from '../../src/scene/gpu/atlas.js';

describe('the offsets of samples', () => {
  it('lie in the pixel, and the first 2^k have one point in each box of area 2^-k', () => {
    for (const k of [3, 4, 6, 10]) {
      const points = Array.from({ length: 2 ** k }, (_, i) => pixelOffset(i));
      for (const { x, y } of points) {
        expect(Math.min(x, y)).toBeGreaterThanOrEqual(-0.5);
        expect(Math.max(x, y)).toBeLessThan(0.5);
      }
      for (let a = 0; a <= k; a++) {
        const box = (x: number, columns: number): number => Math.floor((x + 0.5) * columns);
        const boxes = new Set(points.map(({ x, y }) => `${box(x, 2 ** a)} ${box(y, 2 ** (k - a))}`));
        expect(boxes.size, `${2 ** a} columns`).toBe(2 ** k);
      }
    }
  });
});

describe('the tiles of a picture', () => {
  it.each([
    [7, 5, 6, 4],
    [100, 3, 64, Infinity],
    [5, 5, 100, 100],
  ])('cover each pixel of %d × %d once, within an area of %d and a side of %d', (width, height, area, side) => {
    const seen = new Uint8Array(width * height);
    for (const tile of tilesOf({ width, height }, area, side)) {
      expect(tile.width * tile.height).toBeLessThanOrEqual(area);
      expect(Math.max(tile.width, tile.height)).toBeLessThanOrEqual(side);
      for (let y = 0; y < tile.height; y++)
        for (let x = 0; x < tile.width; x++) seen[(tile.y + y) * width + tile.x + x]! += 1;
    }
    expect(seen).toEqual(new Uint8Array(width * height).fill(1));
  });
});
