// Are overlays drawn where the picture shows their points, with labels that do not overlap and
// colours that can be seen?

import fc from 'fast-check';
import { describe, expect, it, vi } from 'vitest';
import type { Vec3 } from '../../../src/phong/math/vector.js';
import { coreColor, luminance } from '../../../src/extras/overlay/drawing/display-list.js';
import { listOf, NO_DRAWING } from '../../../src/extras/overlay/drawing/label-layout.js';
import { Projection } from '../../../src/extras/overlay/drawing/projection.js';
import { between, triple } from '../../unit/arbitraries.js';

const sight = {
  pose: { theta: 0, phi: 90, radius: 4, target: [0, 0, 0] },
  fov: 90,
  width: 400,
  height: 200,
} as const;

describe('a projection', () => {
  it('is inverted by the point at a place and a depth', () => {
    const angle = between(-180, 180);
    const coordinate = between(-1, 1);
    fc.assert(
      fc.property(angle, angle, triple(coordinate), (theta, phi, place) => {
        const pose = { ...sight.pose, theta, phi: Math.abs(phi) };
        const projection = new Projection({ ...sight, pose });
        const again = projection.placeAt(projection.point(place)!, projection.depthOf(place));
        for (const i of [0, 1, 2] as const) {
          expect(again[i]).toBeCloseTo(place[i], 10);
        }
      }),
    );
  });

  it('keeps the ends of lines finite and near the layer for all coordinates', () => {
    const coordinate = between(-1e15, 1e15);
    const place = triple(coordinate);
    const projection = new Projection(sight);
    fc.assert(
      fc.property(place, place, (a, b) => {
        for (const { x, y } of projection.segment(a, b) ?? []) {
          expect(x > -401 && x < 801, `${x}`).toBe(true);
          expect(y > -201 && y < 401, `${y}`).toBe(true);
        }
      }),
    );
  });
});

const room = { left: 0, top: 0, right: 300, bottom: 150 };
it('labels stay inside and never overlap, however many points there are', () => {
  // Without a canvas a letter is seven pixels wide.
  vi.stubGlobal('document', { createElement: () => ({ getContext: () => null }) });
  const name = fc.record({
    text: fc.integer({ min: 1, max: 17 }).map((length) => 'x'.repeat(length)),
    center: fc.record({ x: fc.integer({ min: 0, max: 300 }), y: fc.integer({ min: 0, max: 150 }) }),
    gap: fc.integer({ min: 0, max: 20 }),
  });
  fc.assert(
    fc.property(fc.array(name, { maxLength: 64 }), (names) => {
      const boxes = listOf([{ ...NO_DRAWING, names }], room, 12).placed;
      boxes.forEach((a, i) => {
        expect(a.left >= 0 && a.top >= 0 && a.right <= 300 && a.bottom <= 150).toBe(true);
        for (const b of boxes.slice(i + 1)) {
          const beside = a.right <= b.left || b.right <= a.left;
          expect(beside || a.bottom <= b.top || b.bottom <= a.top).toBe(true);
        }
      });
    }),
  );
});

const contrast = (a: number, b: number) => (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);

it('of a core and its black outline, one has a contrast of 3:1 with any background, for a light of any colour', () => {
  const channel = between(0, 4);
  const color: fc.Arbitrary<Vec3> = triple(channel);
  fc.assert(
    fc.property(color, between(0, 1), (own, behind) => {
      const core = luminance(coreColor(own));
      expect(Math.max(contrast(core, behind), contrast(0, behind))).toBeGreaterThanOrEqual(2.999);
    }),
  );
});
