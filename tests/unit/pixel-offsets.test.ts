import { describe, expect, it } from 'vitest';
import { pixelOffset } from '../../src/math/pixel-offsets.js';

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
