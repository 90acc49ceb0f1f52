import { describe, expect, it } from 'vitest';
import { centredOffset, pixelOffset } from '../../../src/phong/math/pixel-offsets.js';

describe('the offsets of samples', () => {
  it('lie in the pixel, and the first 2^k have one point in each box of area 2^-k', () => {
    for (const k of [3, 4, 6, 10]) {
      const points = Array.from({ length: 2 ** k }, (_, i) => pixelOffset(i));
      for (const { x, y } of points) {
        expect(Math.min(x, y)).toBeGreaterThanOrEqual(-0.5);
        expect(Math.max(x, y)).toBeLessThan(0.5);
      }
      for (let a = 0; a <= k; a++) {
        const box = (x: number, columns: number) => Math.floor((x + 0.5) * columns);
        const boxes = new Set(
          points.map(({ x, y }) => `${box(x, 2 ** a)} ${box(y, 2 ** (k - a))}`),
        );
        expect(boxes.size, `${2 ** a} columns`).toBe(2 ** k);
      }
    }
  });

  it("of any number of samples have the pixel's centre as their mean, and stay in the pixel", () => {
    for (let count = 1; count <= 1024; count++) {
      const points = Array.from({ length: count }, (_, i) => centredOffset(i, count));
      for (const axis of ['x', 'y'] as const) {
        const places = points.map((point) => point[axis]);
        expect(Math.abs(places.reduce((sum, place) => sum + place, 0) / count)).toBeLessThan(1e-12);
        expect(Math.max(...places.map(Math.abs)), `${count} samples`).toBeLessThan(0.526);
      }
    }
    expect(centredOffset(0, 1)).toEqual({ x: 0, y: 0 });
  });
});
