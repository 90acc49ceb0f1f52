// What do the rows of packed lights contain, and which lights are left out?

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { coneLimit } from '../../src/light/precision.js';
import { HEADER } from '../../src/light/light-layout.js';
import { LIMIT_OPEN } from '../../src/light/precision.js';
import type { LightValues } from '../../src/light/light-state.js';
import {
  emptyPack,
  forEachLight,
  type PackedLights,
  packLights,
  selectLights,
} from '../../src/light/pack-lights.js';
import { srgbDecode } from '../../src/math/color.js';
import { anyLight, light, rotation } from './arbitraries.js';
import { pack, type PackedLight, read, WORLD } from './packed-reader.js';

const f = Math.fround;
const floats = (...numbers: number[]): number[] => numbers.map(f);
/** A light's rows as lists of four. */
const rows = (packed: PackedLight | undefined): Record<string, number[]> =>
  Object.fromEntries(Object.entries(packed ?? {}).map(([name, { xyz, w }]) => [name, [...xyz, w]]));

const colors = { ambient: [51, 102, 153], diffuse: [255, 128, 0], specular: [510, 0, 1] } as const;
const lamp = { ...colors, position: [1, 2, 3, 1] } as const satisfies Partial<LightValues>;
const spot = { ...lamp, axis: [0, -3, -4], aperture: 60, cutoff: 12 } as const satisfies Partial<LightValues>;

describe('the rows of a light', () => {
  it('of kind directional hold the unit vector to the light and its colours', () => {
    const { directional, ambient, counts } = read(pack([light({ ...colors, position: [0, 3, 4, 0] })]));
    expect(counts).toStrictEqual([1, 0, 0]);
    expect(ambient).toStrictEqual(floats(0.2, 0.4, 0.6));
    expect(rows(directional[0])).toStrictEqual({
      direction: floats(0, 0.6, 0.8, 0),
      diffuse: floats(1, 128 / 255, 0, 0),
      specular: floats(2, 0, 1 / 255, 0),
    });
  });

  it('of kind point hold position, colours and attenuation', () => {
    const { point, ambient, counts } = read(pack([light({ ...lamp, attenuation: [1.5, 0.25, 0.1] })]));
    expect(counts).toStrictEqual([0, 1, 0]);
    expect(ambient).toStrictEqual(floats(0.2, 0.4, 0.6));
    expect(rows(point[0])).toStrictEqual({
      position: floats(1, 2, 3, 1.5),
      diffuse: floats(1, 128 / 255, 0, 0.25),
      specular: floats(2, 0, 1 / 255, 0.1),
    });
  });

  it('of kind spot also hold axis, cutoff, ambient colour and cone', () => {
    const { spot: spots, ambient, counts } = read(pack([light({ ...spot, attenuation: [1, 2, 3] })]));
    expect(counts).toStrictEqual([0, 0, 1]);
    expect(ambient).toStrictEqual([0, 0, 0]);
    const { ambient: last, ...others } = rows(spots[0]);
    expect(others).toStrictEqual({
      position: floats(1, 2, 3, 1),
      diffuse: floats(1, 128 / 255, 0, 2),
      specular: floats(2, 0, 1 / 255, 3),
      axis: floats(0, -0.6, -0.8, 12),
    });
    expect(last!.slice(0, 3)).toStrictEqual(floats(0.2, 0.4, 0.6));
    expect(last![3]).toBeCloseTo(-0.75, 7); // cos²(30°), on the far side
  });

  it('give a spot without a cone the limit that accepts everything', () => {
    const open = rows(read(pack([light({ ...spot, aperture: 180 })])).spot[0]);
    expect(open['ambient']![3]).toBe(LIMIT_OPEN);
  });

  it('make a cone of no width as wide as float32 needs for its own axis', () => {
    const axis = rows(read(pack([light({ ...spot, aperture: 0 })])).spot[0]);
    const degrees = (Math.asin(Math.sqrt(axis['ambient']![3]!)) * 360) / Math.PI;
    expect((degrees * Math.PI) / 180).toBeCloseTo(1e-6, 9);
    const wider = rows(read(pack([light({ ...spot, aperture: 1e-4 })])).spot[0]);
    expect(wider['ambient']![3]).toBe(Math.fround(coneLimit(1e-4)));
  });
});

describe('the order of lights', () => {
  it('is by kind, and within a kind as declared', () => {
    const at = (x: number, more: Partial<LightValues> = {}): LightValues =>
      light({ position: [x, 0, 0, 1], ...more });
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
});

describe('a light is left out of the loop', () => {
  it.each<[string, Partial<LightValues>, number]>([
    ['switched off', { active: false, ambient: [255, 0, 0] }, 0],
    ['black', { diffuse: [0, 0, 0], specular: [0, 0, 0] }, 0],
    [
      'a lamp with ambient colour only',
      { position: [1, 2, 3, 1], diffuse: [0, 0, 0], specular: [0, 0, 0], ambient: [255, 0, 0] },
      1,
    ],
    ['a black spot', { ...spot, ambient: [0, 0, 0], diffuse: [0, 0, 0], specular: [0, 0, 0] }, 0],
    ['directional without a direction', { position: [0, 0, 0, 0], ambient: [255, 0, 0] }, 1],
    [
      'directional and out of its own cone',
      { position: [0, 1, 0, 0], axis: [0, 1, 0], aperture: 170, ambient: [255, 0, 0] },
      0,
    ],
    [
      'directional, behind its own decay',
      { position: [0, 1, 0, 0], axis: [0, 1, 0], cutoff: 1, ambient: [255, 0, 0] },
      0,
    ],
  ])('that is %s', (_, values, ambient) => {
    const packed = pack([light(values)]);
    expect(packed.rows).toBe(HEADER.rows);
    expect(packed.sent).toBe(0);
    expect(read(packed)).toMatchObject({ counts: [0, 0, 0], ambient: [ambient, 0, 0] });
    expect(packed.active).toBe(values.active === false ? 0 : 1);
  });

  it('but not one with a single colour, nor a spot with ambient light alone, which its cone limits', () => {
    expect(pack([light({ diffuse: [0, 0, 0], specular: [0, 0, 5e-3] })]).sent).toBe(1);
    expect(pack([light({ ...spot, diffuse: [0, 0, 0], specular: [0, 0, 0] })]).sent).toBe(1);
  });

  it.each(['ambient', 'diffuse', 'specular'] as const)('but not a spot with %s light alone', (term) => {
    const black = { ambient: [0, 0, 0], diffuse: [0, 0, 0], specular: [0, 0, 0] } as const;
    expect(pack([light({ ...spot, ...black, [term]: [0, 5, 0] })]).sent).toBe(1);
  });
});

describe('ambient light', () => {
  it('is summed over all lights but spots', () => {
    const packed = pack([
      light({ ambient: [51, 0, 0] }),
      light({ ambient: [0, 51, 0], position: [1, 2, 3, 1] }),
      light({ ambient: [0, 0, 51], position: [0, 0, 0, 0] }),
      light({ ...spot, ambient: [255, 255, 255] }),
      light({ ambient: [255, 0, 0], active: false }),
    ]);
    expect(read(packed).ambient).toStrictEqual(floats(0.2, 0.2, 0.2));
  });

  it('is summed in float64, so that many faint lights are not lost beside a bright one', () => {
    const faint = Array.from({ length: 1000 }, () => light({ ambient: [255e-6, 0, 0] }));
    const [sum] = read(pack([light({ ambient: [255_000, 0, 0] }), ...faint])).ambient;
    expect(sum).toBe(f(1000.001));
  });
});

describe('spaces', () => {
  const world = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -100, 0, 0, 1];
  // The eye at (0, 0, 5) of shading space looks along −x: right is −z, back is +x.
  const camera = [0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 5, 1];
  const space = { worldToShading: world, cameraToShading: camera, linear: false };

  it('transform positions by the whole matrix, directions and axes by its rotation', () => {
    const { directional, spot: spots } = read(
      pack([light({ position: [3, 0, 0, 0] }), light({ ...spot, axis: [2, 0, 0] })], space),
    );
    expect(directional[0]!['direction']!.xyz).toStrictEqual([1, 0, 0]);
    expect(spots[0]!['position']!.xyz).toStrictEqual([-99, 2, 3]);
    expect(spots[0]!['axis']!.xyz).toStrictEqual([1, 0, 0]);
  });

  it('rotate lights of camera space with the eye', () => {
    const inCamera = { space: 'camera' } as const;
    const {
      directional,
      point,
      spot: spots,
    } = read(
      pack(
        [
          light({ position: [0, 0, 1, 0], ...inCamera }),
          light({ position: [1, 2, -3, 1], ...inCamera }),
          light({ ...spot, axis: [0, 0, -1], ...inCamera }),
        ],
        space,
      ),
    );
    expect(directional[0]!['direction']!.xyz.map((x) => x + 0)).toStrictEqual([1, 0, 0]);
    expect(point[0]!['position']!.xyz).toStrictEqual([-3, 2, 4]);
    expect(spots[0]!['axis']!.xyz.map((x) => x + 0)).toStrictEqual([-1, 0, 0]);
  });

  it('rotate even the shortest vectors exactly', () => {
    const [cos, sin] = [Math.sqrt(3) / 2, 0.5];
    const turned = [cos, sin, 0, 0, -sin, cos, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
    const short = [5e-324, 0, 0] as const;
    const { directional, spot: spots } = read(
      pack([light({ position: [...short, 0] }), light({ ...spot, axis: short })], {
        ...space,
        worldToShading: turned,
      }),
    );
    expect(directional[0]!['direction']!.xyz).toStrictEqual(floats(cos, sin, 0));
    expect(spots[0]!['axis']!.xyz).toStrictEqual(floats(cos, sin, 0));
  });

  it('lose nothing far from the origin: the difference is taken before rounding', () => {
    const far = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1e8, 0, 0, 1];
    const { point } = read(
      pack([light({ position: [1e8 + 0.125, 2, 3, 1] })], { ...space, worldToShading: far }),
    );
    expect(point[0]!['position']!.xyz).toStrictEqual([0.125, 2, 3]);
  });
});

describe('linear colours', () => {
  it('are decoded by the sRGB curve first, also above full', () => {
    const linear = { ...WORLD, linear: true };
    const decoded = (code: number): number => f(srgbDecode(code / 255));
    const { point, ambient } = read(pack([light(lamp)], linear));
    expect(point[0]!['diffuse']!.xyz).toStrictEqual([1, decoded(128), 0]);
    expect(point[0]!['specular']!.xyz).toStrictEqual([decoded(510), 0, decoded(1)]);
    expect(ambient).toStrictEqual([51, 102, 153].map(decoded));
  });

  it('are multiplied by the decay after decoding', () => {
    const half = light({ position: [1, 0, 0, 0], axis: [0, -1, 0], cutoff: 1, diffuse: [128, 0, 0] });
    const { directional } = read(pack([half], { ...WORLD, linear: true }));
    expect(directional[0]!['diffuse']!.xyz[0]).toBeCloseTo(srgbDecode(128 / 255) / 2, 7);
  });
});

describe('a pack that is used again', () => {
  const many = Array.from({ length: 100 }, (_, i) => light({ position: [i, 0, 0, 1] }));

  it('grows as needed and never shrinks', () => {
    const into = emptyPack();
    packLights(many, WORLD, into);
    expect(into.rows).toBe(HEADER.rows + 300);
    const { length } = into.data;
    expect(length).toBeGreaterThanOrEqual(into.rows * 4);
    const { data } = into;
    packLights([], WORLD, into);
    expect(into.rows).toBe(HEADER.rows);
    expect(into.data).toBe(data);
    expect(into.data.length).toBe(length);
  });

  it('holds the same as a new one, whatever it held before', () => {
    const into = emptyPack();
    packLights(
      [...many, light({ ...spot, ambient: [255, 255, 255] }), light({ ambient: [9, 9, 9] })],
      WORLD,
      into,
    );
    const lights = [light(lamp), light(spot), light()];
    packLights(lights, WORLD, into);
    const fresh = pack(lights);
    expect(into).toMatchObject({ rows: fresh.rows, active: 3, sent: 3 });
    expect(into.data.slice(0, into.rows * 4)).toStrictEqual(fresh.data.slice(0, fresh.rows * 4));
  });

  it('begins as an empty picture', () => {
    expect(read(emptyPack())).toStrictEqual({ ...read(pack([])) });
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
  const lights = [
    light(),
    light(lamp),
    light(spot),
    light({ ...spot, cutoff: 3 }),
    light({ ...lamp, diffuse: [1, 2, 3] }),
  ];

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

  it('visits each light with its kind and first row', () => {
    const seen: unknown[] = [];
    forEachLight(pack(lights), (...one) => seen.push(one));
    expect(seen).toStrictEqual([
      [0, 'directional', 2],
      [1, 'point', 5],
      [2, 'point', 8],
      [3, 'spot', 11],
      [4, 'spot', 16],
    ]);
  });
});
