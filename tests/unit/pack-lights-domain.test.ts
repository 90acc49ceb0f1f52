// Is packing right over the lights' whole domains: finite, consistent, and the reference's sum when read back?

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { kindOf } from '../../src/light/light-features.js';
import { coneLimit } from '../../src/light/precision.js';
import { LIMIT_OPEN } from '../../src/light/precision.js';
import type { PackSpace } from '../../src/light/pack-lights.js';
import { multiply, normalize, subtract, type Vec3 } from '../../src/math/vector.js';
import { shade } from '../../src/reference/equation.js';
import { anyLight, numbers, plainLight, plainVector, rotation, triple } from './arbitraries.js';
import { loop, pack, read } from './packed-reader.js';

const place = triple(numbers(-1e15, 1e15));

const spaceOf = (
  [x, y, z]: readonly [Vec3, Vec3, Vec3],
  origin: Vec3,
  eye: Vec3,
  linear: boolean,
): PackSpace => ({
  worldToShading: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -origin[0], -origin[1], -origin[2], 1],
  cameraToShading: [...x, 0, ...y, 0, ...z, 0, ...subtract(eye, origin), 1],
  linear,
});

const anySpace = fc.tuple(rotation, place, place, fc.boolean()).map((parts) => spaceOf(...parts));

describe('packed lights of any values', () => {
  it('are finite numbers of float32', () => {
    fc.assert(
      fc.property(fc.array(anyLight, { maxLength: 8 }), anySpace, (lights, space) => {
        const { data, rows } = pack(lights, space);
        const bad = data.subarray(0, rows * 4).findIndex((x) => !Number.isFinite(x));
        expect(bad).toBe(-1);
      }),
      { numRuns: 700 },
    );
  });

  it('have unit directions and axes, and colours that are not negative', () => {
    fc.assert(
      fc.property(fc.array(anyLight, { maxLength: 8 }), anySpace, (lights, space) => {
        const { directional, point, spot, ambient } = read(pack(lights, space));
        for (const light of directional) expect(Math.hypot(...light['direction']!.xyz)).toBeCloseTo(1, 6);
        for (const light of spot) expect(Math.hypot(...light['axis']!.xyz)).toBeCloseTo(1, 6);
        const colors = [...directional, ...point, ...spot].flatMap((light) => [
          light['diffuse'],
          light['specular'],
        ]);
        expect([ambient, ...colors.map((row) => row!.xyz)].flat().every((x) => x >= 0)).toBe(true);
      }),
      { numRuns: 200 },
    );
  });

  it('count no more than the active lights, and as many rows as their kinds need', () => {
    fc.assert(
      fc.property(fc.array(anyLight, { maxLength: 12 }), anySpace, (lights, space) => {
        const packed = pack(lights, space);
        const active = lights.filter((light) => light.active);
        expect(packed.active).toBe(active.length);
        expect(packed.sent).toBeLessThanOrEqual(packed.active);
        const { counts } = read(packed);
        (['directional', 'point', 'spot'] as const).forEach((kind, k) => {
          expect(counts[k]).toBeLessThanOrEqual(active.filter((light) => kindOf(light) === kind).length);
        });
      }),
      { numRuns: 200 },
    );
  });

  it('do not depend on lights that are switched off', () => {
    fc.assert(
      fc.property(fc.array(anyLight, { maxLength: 8 }), anySpace, (lights, space) => {
        const all = pack(lights, space);
        const active = pack(
          lights.filter((light) => light.active),
          space,
        );
        expect(all.rows).toBe(active.rows);
        expect(all.data.subarray(0, all.rows * 4)).toStrictEqual(active.data.subarray(0, active.rows * 4));
      }),
      { numRuns: 150 },
    );
  });
});

describe('packed lights read as the loop reads them', () => {
  const surface = { ka: [200, 150, 100], kd: [255, 200, 50], ks: [128, 255, 60], shininess: 8 } as const;

  it("give the reference's sum, in every space", () => {
    const lights = fc.array(plainLight, { minLength: 1, maxLength: 6 });
    const scene = fc.tuple(
      lights,
      rotation,
      plainVector,
      plainVector,
      plainVector,
      plainVector,
      fc.boolean(),
    );
    fc.assert(
      fc.property(scene, ([all, axes, origin, eye, p, normal, far]) => {
        const offset: Vec3 = far ? [2 ** 30, -(2 ** 31), 2 ** 30] : [0, 0, 0];
        const moved = (v: Vec3): Vec3 => [v[0] + offset[0], v[1] + offset[1], v[2] + offset[2]];
        const scene = all.map((light) => {
          const { position, space } = light;
          if (position[3] === 0 || space === 'camera') return light;
          return { ...light, position: [...moved([position[0], position[1], position[2]]), 1] as const };
        });
        const [right, up, back] = axes;
        const want = shade({ p: moved(p), normal, eye: moved(eye) }, surface, scene, {
          camera: { right, up, back },
        });
        // Rows are rounded to float32: a fragment within that of a cone's edge may fall on either side.
        fc.pre(
          want.shares.every((share, i) => {
            const { aperture } = scene[i]!;
            if (share === null || aperture === 180) return true;
            return (
              Math.abs(Math.acos(Math.min(Math.max(share.c, -1), 1)) - (aperture * Math.PI) / 180) > 1e-4
            );
          }),
        );
        fc.pre(want.shares.every((share) => share === null || share.d > 0.1));
        const space = spaceOf(axes, moved(origin), moved(eye), false);
        const N = normalize(normal);
        const sums = loop(
          read(pack(scene, space)),
          subtract(p, origin),
          N,
          subtract(eye, origin),
          surface.shininess,
        );
        const unit = (k: Vec3): Vec3 => [k[0] / 255, k[1] / 255, k[2] / 255];
        const ambient = multiply(unit(surface.ka), sums.ambient);
        const diffuse = multiply(unit(surface.kd), sums.diffuse);
        const specular = multiply(unit(surface.ks), sums.specular);
        for (const i of [0, 1, 2] as const) {
          expect(Math.abs(ambient[i] + diffuse[i] + specular[i] - want.sum[i])).toBeLessThan(1e-4);
        }
      }),
      { numRuns: 300 },
    );
  });
});

describe("the cone's limit", () => {
  it.each([
    [0, 0],
    [60, 0.25],
    [90, 0.5],
    [120, -0.25],
    [180, LIMIT_OPEN],
  ])('at %d degrees is %d', (aperture, limit) => {
    expect(coneLimit(aperture)).toBeCloseTo(limit, 15);
  });

  // sin² and -cos² of half the angle, from 50 digits.
  it.each([
    [1e-8, 7.6154354946677153e-21],
    [1e-3, 7.6154354944743991e-11],
    [1, 7.6152421804380421e-5],
    [45, 0.14644660940672624],
    [89.999999, 0.49999999127335376],
    [90.000001, -0.49999999127335376],
    [135, -0.14644660940672624],
    [179, -7.6152421804380421e-5],
    [179.999999, -7.6154354562134622e-17],
    [180 - 2 ** -45, -6.1516998020872166e-32],
  ])('at %d degrees is right to 14 digits', (aperture, limit) => {
    expect(Math.abs(coneLimit(aperture) / limit - 1)).toBeLessThan(1e-14);
  });

  it('is below 0 exactly where the far side is compared, and never underflows in float32', () => {
    fc.assert(
      fc.property(numbers(1e-12, 180), (aperture) => {
        const limit = Math.fround(coneLimit(aperture));
        expect(limit < 0).toBe(aperture > 90 && aperture < 180);
        expect(Math.abs(limit)).toBeGreaterThan(2 ** -126);
        if (aperture < 180) expect(Math.abs(limit)).toBeLessThanOrEqual(0.5);
      }),
    );
  });

  it('grows with the aperture', () => {
    const included = (aperture: number): number => {
      const limit = coneLimit(aperture);
      return limit < 0 ? 1 + limit : limit;
    };
    fc.assert(
      fc.property(numbers(0, 180), numbers(0, 180), (a, b) => {
        expect(included(Math.max(a, b))).toBeGreaterThanOrEqual(included(Math.min(a, b)));
      }),
    );
  });
});
