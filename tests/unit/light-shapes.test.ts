// What each packed light needs of a program made for exactly it: every bit where it is needed, and nowhere else.

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { HEADER, LARGEST_MILD, LIMIT_OPEN, ROWS, SHAPE } from '../../src/light/light-layout.js';
import { forEachLight } from '../../src/light/cull-lights.js';
import type { LightValues } from '../../src/light/light-state.js';
import { emptyPack, packLights } from '../../src/light/pack-lights.js';
import { srgbDecode } from '../../src/math/color.js';
import type { Vec3 } from '../../src/math/vector.js';
import { anyLight, light } from './arbitraries.js';
import { pack, WORLD } from './packed-reader.js';

const lamp = { position: [1, 2, 3, 1], ambient: [9, 9, 9] } as const satisfies Partial<LightValues>;
const shining = SHAPE.diffuse + SHAPE.specular;
const inCone = shining + SHAPE.ambient;
/** A cone of up to 15 degrees, and one that a cosine finds. */
const slim = SHAPE.narrow + SHAPE.chords;
const blunt = SHAPE.wide;

const shapeOf = (values: Partial<LightValues>): number | undefined => {
  const { shapes, sent } = pack([light(values)]);
  return sent === 1 ? shapes[0] : undefined;
};

describe('the shape of a light', () => {
  it.each<[string, Partial<LightValues>, number]>([
    ['a directional light', { ambient: [9, 9, 9] }, shining],
    [
      'a directional light’s cone, decay and attenuation',
      { aperture: 60, cutoff: 5, attenuation: [2, 2, 2] },
      shining,
    ],
    ['a lamp', lamp, shining],
    ['a lamp without diffuse light', { ...lamp, diffuse: [0, 0, 0] }, SHAPE.specular],
    [
      'a lamp with one channel of diffuse light',
      { ...lamp, diffuse: [0, 0, 1], specular: [0, 0, 0] },
      SHAPE.diffuse + SHAPE.tintedDiffuse,
    ],
    [
      'a lamp with tinted light of both kinds',
      { ...lamp, diffuse: [9, 9, 8], specular: [8, 9, 9] },
      shining + SHAPE.tintedDiffuse + SHAPE.tintedSpecular,
    ],
    ['a lamp without specular light', { ...lamp, specular: [0, 0, 0] }, SHAPE.diffuse],
    ['a lamp with an axis alone', { ...lamp, axis: [0, 1, 0] }, shining],
    ['a lamp’s cone about no axis', { ...lamp, axis: [0, 0, 0], aperture: 20, cutoff: 3 }, shining],
    ['kc above 1', { ...lamp, attenuation: [1.01, 0, 0] }, shining + SHAPE.attenuated],
    ['kc up to 1', { ...lamp, attenuation: [1, 0, 0] }, shining],
    ['kc below 1', { ...lamp, attenuation: [0.99, 0, 0] }, shining + SHAPE.clamped],
    ['kl', { ...lamp, attenuation: [1, 1e-9, 0] }, shining + SHAPE.attenuated + SHAPE.linear],
    ['kq', { ...lamp, attenuation: [0, 0, 1e-9] }, shining + SHAPE.attenuated + SHAPE.clamped],
    ['a spot', { ...lamp, aperture: 20 }, inCone + blunt],
    ['a spot without ambient light', { ...lamp, aperture: 20, ambient: [0, 0, 0] }, shining + blunt],
    [
      'a spot with ambient light alone',
      { ...lamp, aperture: 20, diffuse: [0, 0, 0], specular: [0, 0, 0] },
      SHAPE.ambient + blunt,
    ],
    ['a cone of no width', { ...lamp, aperture: 0 }, inCone + slim],
    ['a cone that is just too slim for a cosine', { ...lamp, aperture: 14.9999 }, inCone + slim],
    ['a cone of 15°', { ...lamp, aperture: 15 }, inCone + blunt],
    ['a cone of 90°', { ...lamp, aperture: 90 }, inCone + blunt],
    ['a cone of 165°', { ...lamp, aperture: 165 }, inCone + blunt],
    ['a cone of a little more', { ...lamp, aperture: 165.0001 }, inCone + blunt + SHAPE.chords],
    ['a cone of nearly all', { ...lamp, aperture: 179.9999 }, inCone + blunt + SHAPE.chords],
    ['a decay without a cone', { ...lamp, cutoff: 1.5 }, inCone + SHAPE.decay + SHAPE.mild],
    [
      'a decay that begins steeply',
      { ...lamp, cutoff: 0.5 },
      inCone + SHAPE.decay + SHAPE.mild + SHAPE.chords,
    ],
    [
      'all at once',
      { ...lamp, aperture: 100, cutoff: 7, attenuation: [1, 1, 1] },
      inCone + blunt + SHAPE.attenuated + SHAPE.linear + (7 << SHAPE.powerShift),
    ],
  ])('of %s has what it needs', (_, values, shape) => {
    expect(shapeOf(values)).toBe(shape);
  });

  it('has whole cutoffs from 1 to 64 as they are, and no others', () => {
    const { powerShift, decay, mild, chords } = SHAPE;
    const cone = { ...lamp, aperture: 20 };
    for (let cutoff = 1; cutoff <= LARGEST_MILD; cutoff++) {
      expect(shapeOf({ ...cone, cutoff })).toBe(inCone + blunt + (cutoff << powerShift));
      if (cutoff > 1)
        expect(shapeOf({ ...cone, cutoff: cutoff - 1e-12 })).toBe(inCone + blunt + decay + mild);
      if (cutoff === LARGEST_MILD) continue;
      expect(shapeOf({ ...cone, cutoff: cutoff + 1e-12 })).toBe(inCone + blunt + decay + mild);
    }
    for (const cutoff of [1e-6, 0.5, 1 - 1e-12])
      expect(shapeOf({ ...cone, cutoff })).toBe(inCone + blunt + decay + mild + chords);
    for (const cutoff of [LARGEST_MILD + 1e-12, LARGEST_MILD + 1, 128, 256, 1e6])
      expect(shapeOf({ ...cone, cutoff })).toBe(inCone + blunt + decay + chords);
    for (const cutoff of [0, 5e-324, 9.99e-7]) expect(shapeOf({ ...cone, cutoff })).toBe(inCone + blunt);
  });

  it.each<[string, Partial<LightValues>]>([
    ['ambient', { ambient: [0, 0, 0] }],
    ['diffuse', { diffuse: [0, 0, 0] }],
    ['specular', { specular: [0, 0, 0] }],
    ['attenuation', { attenuation: [1, 1, 0] }],
    ['aperture', { aperture: 14 }],
    ['cutoff', { cutoff: 3 }],
    ['axis', { axis: [0, 0, 0] }],
    ['w', { position: [0, 0, 1, 0] }],
  ])('is found anew in a pack that is used again, where the light’s %s has changed', (_, change) => {
    const before = light({ ...lamp, aperture: 20 });
    const after = { ...before, ...change };
    const packed = emptyPack();
    const live = { ...before };
    for (const values of [before, after, before]) {
      Object.assign(live, values);
      packLights([live], WORLD, packed);
      const fresh = pack([values]);
      expect(packed.shapes[0]).toBe(fresh.shapes[0]);
      expect(packed.data.slice(0, packed.rows * 4)).toStrictEqual(fresh.data.slice(0, fresh.rows * 4));
    }
    expect(shapeOf(after)).not.toBe(shapeOf(before));
  });

  it('stays, and its colours are found anew, where the picture becomes linear', () => {
    const packed = emptyPack();
    const gray = light({ ...lamp, diffuse: [128, 128, 128] });
    const colors = [false, true, false].map((linear) => {
      packLights([gray], { ...WORLD, linear }, packed);
      expect(packed.shapes[0]).toBe(shining);
      return packed.data[(HEADER.rows + ROWS.point.diffuse) * 4];
    });
    expect(colors).toStrictEqual([128 / 255, srgbDecode(128 / 255), 128 / 255].map(Math.fround));
  });

  it.each([0, 1, 2])('keeps a spot that brings ambient light of channel %d alone', (channel) => {
    const black = [0, 0, 0] as const;
    const ambient = [0, 1, 2].map((c) => (c === channel ? 9 : 0)) as unknown as Vec3;
    expect(shapeOf({ ...lamp, aperture: 20, diffuse: black, specular: black, ambient })).toBe(
      SHAPE.ambient + SHAPE.wide,
    );
  });

  it('says no more of the darkest and the faintest than that they are there', () => {
    expect(shapeOf({ ...lamp, diffuse: [5e-324, 0, 0], specular: [0, 0, 0] })).toBe(
      SHAPE.diffuse + SHAPE.tintedDiffuse,
    );
  });

  it('stands for the light whose rows it goes with, and lets nothing of it out', () => {
    fc.assert(
      fc.property(fc.array(anyLight, { maxLength: 8 }), (lights) => {
        const packed = pack(lights);
        forEachLight(packed, (i, kind, row) => {
          const shape = packed.shapes[i]!;
          const at = (offset: number, component: number): number =>
            packed.data[(row + offset) * 4 + component]!;
          const colored = (offset: number): boolean => [0, 1, 2].some((c) => at(offset, c) !== 0);
          const lets = (bit: number): boolean => (shape & bit) !== 0;
          const { diffuse, specular } = ROWS[kind];
          const tinted = (offset: number): boolean =>
            at(offset, 0) !== at(offset, 1) || at(offset, 1) !== at(offset, 2);
          if (colored(diffuse)) expect(lets(SHAPE.diffuse)).toBe(true);
          if (colored(specular)) expect(lets(SHAPE.specular)).toBe(true);
          if (tinted(diffuse)) expect(lets(SHAPE.tintedDiffuse)).toBe(true);
          if (tinted(specular)) expect(lets(SHAPE.tintedSpecular)).toBe(true);
          const terms = shining + SHAPE.tintedDiffuse + SHAPE.tintedSpecular;
          if (kind === 'directional') expect(shape & ~terms).toBe(0);
          if (kind === 'directional') return;
          const [kc, kl, kq] = [at(0, 3), at(1, 3), at(2, 3)];
          if (kc > 1 || kl > 0 || kq > 0) expect(lets(SHAPE.attenuated)).toBe(true);
          if (kc < 1) expect(lets(SHAPE.clamped)).toBe(true);
          if (kl > 0) expect(lets(SHAPE.linear)).toBe(true);
          const attenuation = SHAPE.attenuated + SHAPE.clamped + SHAPE.linear;
          if (kind === 'point') expect(shape & ~(terms + attenuation)).toBe(0);
          if (kind === 'point') return;
          const limit = at(ROWS.spot.ambient, 3);
          expect(lets(SHAPE.wide)).toBe(limit < 0);
          expect(lets(SHAPE.narrow)).toBe(limit >= 0 && limit <= 0.5);
          const cutoff = at(ROWS.spot.axis, 3);
          const edge = limit < 0 ? Math.min(-limit, 1 + limit) : Math.min(limit, LIMIT_OPEN - limit);
          const steep = cutoff > LARGEST_MILD || (cutoff >= Math.fround(1e-6) && cutoff < 1);
          // sin²(7.5°), as float32
          if (steep || (edge > 0 && edge < 0.01703)) expect(lets(SHAPE.chords)).toBe(true);
          const whole = shape >> SHAPE.powerShift;
          if (whole > 0) expect(whole).toBe(cutoff);
          else expect(lets(SHAPE.decay)).toBe(cutoff >= Math.fround(1e-6));
          if (lets(SHAPE.mild)) expect(lets(SHAPE.decay) && whole === 0 && cutoff <= LARGEST_MILD).toBe(true);
          if (cutoff > LARGEST_MILD) expect(lets(SHAPE.decay)).toBe(true);
        });
      }),
      { numRuns: 300 },
    );
  });
});

it('has room for the shapes of any number of lights', () => {
  const lights = Array.from({ length: 300 }, (_, i) =>
    light({ ...lamp, aperture: 20, cutoff: 1 + (i % 64) }),
  );
  const { shapes, sent } = pack(lights);
  expect(sent).toBe(300);
  expect([...shapes.slice(0, sent)].map((shape) => shape >> SHAPE.powerShift)).toStrictEqual(
    lights.map(({ cutoff }) => cutoff),
  );
});
