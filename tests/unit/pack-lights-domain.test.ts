// Is packing right over the lights' whole domains: finite, consistent, and the reference's sum when read back?

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { kindOf } from '../../src/light/light-features.js';
import { KINDS } from '../../src/light/light-state.js';
import { coneLimit, LIMIT_OPEN } from '../../src/light/precision.js';
import type { PackSpace } from '../../src/light/pack-lights.js';
import { srgbDecode } from '../../src/math/color.js';
import { normalize, subtract, type Vec3 } from '../../src/math/vector.js';
import { coefficientsOf, shade } from '../../src/reference/equation.js';
import { anyLight, numbers, plainLight, plainVector, rotation, triple } from './arbitraries.js';
import { loop, pack, read } from './packed-reader.js';

const place = triple(numbers(-1e15, 1e15));

const spaceOf = ([x, y, z]: readonly [Vec3, Vec3, Vec3], origin: Vec3, eye: Vec3, linear: boolean): PackSpace => ({
  worldToShading: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -origin[0], -origin[1], -origin[2], 1],
  cameraToShading: [...x, 0, ...y, 0, ...z, 0, ...subtract(eye, origin), 1],
  linear,
});

const anySpace = fc.tuple(rotation, place, place, fc.boolean()).map((parts) => spaceOf(...parts));

describe('packed lights of any values', () => {
  it('are finite, with unit directions and no negative colours, and count and contain active lights only', () => {
    fc.assert(
      fc.property(fc.array(anyLight, { maxLength: 10 }), anySpace, (lights, space) => {
        const packed = pack(lights, space);
        const { data, rows } = packed;
        expect(data.subarray(0, rows * 4).findIndex((x) => !Number.isFinite(x))).toBe(-1);
        const { directional, point, spot, ambient, counts } = read(packed);
        for (const light of directional) expect(Math.hypot(...light['direction']!.xyz)).toBeCloseTo(1, 6);
        for (const light of spot) expect(Math.hypot(...light['axis']!.xyz)).toBeCloseTo(1, 6);
        const colors = [...directional, ...point, ...spot].flatMap((light) => [
          light['diffuse']!.xyz,
          light['specular']!.xyz,
        ]);
        expect([ambient, ...colors].flat().every((x) => x >= 0)).toBe(true);
        const active = lights.filter((light) => light.active);
        expect(packed.active).toBe(active.length);
        expect(packed.sent).toBe(counts[0] + counts[1] + counts[2]);
        for (const [k, kind] of KINDS.entries())
          expect(counts[k]).toBeLessThanOrEqual(active.filter((light) => kindOf(light) === kind).length);
        const alone = pack(active, space);
        expect(data.subarray(0, rows * 4)).toStrictEqual(alone.data.subarray(0, alone.rows * 4));
      }),
      { numRuns: 700 },
    );
  });
});

describe('packed lights read as the loop reads them', () => {
  const surface = { ka: [200, 150, 100], kd: [255, 200, 50], ks: [128, 255, 60], shininess: 8 } as const;

  it("give the reference's sum, in every space, in linear light too", () => {
    const scene = fc.tuple(
      ...[fc.array(plainLight, { minLength: 1, maxLength: 6 }), rotation, plainVector, plainVector],
      ...[plainVector, plainVector, fc.boolean(), fc.boolean()],
    );
    fc.assert(
      fc.property(scene, ([all, axes, origin, eye, p, normal, far, linear]) => {
        const offset: Vec3 = far ? [2 ** 30, -(2 ** 31), 2 ** 30] : [0, 0, 0];
        const moved = (v: Vec3): Vec3 => [v[0] + offset[0], v[1] + offset[1], v[2] + offset[2]];
        const scene = all.map((light) => {
          const { position, space } = light;
          if (position[3] === 0 || space === 'camera') return light;
          return { ...light, position: [...moved([position[0], position[1], position[2]]), 1] as const };
        });
        const [right, up, back] = axes;
        const camera = { right, up, back };
        const want = shade({ p: moved(p), normal, eye: moved(eye) }, surface, scene, { camera, linear });
        // Rows are rounded to float32: a fragment within that of a cone's edge may fall on either side.
        fc.pre(
          want.shares.every((share, i) => {
            const { aperture } = scene[i]!;
            if (share === null || aperture === 180) return true;
            return Math.abs(Math.acos(Math.min(Math.max(share.c, -1), 1)) - (aperture * Math.PI) / 180) > 1e-4;
          }),
        );
        fc.pre(want.shares.every((share) => share === null || share.d > 0.1));
        const { ambient, diffuse, specular } = loop(
          read(pack(scene, spaceOf(axes, moved(origin), moved(eye), linear))),
          subtract(p, origin),
          normalize(normal),
          subtract(eye, origin),
          surface.shininess,
        );
        const { ka, kd, ks } = coefficientsOf(surface, linear);
        for (const i of [0, 1, 2] as const) {
          const sum = linear ? srgbDecode(want.sum[i]) : want.sum[i];
          const got = ka[i] * ambient[i] + kd[i] * diffuse[i] + ks[i] * specular[i];
          expect(Math.abs(got - sum)).toBeLessThan(1e-4);
        }
      }),
      { numRuns: 300 },
    );
  });
});

describe("the cone's limit", () => {
  it('is 0 for no width, and accepts everything at 180 degrees', () => {
    expect([coneLimit(0), coneLimit(180)]).toStrictEqual([0, LIMIT_OPEN]);
  });

  // sin² and -cos² of half the angle, from 50 digits.
  it.each([
    [60, 0.25],
    [90, 0.5],
    [120, -0.25],
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

  it('is below 0 exactly where the far side is compared, never underflows, and grows with the aperture', () => {
    const included = (aperture: number): number => {
      const limit = coneLimit(aperture);
      return limit < 0 ? 1 + limit : limit;
    };
    fc.assert(
      fc.property(numbers(1e-12, 180), numbers(1e-12, 180), (aperture, other) => {
        const limit = Math.fround(coneLimit(aperture));
        expect(limit < 0).toBe(aperture > 90 && aperture < 180);
        expect(Math.abs(limit)).toBeGreaterThan(2 ** -126);
        if (aperture < 180) expect(Math.abs(limit)).toBeLessThanOrEqual(0.5);
        const [narrow, wide] = [Math.min(aperture, other), Math.max(aperture, other)];
        expect(included(wide)).toBeGreaterThanOrEqual(included(narrow));
      }),
    );
  });
});
