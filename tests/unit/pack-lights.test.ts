// What do the rows of packed lights contain, and which lights are left out?

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { coneLimit } from '../../src/light/precision.js';
import { HEADER } from '../../src/light/light-layout.js';
import type { LightValues } from '../../src/light/light-state.js';
import { emptyPack, moveLights, type PackedLights, packLights, selectLights } from '../../src/light/pack-lights.js';
import type { Vec3 } from '../../src/math/vector.js';
import { shade } from '../../src/reference/equation.js';
import { anyLight, light, rotation } from './arbitraries.js';
import { pack, read, WORLD } from './packed-reader.js';

const f = Math.fround;
const floats = (...numbers: number[]): number[] => numbers.map(f);
const colors = { ambient: [51, 102, 153], diffuse: [255, 128, 0], specular: [510, 0, 1] } as const;
const lamp = { ...colors, position: [1, 2, 3, 1] } as const satisfies Partial<LightValues>;
const BLACK = { ambient: [0, 0, 0], diffuse: [0, 0, 0], specular: [0, 0, 0] } as const;
const spot = { ...lamp, axis: [0, -3, -4], aperture: 60, cutoff: 12 } as const satisfies Partial<LightValues>;

it('keeps colours above 255', () => {
  const [{ diffuse, specular } = {}] = read(pack([light(lamp)])).point;
  expect([diffuse?.xyz, specular?.xyz]).toStrictEqual([floats(1, 128 / 255, 0), floats(2, 0, 1 / 255)]);
});

it('makes a cone of no width as wide as float32 needs for its own axis', () => {
  const limit = (aperture: number): number => read(pack([light({ ...spot, aperture })])).spot[0]!['ambient']!.w;
  expect(2 * Math.asin(Math.sqrt(limit(0)))).toBeCloseTo(1e-6, 9);
  expect(limit(1e-4)).toBe(f(coneLimit(1e-4)));
});

it('sorts lights by kind, and within a kind as declared', () => {
  const at = (x: number, more: Partial<LightValues> = {}): LightValues => light({ position: [x, 0, 0, 1], ...more });
  const cone = { aperture: 20 };
  const toward = (y: number): LightValues => light({ position: [0, y, 0, 0] });
  const packed = pack([at(1, cone), at(2), toward(1), at(3), at(4, cone), toward(-1)]);
  const all = read(packed);
  expect(all.counts).toStrictEqual([2, 2, 2]);
  expect(all.directional.map((one) => one['direction']!.xyz[1])).toStrictEqual([1, -1]);
  expect(all.point.map((one) => one['position']!.xyz[0])).toStrictEqual([2, 3]);
  expect(all.spot.map((one) => one['position']!.xyz[0])).toStrictEqual([1, 4]);
  expect(packed.sent).toBe(6);
});

describe('a light is left out of the loop', () => {
  const behind = { position: [0, 1, 0, 0], axis: [0, 1, 0], ambient: [255, 0, 0] } as const;
  it.each<[string, Partial<LightValues>, number]>([
    ['switched off', { active: false, ambient: [255, 0, 0] }, 0],
    ['black', BLACK, 0],
    ['a lamp with ambient colour only', { ...BLACK, position: [1, 2, 3, 1], ambient: [255, 0, 0] }, 1],
    ['a black spot', { ...spot, ...BLACK }, 0],
    ['directional without a direction', { position: [0, 0, 0, 0], ambient: [255, 0, 0] }, 1],
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
    ['a spot with ambient light alone, which its cone limits', { ...spot, ...BLACK, ambient: [0, 5, 0] }],
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

it('moves and rotates places, but only rotates directions and axes, even the shortest, exactly', () => {
  const [cos, sin] = [Math.sqrt(3) / 2, 0.5];
  const worldToShading = [cos, sin, 0, 0, -sin, cos, 0, 0, 0, 0, 1, 0, -100, 0, 0, 1];
  const short = [5e-324, 0, 0] as const;
  const { directional, spot: spots } = read(
    pack([light({ position: [...short, 0] }), light({ ...spot, axis: short, position: [2, 0, 3, 1] })], {
      ...WORLD,
      worldToShading,
    }),
  );
  expect(directional[0]!['direction']!.xyz).toStrictEqual(floats(cos, sin, 0));
  expect(spots[0]!['axis']!.xyz).toStrictEqual(floats(cos, sin, 0));
  expect(spots[0]!['position']!.xyz).toStrictEqual(floats(2 * cos - 100, 1, 3));
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

  it('packs what a new one packs, whatever changes between frames', () => {
    const space = fc.tuple(rotation, fc.boolean()).map(([[x, y, z], linear]) => ({
      worldToShading: [...x, 0, ...y, 0, ...z, 0, 1, 2, 3, 1],
      cameraToShading: [...z, 0, ...x, 0, ...y, 0, 4, 5, 6, 1],
      linear,
    }));
    const frames = fc.array(fc.tuple(fc.array(anyLight, { maxLength: 6 }), space), { maxLength: 4 });
    const essence = ({ data, rows, active, sent, counts, features }: PackedLights): object => ({
      ...{ rows, active, sent, counts },
      data: [...data.subarray(0, rows * 4)],
      features: [...features.subarray(0, sent)],
    });
    fc.assert(
      fc.property(frames, (list) => {
        const into = emptyPack();
        for (const [lights, frame] of list) {
          packLights(lights, frame, into);
          expect(essence(into)).toStrictEqual(essence(pack(lights, frame)));
        }
      }),
    );
  });
});

describe('a selection of lights', () => {
  const lights = [{}, lamp, spot, { ...spot, cutoff: 3 }, { ...lamp, diffuse: [1, 2, 3] as const }].map((one) =>
    light(one),
  );

  it('is the same as packing these lights alone, except for ambient light, which is summed over all', () => {
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
});

// Packing applies them once, in float64: they are the same everywhere.
describe('the cone and decay of a directional light', () => {
  it.each([1e-3, 0.5, 10, 45, 89, 91, 120, 179, 179.999])('end at %d degrees', (degrees) => {
    const angle = (degrees * Math.PI) / 180;
    const sent = (aperture: number): number =>
      pack([light({ position: [Math.sin(angle), Math.cos(angle), 0, 0], axis: [0, -1, 0], aperture })]).sent;
    expect([sent(degrees * (1 + 1e-9)), sent(degrees * (1 - 1e-9))]).toEqual([1, 0]);
  });

  it.each<[number, Vec3, Vec3, number]>([
    [0, [1, 2, 3], [-1, -2, -3], 1],
    [0, [1, 2, 3], [-0.1, -0.2, -0.3], 1],
    [60, [1, Math.sqrt(3), 0], [-1, 0, 0], 1],
    ...[1e-3, 1e-8, 1e-10, 1e-14].map((x): [number, Vec3, Vec3, number] => [0, [x, 1, 0], [0, -1, 0], 0]),
    [180 - 1e-9, [0, 1, 0], [0, 1, 0], 0],
    [180 - 1e-9, [1e-12, 1, 0], [0, 1, 0], 0],
    [180 - 1e-9, [1e-10, 1, 0], [0, 1, 0], 1],
    [180 - 1e-9, [1e-3, 1, 0], [0, 1, 0], 1],
  ])('of %d degrees to %j around %j are met by %d lights', (aperture, [x, y, z], axis, sent) => {
    expect(pack([light({ position: [x, y, z, 0], axis, aperture })]).sent).toBe(sent);
  });

  it('keep the digits of a decay right behind, also with a tiny cutoff', () => {
    const off = 2e-9;
    const behind = (values: Partial<LightValues>): number => {
      const packed = pack([light({ position: [off, 1, 0, 0], axis: [0, 1, 0], ...values })]);
      return read(packed).directional[0]!['diffuse']!.xyz[0];
    };
    // (1 + c)/2 = off²/4, to 1e-18.
    expect(behind({ cutoff: 0.1 }) / ((off * off) / 4) ** 0.1).toBeCloseTo(1, 6);
    expect(behind({ cutoff: 9.9e-7, aperture: 180 - 1e-9 })).toBe(1);
  });

  it('need an axis and a direction', () => {
    const open = { aperture: 0, cutoff: 9, ambient: [255, 0, 0] } as const;
    expect(read(pack([light({ ...open, axis: [0, 0, 0] })])).directional[0]!['diffuse']!.xyz[0]).toBe(1);
    expect(read(pack([light({ ...open, position: [0, 0, 0, 0] })])).ambient[0]).toBe(1);
  });
});

it('includes the same round numbers exactly at the edge as the equation', () => {
  const surface = { ka: [255, 255, 255], kd: [255, 255, 255], ks: [255, 255, 255], shininess: 1 } as const;
  const whole = [-2, -1, 0, 1, 2].flatMap((x) =>
    [-2, -1, 0, 1, 2].flatMap((y) => [-1, 0, 1].map((z) => [x, y, z] as const)),
  );
  const vectors = whole.filter((v) => v.some((x) => x !== 0));
  const disagreeing: string[] = [];
  for (const aperture of [0, 30, 45, 60, 90, 120, 135, 150]) {
    for (const [x, y, z] of vectors) {
      for (const axis of vectors) {
        const spot = light({ position: [x, y, z, 0], axis, aperture });
        const { shares } = shade({ p: [0, 0, 0], normal: [0, 1, 0], eye: [0, 1, 0] }, surface, [spot]);
        if (shares[0]?.insideCone !== (pack([spot]).sent === 1))
          disagreeing.push(`${[x, y, z].join(' ')} | ${axis.join(' ')} | ${aperture}`);
      }
    }
  }
  expect(disagreeing).toEqual([]);
});

describe('lights that only move', () => {
  const rows = ({ data, rows }: PackedLights): number[] => [...data.subarray(0, rows * 4)];

  it('are written into the same rows, as packing them anew would', () => {
    fc.assert(
      fc.property(fc.array(anyLight, { minLength: 1, maxLength: 6 }), rotation, (lights, [x, y, z]) => {
        const packed = pack(lights);
        const before = rows(packed);
        const turned = [...x, 0, ...y, 0, ...z, 0, 1, 2, 3, 1];
        const elsewhere = { ...WORLD, worldToShading: turned };
        const anew = emptyPack();
        packLights(lights, elsewhere, anew);
        const follows = moveLights(elsewhere, packed);
        expect(rows(packed)).toStrictEqual(follows ? rows(anew) : before);
      }),
    );
  });

  it.each<[string, boolean, readonly Partial<LightValues>[]]>([
    ['of every kind', true, [{}, lamp, spot, { ...spot, space: 'camera' }]],
    ['with one that is off', true, [{}, { active: false }]],
    ['where there are none', false, []],
    ['that are all black', false, [BLACK]],
    ['with a directional one that has a cone', false, [{}, { aperture: 90 }]],
    ['with one without a direction', false, [{}, { position: [0, 0, 0, 0] }]],
  ])('%s need no other rows: %s', (_, follows, some) => {
    expect(moveLights(WORLD, pack(some.map((values) => light(values))))).toBe(follows);
  });

  it('need other rows once one has lost its direction', () => {
    const sun = light({});
    const packed = pack([sun]);
    sun.position = [0, 0, 0, 0];
    expect(moveLights(WORLD, packed)).toBe(false);
  });
});
