// How is a picture cut into tiles?

import fc from 'fast-check';
import { expect, it } from 'vitest';
import { tilesOf } from '../../../src/phong/math/region.js';

it('tiles stand row by row from the top, as large as area and side allow', () => {
  expect(tilesOf({ width: 5, height: 3 }, 6, 3)).toEqual([
    { x: 0, y: 0, width: 3, height: 2 },
    { x: 3, y: 0, width: 2, height: 2 },
    { x: 0, y: 2, width: 3, height: 1 },
    { x: 3, y: 2, width: 2, height: 1 },
  ]);
  expect(tilesOf({ width: 5, height: 3 }, 100)).toEqual([{ x: 0, y: 0, width: 5, height: 3 }]);
});

it('tiles cover each pixel once, and none is too large, in any picture', () => {
  const length = fc.integer({ min: 1, max: 30 });
  fc.assert(
    fc.property(length, length, length, length, (width, height, area, side) => {
      const seen = new Set<number>();
      let covered = 0;
      for (const tile of tilesOf({ width, height }, area, side)) {
        expect(tile.width * tile.height).toBeLessThanOrEqual(area);
        expect(Math.max(tile.width, tile.height)).toBeLessThanOrEqual(side);
        covered += tile.width * tile.height;
        for (let y = tile.y; y < tile.y + tile.height; y++) {
          for (let x = tile.x; x < tile.x + tile.width; x++) {
            seen.add(y * width + x);
          }
        }
      }
      expect([covered, seen.size]).toEqual([width * height, width * height]);
      expect(Math.max(...seen)).toBe(width * height - 1);
    }),
  );
});
