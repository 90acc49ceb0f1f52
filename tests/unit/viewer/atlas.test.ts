// Do the pictures of one frame find places on one canvas: apart from each other, inside it, and
// without much waste?
import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import type { Region } from '../../../src/phong/math/region.js';
import { layOutAtlas } from '../../../src/viewer/scene/gpu/atlas.js';

const limit = { side: 4096, area: 1920 * 1080 };
const side = fc.oneof(fc.integer({ min: 1, max: 40 }), fc.integer({ min: 1, max: limit.side }));
const sizes = fc.array(fc.record({ width: side, height: side }), { minLength: 1, maxLength: 60 });

const apart = (a: Region, b: Region) =>
  a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y;

describe('an atlas of pictures', () => {
  test('holds the first pictures at their sizes, apart from each other, within itself and its limits', () => {
    fc.assert(
      fc.property(sizes, (wanted) => {
        const { places, width, height } = layOutAtlas(wanted, limit);
        expect(places.length).toBeGreaterThan(0);
        places.forEach((place, i) => {
          expect({ width: place.width, height: place.height }).toEqual(wanted[i]);
          expect(Math.min(place.x, place.y)).toBeGreaterThanOrEqual(0);
          expect(place.x + place.width).toBeLessThanOrEqual(width);
          expect(place.y + place.height).toBeLessThanOrEqual(height);
          for (const other of places.slice(0, i)) {
            expect(apart(place, other)).toBe(true);
          }
        });
        expect(Math.max(width, height)).toBeLessThanOrEqual(limit.side);
        // One picture alone may be larger than the area.
        if (places.length > 1) {
          expect(width * height).toBeLessThanOrEqual(limit.area);
        }
      }),
    );
  });

  test('uses seven tenths or more for a page of equal pictures, from nine on', () => {
    fc.assert(
      fc.property(
        fc.integer({ min: 9, max: 200 }),
        fc.integer({ min: 1, max: 80 }),
        side,
        (count, w, h) => {
          const one = { width: w, height: Math.min(h, 2 * w, 80) };
          const { places, width, height } = layOutAtlas(
            Array.from({ length: count }, () => one),
            limit,
          );
          expect(places.length * one.width * one.height).toBeGreaterThanOrEqual(
            0.7 * width * height,
          );
        },
      ),
    );
  });
});
