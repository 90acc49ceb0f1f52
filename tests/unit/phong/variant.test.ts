// Which states share a general program, and how many specialised ones are kept? Undeclared features
// cost none.

import fc from 'fast-check';
import { Camera, Mesh, Texture } from 'three';
import { describe, expect, it } from 'vitest';
import { declaredFeatures } from '../../../src/phong/light/light-features.js';
import { type LightValues } from '../../../src/phong/light/light-state.js';
import { type BaseLook, PLAIN_LOOK } from '../../../src/phong/material/file-surface.js';
import { ProgramCache } from '../../../src/phong/material/program/program-cache.js';
import {
  generalVariant,
  type MaterialFeatures,
} from '../../../src/phong/material/program/variant.js';
import { DEFAULT_STYLE, type ShadingStyle } from '../../../src/phong/material/material-values.js';
import { anyLight, light } from '../arbitraries.js';
import { FakeRenderer } from '../fake-renderer.js';

/**
 * What differs from a plain material: fields of its look, of its style and the others, side by
 * side.
 */
type Difference = Partial<
  BaseLook & ShadingStyle & Pick<MaterialFeatures, 'linear' | 'mildShininess'>
>;

const materialOf = (difference: Difference = {}) => ({
  look: { ...PLAIN_LOOK, ...difference },
  style: { ...DEFAULT_STYLE, ...difference },
  linear: false,
  mildShininess: true,
  ...difference,
});

const texture = (channel = 0) => Object.assign(new Texture(), { channel });

const generalKey = (lights: readonly LightValues[], material: Difference = {}) =>
  generalVariant(materialOf(material), declaredFeatures(lights), 0).key;

const EVERYTHING = [
  light({ ambient: [9, 9, 9] }),
  light({ position: [1, 2, 3, 1], aperture: 20, cutoff: 2, attenuation: [1, 1, 1] }),
];

describe('the general program', () => {
  it('depends on the features that lights declare, on no number, place or brightness', () => {
    const lights = fc.array(anyLight, { maxLength: 3 });
    fc.assert(
      fc.property(lights, lights, (a, b) => {
        const isSame = declaredFeatures(a) === declaredFeatures(b);
        expect(generalKey(a) === generalKey(b)).toBe(isSame);
      }),
    );
  });

  it.each<[string, Difference, number]>([
    ['flat shading, by its geometry alone,', { shading: 'flat' }, 1],
    ['other orders of terms', { terms: ['specular', 'ambient', 'diffuse'] }, 1],
    ['fewer terms', { terms: ['diffuse'] }, 2],
    ['a texture', { map: texture() }, 2],
    ['an unlit look', { unlit: true }, 2],
    ['an emissive colour', { emissive: [0, 1, 0] }, 2],
    ['metalness', { metalness: 0.5 }, 2],
    ['a normal map with the second coordinates', { normalMap: texture(1) }, 2],
  ])('with %s makes %3$i in all', (_, material, count) => {
    expect(new Set([generalKey(EVERYTHING), generalKey(EVERYTHING, material)]).size).toBe(count);
  });
});

it('32 specialised programs are kept at most, whatever is drawn after each other', () => {
  const { renderer, compiled } = new FakeRenderer();
  const draw = { renderer, camera: new Camera(), mesh: new Mesh() };
  const cache = new ProgramCache(0);
  const live = new Set<unknown>();
  let shown = 0;
  for (let frame = 0; frame < 2400; frame++) {
    cache.begin();
    const key = String(Math.floor(frame / 30));
    const variant = cache.choose(key, draw, () =>
      generalVariant(materialOf(), declaredFeatures([]), 0),
    );
    shown += Number(variant !== null);
    for (const material of compiled.splice(0)) {
      live.add(material);
      material.addEventListener('dispose', () => live.delete(material));
    }
    expect(live.size).toBeLessThanOrEqual(32);
  }
  expect(shown).toBeGreaterThan(80);
});
