// Is a light culled only where no point of the box is inside its cone, by the equation in float64, and nearly always
// where it could be? Each case is made from one seed, which a failure names.

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Box } from '../../src/light/cull-lights.js';
import type { LightValues } from '../../src/light/light-state.js';
import { radians } from '../../src/math/angle.js';
import { add, scale } from '../../src/math/vector.js';
import { fullOr } from '../support/repeats.js';
import { Random } from '../stress/random.js';
import { light } from './arbitraries.js';
import { pack } from './packed-reader.js';
import { angleOf, anyBox, anyView, boxOf, coneBy, cull, pointsOf, shadeAt, spaceOf, spotOf } from './cull-cases.js';

/** A smaller seed makes no simpler case. */
const seeds = fc.noShrink(fc.integer({ min: 0, max: 0x7fffffff }));

const SEED = 1;

const bare = { diffuse: [255, 255, 255], specular: [255, 255, 255] } as const;

/** At the origin, along −z unless `values` turn it. */
const spotWith = (values: Partial<LightValues>): LightValues =>
  light({ ...bare, position: [0, 0, 0, 1], axis: [0, 0, -1], ...values });

describe('a cone', () => {
  it.each<[string, Box, number]>([
    ['a point on the axis', [0, 0, -5, 0, 0, -5], 1],
    ['a point at the apex', [0, 0, 0, 0, 0, 0], 1],
    ['a point beside the cone', [5, 0, 0, 5, 0, 0], 0],
    ['a point behind the apex', [0, 0, 5, 0, 0, 5], 0],
    ['a flat box across the axis', [-9, -9, -5, 9, 9, -5], 1],
    ['a flat box beside the axis', [6, -9, -5, 9, 9, -5], 0],
    ['a box about the apex', [-1, -1, -1, 1, 1, 1], 1],
    ['a box that the cone leaves a corner of', [3, 3, -5, 9, 9, -4], 1],
    ['a box whose ball alone the cone touches', [4, 4, -5, 9, 9, 5], 0],
    ['everything', [-1e15, -1e15, -1e15, 1e15, 1e15, 1e15], 1],
  ])('of 45° along −z reaches %s: %j %i', (_, box, count) => {
    expect(cull(pack([spotWith({ aperture: 45 })]), box).count).toBe(count);
    // The complement: all other directions.
    const rest = spotWith({ axis: [0, 0, 1], aperture: 134 });
    const inside = count === 1 && box.every((x, i) => x === box[(i + 3) % 6]) && box[2] !== 0;
    expect(cull(pack([rest]), box).count).toBe(inside ? 0 : 1);
  });

  it.each([0, 1e-4, 1, 30, 45, 89, 90, 91, 135, 179])(
    'of %f° reaches a point at its edge, and none 2e-5 rad beyond it',
    (aperture) => {
      const slack = 2e-5;
      const at = (angle: number, d: number): Box => {
        const [x, z] = [d * Math.sin(angle), -d * Math.cos(angle)];
        return [x, 0, z, x, 0, z];
      };
      const packed = pack([spotWith({ aperture })]);
      for (const d of [1e-9, 1, 1e12]) {
        const edge = Math.max(radians(aperture), 1e-6);
        expect(cull(packed, at(edge, d)).count).toBe(1);
        expect(cull(packed, at(edge + 0.5 * slack, d)).count).toBe(1);
        expect(cull(packed, at(edge + slack, d)).count).toBe(0);
      }
    },
  );

  it.each([0, 1e-4, 0.01])('of %f° is never culled for a point on its axis, in any direction', (aperture) => {
    const random = new Random(SEED);
    for (let i = 0; i < 300; i++) {
      const [place, axis] = [random.unit(), random.unit()];
      const spot = light({ ...bare, position: [...place, 1], axis, aperture });
      const [x, y, z] = add(place, scale(axis, random.magnitude(1e-3, 1e3)));
      expect(cull(pack([spot]), [x, y, z, x, y, z]).count).toBe(1);
    }
  });

  it('is culled for a box right behind it, but not for a point nearer than 1e-15, which has no direction', () => {
    expect(cull(pack([spotWith({ aperture: 1 })]), [-1, -1, 0.5, 1, 1, 2.5]).count).toBe(0);
    expect(cull(pack([spotWith({ aperture: 20 })]), [0, 0, 5e-16, 0, 0, 5e-16]).count).toBe(1);
  });

  it('is never culled at an aperture of 180 degrees, nor any light without a cone', () => {
    const lights = [light(bare), ...[{}, { cutoff: 1e6 }, { attenuation: [1e6, 1e6, 1e6] as const }].map(spotWith)];
    expect(cull(pack(lights), [1e3, 1e3, 1e3, 1e3, 1e3, 1e3]).count).toBe(4);
  });

  it('is culled only where no point of the box is inside it, by the equation', () => {
    let cases = 0;
    let culled = 0;
    fc.assert(
      fc.property(seeds, (seed) => {
        const random = new Random(seed);
        const box = anyBox(random);
        const view = anyView(random, box.size);
        for (let i = 0; i < 6; i++) {
          const cone = coneBy(random, box, true); // lights at a box of one point have a test of their own
          const spot = spotOf(random, cone, view, { ...bare, ambient: random.color() });
          const packed = pack([spot], spaceOf(view, random.chance(0.5)));
          cases += 1;
          if (cull(packed, boxOf(box)).count > 0) continue;
          culled += 1;
          for (const point of pointsOf(boxOf(box), cone, random, 200)) {
            const { shares, sum } = shadeAt(point, random.unit(), [spot], view);
            if (shares[0]!.insideCone) expect.fail(`${String(point)} is inside ${JSON.stringify(spot)}`);
            expect(sum).toStrictEqual([0, 0, 0]);
          }
        }
      }),
      { numRuns: fullOr(200, 60) },
    );
    expect(culled / cases).toBeGreaterThan(0.3); // 0.41 of these cones are culled
  });

  it('is culled in at least 98 of 100 cases where it misses the box by a tenth of its longest side', () => {
    let missing = 0;
    let culled = 0;
    const random = new Random(SEED);
    while (missing < fullOr(4000, 1000)) {
      const box = anyBox(random, random.pick([1e-9, 1, 1e12]));
      const cone = coneBy(random, box);
      const grown = boxOf(box, 0.2 * Math.max(...box.half));
      if (pointsOf(grown, cone, random, 27).some((p) => angleOf(cone, p) <= radians(cone.aperture))) continue;
      missing += 1;
      const view = anyView(random, box.size);
      culled += 1 - cull(pack([spotOf(random, cone, view, bare)], spaceOf(view, false)), boxOf(box)).count;
    }
    expect(culled / missing, `seed ${String(SEED)}`).toBeGreaterThan(0.98); // measured: 0.994
  });
});

it('the mask has one number per light, in the order of the rows', () => {
  const spot = (x: number) => light({ ...bare, axis: [0, -1, 0], aperture: 10, position: [x, 1, 0, 1] });
  const lights = [spot(0), light(), spot(5), light({ ...bare, position: [9, 9, 9, 1] }), spot(0.1)];
  const { mask, count } = cull(pack(lights), [-0.1, 0, -0.1, 0.1, 0, 0.1]);
  expect(mask).toStrictEqual([1, 1, 1, 0, 1]); // directional, point, then the three spots
  expect(count).toBe(4);
});
