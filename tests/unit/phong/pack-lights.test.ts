// What do the rows of packed lights contain, and which lights are left out? Over the lights' whole
// domains: finite, consistent, and the reference's sum when read back.

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { coneLimit, LIMIT_OPEN } from '../../../src/phong/light/precision.js';
import { HEADER } from '../../../src/phong/light/light-layout.js';
import type { LightValues } from '../../../src/phong/light/light-state.js';
import { emptyPack, packLights, selectLights } from '../../../src/phong/light/pack-lights.js';
import { srgbDecode } from '../../../src/phong/math/color.js';
import { negate, normalize, subtract, type Vec3 } from '../../../src/phong/math/vector.js';
import { coefficientsOf, shade } from '../../../src/phong/reference/equation.js';
import {
  anyLight,
  light,
  numbers,
  plainLight,
  plainVector,
  rotation,
  triple,
} from '../arbitraries.js';
import { loop, pack, read, WORLD } from '../packed-reader.js';
import { translation } from '../../support/matrices.js';

const f = Math.fround;
const lamp = {
  ambient: [51, 102, 153],
  position: [1, 2, 3, 1],
} as const satisfies Partial<LightValues>;
const BLACK = { ambient: [0, 0, 0], diffuse: [0, 0, 0], specular: [0, 0, 0] } as const;
const spot = {
  ...lamp,
  axis: [0, -3, -4],
  aperture: 60,
  cutoff: 12,
} as const satisfies Partial<LightValues>;

it('makes a cone of no width as wide as float32 needs for its own axis', () => {
  const limit = (aperture: number) =>
    read(pack([light({ ...spot, aperture })])).spot[0]!['ambient']!.w;
  expect(2 * Math.asin(Math.sqrt(limit(0)))).toBeCloseTo(1e-6, 9);
  expect(limit(1e-4)).toBe(f(coneLimit(1e-4)));
});

describe('a light is left out of the loop', () => {
  const behind = { position: [0, 1, 0, 0], axis: [0, 1, 0], ambient: [255, 0, 0] } as const;
  it.each<[string, Partial<LightValues>, number]>([
    ['switched off', { active: false, ambient: [255, 0, 0] }, 0],
    ['black', BLACK, 0],
    [
      'a lamp with ambient colour only',
      { ...BLACK, position: [1, 2, 3, 1], ambient: [255, 0, 0] },
      1,
    ],
    ['a black spot', { ...spot, ...BLACK }, 0],
    [
      'directional without a direction',
      { position: [0, 0, 0, 0], ambient: [255, 0, 0], aperture: 0, cutoff: 9 },
      1,
    ],
    ['directional and out of its own cone', { ...behind, aperture: 170 }, 0],
    ['directional, behind its own decay', { ...behind, cutoff: 1 }, 0],
  ])('that is %s', (_, values, ambient) => {
    const packed = pack([light(values)]);
    expect(packed.rows).toBe(HEADER.rows);
    expect(packed.sent).toBe(0);
    expect(read(packed)).toMatchObject({ counts: [0, 0, 0], ambient: [ambient, 0, 0] });
    expect(packed.active).toBe(values.active === false ? 0 : 1);
  });

  it.each<[string, Partial<LightValues>]>([
    ['a light of one colour', { ...BLACK, specular: [0, 0, 5e-3] }],
    [
      'a spot with ambient light alone, which its cone limits',
      { ...spot, ...BLACK, ambient: [0, 5, 0] },
    ],
    ['a spot with diffuse light alone', { ...spot, ...BLACK, diffuse: [0, 5, 0] }],
    ['a spot with specular light alone', { ...spot, ...BLACK, specular: [0, 5, 0] }],
  ])('but not %s', (_, values) => {
    expect(pack([light(values)]).sent).toBe(1);
  });
});

it('sums ambient light in float64, so that many faint lights are not lost beside a bright one', () => {
  const faint = Array.from({ length: 1000 }, () => light({ ambient: [255e-6, 0, 0] }));
  const [sum] = read(pack([light({ ambient: [255_000, 0, 0] }), ...faint])).ambient;
  expect(sum).toBe(f(1000.001));
});

describe('a pack that is used again', () => {
  it('grows as needed and never shrinks', () => {
    const into = emptyPack();
    expect(read(into)).toStrictEqual(read(pack([])));
    packLights(new Array<LightValues>(100).fill(light(lamp)), WORLD, into);
    expect(into.rows).toBe(HEADER.rows + 300);
    const { data } = into;
    expect(data.length).toBeGreaterThanOrEqual(into.rows * 4);
    packLights([], WORLD, into);
    expect(into.rows).toBe(HEADER.rows);
    expect(into.data).toBe(data);
  });
});

const lights = [
  {},
  lamp,
  spot,
  { ...spot, cutoff: 3 },
  { ...lamp, diffuse: [1, 2, 3] as const },
].map((one) => light(one));

it('a selection of lights is packed as these lights alone, but with the ambient light of all', () => {
  const packed = pack(lights);
  const order = [0, 1, 4, 2, 3]; // sorted by kind
  fc.assert(
    fc.property(fc.uint8Array({ minLength: 5, maxLength: 5, max: 1 }), (mask) => {
      const into = emptyPack();
      selectLights(packed, mask, into);
      const chosen = order.filter((_, i) => mask[i] === 1).map((i) => lights[i]!);
      const alone = read(pack(chosen));
      expect(read(into)).toStrictEqual({ ...alone, ambient: read(packed).ambient });
      expect(into.sent).toBe(chosen.length);
      expect([...into.features.subarray(0, into.sent)]).toStrictEqual(
        [...packed.features.subarray(0, 5)].filter((_, i) => mask[i] === 1),
      );
    }),
  );
});

// Packing applies them once, in float64: they are the same everywhere.
describe('the cone and decay of a directional light', () => {
  it.each([1e-3, 0.5, 10, 45, 89, 91, 120, 179, 179.999])('end at %d degrees', (degrees) => {
    const angle = (degrees * Math.PI) / 180;
    const sent = (aperture: number) =>
      pack([
        light({ position: [Math.sin(angle), Math.cos(angle), 0, 0], axis: [0, -1, 0], aperture }),
      ]).sent;
    expect([sent(degrees * (1 + 1e-9)), sent(degrees * (1 - 1e-9))]).toEqual([1, 0]);
  });

  it.each<[number, Vec3, Vec3, number]>([
    [0, [1, 2, 3], [-1, -2, -3], 1],
    [60, [1, Math.sqrt(3), 0], [-1, 0, 0], 1],
    [0, [1e-3, 1, 0], [0, -1, 0], 0],
    [0, [1e-14, 1, 0], [0, -1, 0], 0],
    [180 - 1e-9, [1e-12, 1, 0], [0, 1, 0], 0],
    [180 - 1e-9, [1e-10, 1, 0], [0, 1, 0], 1],
  ])('of %d degrees to %j around %j are met by %d lights', (aperture, [x, y, z], axis, sent) => {
    expect(pack([light({ position: [x, y, z, 0], axis, aperture })]).sent).toBe(sent);
  });

  it('keep the digits of a decay right behind, also with a tiny cutoff', () => {
    const off = 2e-9;
    const behind = (values: Partial<LightValues>) => {
      const packed = pack([light({ position: [off, 1, 0, 0], axis: [0, 1, 0], ...values })]);
      return read(packed).directional[0]!['diffuse']!.xyz[0];
    };
    // (1 + c)/2 = off²/4, to 1e-18.
    expect(behind({ cutoff: 0.1 }) / ((off * off) / 4) ** 0.1).toBeCloseTo(1, 6);
    expect(behind({ cutoff: 9.9e-7, aperture: 180 - 1e-9 })).toBe(1);
  });

  it('need an axis', () => {
    const packed = pack([light({ aperture: 0, cutoff: 9, axis: [0, 0, 0] })]);
    expect(read(packed).directional[0]!['diffuse']!.xyz[0]).toBe(1);
  });
});

const surface = {
  ka: [200, 150, 100],
  kd: [255, 200, 50],
  ks: [128, 255, 60],
  shininess: 8,
} as const;

it('includes the same round numbers exactly at the edge as the equation', () => {
  const whole = [-2, -1, 0, 1, 2].flatMap((x) =>
    [-2, -1, 0, 1, 2].flatMap((y) => [-1, 0, 1].map((z) => [x, y, z] as const)),
  );
  const vectors = whole.filter((v) => v.some((x) => x !== 0));
  const disagreeing: string[] = [];
  for (const aperture of [0, 45, 60, 90, 120, 135]) {
    for (const [x, y, z] of vectors) {
      for (const axis of vectors) {
        const spot = light({ position: [x, y, z, 0], axis, aperture });
        const { shares } = shade({ p: [0, 0, 0], normal: [0, 1, 0], eye: [0, 1, 0] }, surface, [
          spot,
        ]);
        if (shares[0]?.insideCone !== (pack([spot]).sent === 1)) {
          disagreeing.push(`${[x, y, z].join(' ')} | ${axis.join(' ')} | ${aperture}`);
        }
      }
    }
  }
  expect(disagreeing).toEqual([]);
});

const place = triple(numbers(-1e15, 1e15));

const spaceOf = (
  [x, y, z]: readonly [Vec3, Vec3, Vec3],
  origin: Vec3,
  eye: Vec3,
  linear: boolean,
) => ({
  worldToShading: translation(negate(origin)),
  cameraToShading: [...x, 0, ...y, 0, ...z, 0, ...subtract(eye, origin), 1],
  linear,
});

const anySpace = fc.tuple(rotation, place, place, fc.boolean()).map((parts) => spaceOf(...parts));

it('packed lights are finite and active only, with unit directions and no negative colours', () => {
  fc.assert(
    fc.property(fc.array(anyLight, { maxLength: 10 }), anySpace, (lights, space) => {
      const packed = pack(lights, space);
      const { data, rows } = packed;
      expect(data.subarray(0, rows * 4).findIndex((x) => !Number.isFinite(x))).toBe(-1);
      const { directional, point, spot, ambient } = read(packed);
      for (const light of directional) {
        expect(Math.hypot(...light['direction']!.xyz)).toBeCloseTo(1, 6);
      }
      for (const light of spot) {
        expect(Math.hypot(...light['axis']!.xyz)).toBeCloseTo(1, 6);
      }
      const colors = [...directional, ...point, ...spot].flatMap((light) => [
        light['diffuse']!.xyz,
        light['specular']!.xyz,
      ]);
      expect([ambient, ...colors].flat().every((x) => x >= 0)).toBe(true);
      const active = lights.filter((light) => light.active);
      expect(packed.active).toBe(active.length);
      const alone = pack(active, space);
      expect(data.subarray(0, rows * 4)).toStrictEqual(alone.data.subarray(0, alone.rows * 4));
    }),
    { numRuns: 700 },
  );
});

it("packed lights give the reference's sum, in every space, in linear light too", () => {
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
        return {
          ...light,
          position: [...moved([position[0], position[1], position[2]]), 1] as const,
        };
      });
      const [right, up, back] = axes;
      const camera = { right, up, back };
      const want = shade({ p: moved(p), normal, eye: moved(eye) }, surface, scene, {
        camera,
        linear,
      });
      // Rows are rounded to float32: a fragment within that of a cone's edge may fall on either
      // side.
      fc.pre(
        want.shares.every((share, i) => {
          const { aperture } = scene[i]!;
          if (share === null || aperture === 180) return true;
          return (
            Math.abs(Math.acos(Math.min(Math.max(share.c, -1), 1)) - (aperture * Math.PI) / 180) >
            1e-4
          );
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

describe("the cone's limit", () => {
  it('is 0 for no width, and accepts everything at 180 degrees', () => {
    expect([coneLimit(0), coneLimit(180)]).toStrictEqual([0, LIMIT_OPEN]);
  });

  // sin² and -cos² of half the angle, from 50 digits.
  it.each([
    [90, 0.5],
    [1e-8, 7.6154354946677153e-21],
    [45, 0.14644660940672624],
    [89.999999, 0.49999999127335376],
    [90.000001, -0.49999999127335376],
    [179.999999, -7.6154354562134622e-17],
    [180 - 2 ** -45, -6.1516998020872166e-32],
  ])('at %d degrees is right to 14 digits', (aperture, limit) => {
    expect(Math.abs(coneLimit(aperture) / limit - 1)).toBeLessThan(1e-14);
  });
});
