import { describe, expect, it } from 'vitest';
import { pixelOffset } from '../../src/math/pixel-offsets.js';
import { shifted } from '../../src/scene/samples/tiles.js';
import { tilesOf } from '../../src/scene/samples/tiles.js';

describe('the offsets of samples', () => {
  it('lie in the pixel, and the first 2^k have one point in each box of area 2^-k', () => {
    for (const k of [3, 4, 6, 10]) {
      const points = Array.from({ length: 2 ** k }, (_, i) => pixelOffset(i));
      for (const { x, y } of points) {
        expect(Math.min(x, y)).toBeGreaterThanOrEqual(-0.5);
        expect(Math.max(x, y)).toBeLessThan(0.5);
      }
      for (let a = 0; a <= k; a++) {
        const boxes = new Set(
          points.map(
            ({ x, y }) => `${Math.floor((x + 0.5) * 2 ** a)} ${Math.floor((y + 0.5) * 2 ** (k - a))}`,
          ),
        );
        expect(boxes.size, `${2 ** a} columns`).toBe(2 ** k);
      }
    }
  });

  it('move no picture: their mean is the centre of the pixel within a hundredth, for 64 and more', () => {
    for (const count of [64, 256, 1024]) {
      let [x, y] = [0, 0];
      for (let i = 0; i < count; i++) {
        const part = shifted({ x: 0, y: 0, width: 8, height: 8 }, i);
        x += part.x / count;
        y += part.y / count;
      }
      expect(Math.hypot(x, y)).toBeLessThan(0.01);
    }
  });
});

describe('the tiles of a picture', () => {
  it('cover each pixel once, within the area and the side', () => {
    for (const [width, height, area, side] of [
      [7, 5, 6, 4],
      [100, 3, 64, Infinity],
      [5, 5, 100, 100],
    ] as const) {
      // prettier-ignore
      const seen = new Uint8Array(width * height);
      for (const tile of tilesOf({ width, height }, area, side)) {
        expect(tile.width * tile.height).toBeLessThanOrEqual(area);
        expect(Math.max(tile.width, tile.height)).toBeLessThanOrEqual(side);
        for (let y = 0; y < tile.height; y++)
          for (let x = 0; x < tile.width; x++) seen[(tile.y + y) * width + tile.x + x]! += 1;
      }
      expect([...seen].every((times) => times === 1)).toBe(true);
    }
  });
});
