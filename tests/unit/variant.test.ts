// Which states share a program? Undeclared features cost none, and a specialised program depends on the values of
// lights only if they are inlined.

import fc from 'fast-check';
import { Texture } from 'three';
import { describe, expect, it } from 'vitest';
import { declaredFeatures } from '../../src/light/light-features.js';
import type { LightValues } from '../../src/light/light-state.js';
import { type BaseLook, PLAIN_LOOK } from '../../src/material/file-surface.js';
import { generalVariant, type MaterialFeatures } from '../../src/material/program/variant.js';
import {
  DEFAULT_STYLE,
  REFLECTIONS,
  SHADINGS,
  type ShadingStyle,
} from '../../src/material/material-values.js';
import { TERMS } from '../../src/light/light-state.js';
import { anyLight, light } from './arbitraries.js';

/** What differs from a plain material: fields of its look, of its style and the others, side by side. */
type Difference = Partial<BaseLook & ShadingStyle & Pick<MaterialFeatures, 'linear' | 'mildShininess'>>;

const materialOf = (difference: Difference = {}): MaterialFeatures => ({
  look: { ...PLAIN_LOOK, ...difference },
  style: { ...DEFAULT_STYLE, ...difference },
  ...{ linear: false, mildShininess: true, ...difference },
});

const texture = (channel = 0): Texture => Object.assign(new Texture(), { channel });

const generalKey = (lights: readonly LightValues[], material: Difference = {}, capacity = 0): string =>
  generalVariant(materialOf(material), declaredFeatures(lights), capacity).key;

const count = (keys: readonly string[]): number => new Set(keys).size;

const lamp = { position: [1, 2, 3, 1] } as const;
const spot = { ...lamp, aperture: 20 } as const;
const EVERYTHING = [
  light({ ambient: [9, 9, 9] }),
  light({ ...spot, cutoff: 2 }),
  light({ ...lamp, attenuation: [1, 1, 1] }),
];

describe('the general program', () => {
  it('is the same for any number of lights of declared kinds, at any place and brightness', () => {
    const keys = [1, 2, 50].map((n) =>
      generalKey(
        Array.from({ length: n }, (_, i) => light({ position: [i, 0, 0, 1], diffuse: [i + 1, 1, 1] })),
      ),
    );
    expect(count(keys)).toBe(1);
  });

  it('changes at most once for the first light of each kind', () => {
    const lights = [
      light(),
      light(lamp),
      light(spot),
      light({ aperture: 20 }),
      light({ ...spot, cutoff: 3 }),
    ];
    const keys = lights.map((_, i) => generalKey(lights.slice(0, i + 1)));
    expect(count(keys)).toBe(4); // a directional light's cone needs no code
  });

  it.each<[string, Partial<LightValues>, number]>([
    ['a cone of another width', { aperture: 60 }, 1],
    ['another decay', { cutoff: 7.5 }, 1],
    ['a narrow cone, which a cosine does not find,', { aperture: 5 }, 2],
    ['a decay above 32', { cutoff: 33 }, 2],
    ['ambient light', { ambient: [9, 9, 9] }, 1],
  ])('with %s in a second spot makes %3$i in all', (_, values, programs) => {
    const first = [light({ ambient: [9, 9, 9] }), light({ ...spot, cutoff: 2 })];
    const second = light({ ...spot, cutoff: 2, ...values });
    expect(count([generalKey(first), generalKey([...first, second])])).toBe(programs);
  });

  it.each<[string, Difference, number]>([
    ['flat shading, by its geometry alone,', { shading: 'flat' }, 1],
    ['other orders of terms', { terms: ['specular', 'ambient', 'diffuse'] }, 1],
    ['gouraud shading', { shading: 'gouraud' }, 2],
    ['Blinn’s lobe', { reflection: 'blinn-phong' }, 2],
    ['large exponents', { mildShininess: false }, 2],
    ['fewer terms', { terms: ['diffuse'] }, 2],
    ['a texture', { map: texture() }, 2],
    ['an unlit look', { unlit: true }, 2],
    ['an emissive colour', { emissive: [0, 1, 0] }, 2],
    ['metalness', { metalness: 0.5 }, 2],
    ['a normal map with the second coordinates', { normalMap: texture(1) }, 2],
  ])('with %s makes %3$i in all', (_, material, programs) => {
    expect(count([generalKey(EVERYTHING), generalKey(EVERYTHING, material)])).toBe(programs);
  });

  it('is the same for equal states', () => {
    const anyMap = fc.option(fc.integer({ min: 0, max: 3 }).map(texture));
    const anyDifference: fc.Arbitrary<Difference> = fc.record({
      ...{ shading: fc.constantFrom(...SHADINGS), reflection: fc.constantFrom(...REFLECTIONS) },
      ...{ terms: fc.subarray([...TERMS]) },
      ...{ linear: fc.boolean(), mildShininess: fc.boolean() },
      ...{ vertexColors: fc.boolean(), unlit: fc.boolean() },
      ...{ metalness: fc.constantFrom(0, 1), roughness: fc.constantFrom(null, 0.5) },
      emissive: fc.constantFrom([0, 0, 0] as const, [1, 0, 0] as const),
      ...{ map: anyMap, emissiveMap: anyMap, metalRoughMap: anyMap, normalMap: anyMap },
      alphaMode: fc.constantFrom('opaque', 'mask', 'blend'),
    });
    fc.assert(
      fc.property(anyDifference, fc.array(anyLight, { maxLength: 4 }), (material, lights) => {
        expect(generalKey(lights, { ...material })).toBe(generalKey(lights.toReversed(), material));
      }),
    );
  });
});
