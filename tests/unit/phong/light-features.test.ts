// Of which kind is a light, which code does it need, and which code must the general program have
// for it?

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { kindFeatures } from '../../../src/phong/light/kind-features.js';
import {
  declaredFeatures,
  featuresOf,
  kindOf,
  unionOf,
} from '../../../src/phong/light/light-features.js';
import { LIGHT_FEATURES } from '../../../src/phong/light/light-layout.js';
import { LARGEST_INTEGER_POWER } from '../../../src/phong/light/precision.js';
import type { LightValues } from '../../../src/phong/light/light-state.js';
import { anyLight, light } from '../arbitraries.js';

const lamp = { position: [1, 2, 3, 1], ambient: [9, 9, 9] } as const satisfies Partial<LightValues>;
const spot = { ...lamp, aperture: 20 } as const;
const black = { ambient: [0, 0, 0], diffuse: [0, 0, 0], specular: [0, 0, 0] } as const;
const darkLamp = { ...lamp, ...black } as const;
const darkSpot = { ...spot, ...black } as const;

it.each<[string, Partial<LightValues>, string]>([
  ['w = 0 with a cone', { aperture: 20, cutoff: 5 }, 'directional'],
  ['a cone of no width', { ...lamp, aperture: 0 }, 'spot'],
  ['a decay', { ...lamp, cutoff: 1e-6 }, 'spot'],
  ['a decay too slight to be one', { ...lamp, cutoff: 9.99e-7 }, 'point'],
  ['an axis alone', { ...lamp, axis: [1, 2, 3] }, 'point'],
  ['a cone without an axis', { ...lamp, aperture: 20, cutoff: 5, axis: [0, 0, 0] }, 'point'],
  ['a cone about the shortest axis', { ...lamp, aperture: 20, axis: [0, 5e-324, 0] }, 'spot'],
])('the kind of a light with %s is %s', (_, values, kind) => {
  expect(kindOf(light(values))).toBe(kind);
});

/** The names of the bits in a mask, sorted, and `power n` for an integer power. */
function namesIn(mask: number) {
  const { powerShift, ...bits } = LIGHT_FEATURES;
  const names = Object.entries(bits).flatMap(([name, bit]) => ((mask & bit) !== 0 ? [name] : []));
  const power = mask >> powerShift;
  return [...names, ...(power > 0 ? [`power ${power}`] : [])].sort();
}

describe('the features of a light', () => {
  const lit = ['diffuse', 'specular'];
  const inCone = ['ambient', ...lit];
  it.each<[string, Partial<LightValues>, string[]]>([
    [
      'a directional light',
      { ambient: [9, 9, 9], aperture: 60, cutoff: 5, attenuation: [2, 2, 2] },
      lit,
    ],
    ['a lamp', lamp, lit],
    ['a lamp without diffuse light', { ...lamp, diffuse: [0, 0, 0] }, ['specular']],
    ['a lamp of one channel', { ...darkLamp, diffuse: [0, 0, 1] }, ['diffuse', 'tintedDiffuse']],
    ['tinted specular light', { ...lamp, specular: [8, 9, 9] }, [...lit, 'tintedSpecular']],
    ['kc above 1', { ...lamp, attenuation: [1.01, 0, 0] }, [...lit, 'attenuated']],
    ['kc below 1', { ...lamp, attenuation: [0.99, 0, 0] }, [...lit, 'clamped']],
    ['kl', { ...lamp, attenuation: [1, 1e-9, 0] }, [...lit, 'attenuated', 'linear']],
    ['kq', { ...lamp, attenuation: [0, 0, 1e-9] }, [...lit, 'attenuated', 'clamped']],
    ['a spot', spot, [...inCone, 'wide']],
    ['a spot with ambient light alone', { ...darkSpot, ambient: [0, 1, 0] }, ['ambient', 'wide']],
    ['a cone of no width', { ...lamp, aperture: 0 }, [...inCone, 'narrow', 'chords']],
    [
      'a cone just too slim for a cosine',
      { ...lamp, aperture: 14.9999 },
      [...inCone, 'narrow', 'chords'],
    ],
    ['a cone of 15°', { ...lamp, aperture: 15 }, [...inCone, 'wide']],
    ['a cone of 165°', { ...lamp, aperture: 165 }, [...inCone, 'wide']],
    ['a cone of a little more', { ...lamp, aperture: 165.0001 }, [...inCone, 'wide', 'chords']],
    ['a decay without a cone', { ...lamp, cutoff: 1.5 }, [...inCone, 'decay']],
    ['a decay that begins steeply', { ...lamp, cutoff: 0.5 }, [...inCone, 'decay', 'chords']],
    ['a decay of 1', { ...lamp, cutoff: 1 }, [...inCone, 'power 1']],
    ['a decay beyond 32', { ...lamp, cutoff: 32.5 }, [...inCone, 'decay', 'chords']],
    ['an integer cutoff', { ...spot, cutoff: 7 }, [...inCone, 'wide', 'power 7']],
    [
      'the largest integer cutoff',
      { ...spot, cutoff: 64 },
      [...inCone, 'wide', 'chords', 'power 64'],
    ],
    ['a whole cutoff beyond it', { ...spot, cutoff: 65 }, [...inCone, 'wide', 'chords', 'decay']],
  ])('of %s are what it needs', (_, values, needed) => {
    const one = light(values);
    expect(namesIn(featuresOf(one, kindOf(one)))).toStrictEqual(needed.toSorted());
  });

  it('are united for several lights, with an integer power only if all have the same', () => {
    fc.assert(
      fc.property(anyLight, anyLight, (a, b) => {
        const maskOf = (one: LightValues) => featuresOf({ ...one, position: [0, 0, 0, 1] }, 'spot');
        const [first, second] = [maskOf(a), maskOf(b)];
        const both = unionOf(first, second);
        expect(unionOf(second, first)).toBe(both);
        expect(unionOf(first, first)).toBe(first);
        const power = (mask: number) => mask >> LIGHT_FEATURES.powerShift;
        for (const own of [first, second]) {
          const others = own & ((1 << LIGHT_FEATURES.powerShift) - 1);
          expect(both & others).toBe(others);
          if (power(both) > 0) {
            expect(power(own)).toBe(power(both));
          } else if (power(own) > 0) {
            expect(both & LIGHT_FEATURES.decay).not.toBe(0);
          }
        }
      }),
    );
  });

  it('are bits below the power, and all fit an int of GLSL', () => {
    const { powerShift, ...bits } = LIGHT_FEATURES;
    expect(Math.max(...Object.values(bits))).toBeLessThan(1 << powerShift);
    expect((LARGEST_INTEGER_POWER + 1) << powerShift).toBeLessThan(2 ** 31);
  });
});

describe('declared features', () => {
  const declaredBy = (...lights: Partial<LightValues>[]) =>
    namesIn(declaredFeatures(lights.map(light)));
  const steep = ['spot', 'wide', 'narrow', 'chords'];

  it.each<[string, Partial<LightValues>, string[]]>([
    ['no light at all', black, ['directional']],
    ['a cone', darkSpot, ['spot', 'wide']],
    ['a decay', { ...darkLamp, cutoff: 2 }, ['spot', 'decay']],
    ['a steep decay without a cone', { ...darkLamp, cutoff: 100 }, ['spot', 'decay', 'chords']],
    ['a decay that is steep behind', { ...darkSpot, cutoff: 0.5 }, [...steep, 'decay']],
    ['a decay that is steep in front', { ...darkSpot, cutoff: 33 }, [...steep, 'decay']],
    ['a narrow cone', { ...darkSpot, aperture: 14 }, steep],
    ['a nearly open cone', { ...darkSpot, aperture: 166 }, steep],
    ['a spot with ambient light', { ...darkSpot, ambient: [0, 1, 0] }, ['spot', 'wide', 'ambient']],
    ['a cone about no axis', { ...darkSpot, axis: [0, 0, 0] }, ['point']],
    ['kq', { ...darkLamp, attenuation: [0, 0, 0.1] }, ['point', 'attenuated', 'clamped', 'linear']],
    ['attenuation that is 1 everywhere', { ...darkLamp, attenuation: [0.5, 0, 0] }, ['point']],
    [
      'every term',
      lamp,
      ['point', 'ambient', 'diffuse', 'tintedDiffuse', 'specular', 'tintedSpecular'],
    ],
  ])('of %s are what it needs', (_, values, needed) => {
    expect(declaredBy(values)).toStrictEqual(needed.toSorted());
  });

  it('include those of inactive lights, so that toggling compiles nothing', () => {
    fc.assert(
      fc.property(anyLight, (values) => {
        expect(declaredBy({ ...values, active: false })).toStrictEqual(
          declaredBy({ ...values, active: true }),
        );
      }),
    );
  });

  it('of many lights are those of each, and a cutoff is none', () => {
    fc.assert(
      fc.property(fc.array(anyLight, { maxLength: 6 }), (lights) => {
        const together = declaredBy(...lights);
        const apart = new Set(lights.flatMap((one) => declaredBy(one)));
        // Only a cone is compared on a side.
        if (apart.has('chords') && apart.has('wide')) {
          apart.add('narrow');
        }
        expect(together).toStrictEqual([...apart].sort());
      }),
    );
  });
});

it('the features of each kind are those that any of its lights needs', () => {
  const { tintedDiffuse, chords, attenuated, decay, powerShift } = LIGHT_FEATURES;
  const counts = { directional: 0, point: 2, spot: 3 };
  const features = [
    attenuated,
    tintedDiffuse,
    4 << powerShift,
    (4 << powerShift) | chords,
    8 << powerShift,
    decay,
  ];
  expect(kindFeatures({ counts, features })).toEqual({
    directional: 0,
    point: attenuated | tintedDiffuse,
    spot: decay | chords,
  });
  expect(kindFeatures({ counts: { ...counts, spot: 2 }, features }).spot).toBe(
    (4 << powerShift) | chords,
  );
});
