// Does a light have the documented defaults and domains, also when it is made from a plain object?

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { numberField } from '../../../src/phong/fields/field.js';
import {
  LIGHT_FIELDS,
  type LightField,
  LightState,
  type LightValues,
  LIMITS,
  type Term,
  TERMS,
} from '../../../src/phong/light/light-state.js';
import { shade } from '../../../src/phong/reference/index.js';
import { anyLight, plainLight } from '../arbitraries.js';

describe('a light', () => {
  it('is made from any subset of values, or not at all if one is wrong', () => {
    const { values } = new LightState({ cutoff: 12, diffuse: [1, 2, 3] });
    expect(values).toMatchObject({ cutoff: 12, diffuse: [1, 2, 3], aperture: 180 });
    expect(() => new LightState({ cutoff: -1 })).toThrow(RangeError);
    expect(() => new LightState({ space: 'view' as 'world' })).toThrow(RangeError);
  });

  it('keeps every value of its domains unchanged', () => {
    fc.assert(
      fc.property(anyLight, (values) => {
        const kept = { ...new LightState(values).values };
        // 0 and -0 are the same value; which one was drawn does not matter.
        expect(JSON.stringify(kept)).toBe(JSON.stringify(values));
      }),
    );
  });
});

it('keeps every product of the equation inside float32', () => {
  const { coordinate, color, attenuation } = LIMITS;
  const largest = 2 ** 127;
  // Places, fragments and origins may stand at opposite ends.
  const d2 = 3 * (4 * coordinate) ** 2;
  expect(attenuation * d2 + attenuation * Math.sqrt(d2) + attenuation).toBeLessThan(largest);
  const decoded = ((color / 255 + 0.055) / 1.055) ** 2.4;
  expect(decoded * decoded * 1e6).toBeLessThan(largest);
});

it('says of every value what shading makes of it, or does not compile', () => {
  // @ts-expect-error nothing says where it is packed, nor that it selects a kind or changes no picture
  const forgotten: LightField<number> = numberField(0, {});
  expect('shading' in forgotten).toBe(false);
});

it('the equation takes every value in the terms that the table says, and in no other', () => {
  const fragment = { p: [0, 0, 0], normal: [0, 0, 1], eye: [1, 0, 3] } as const;
  const gray = [200, 200, 200] as const;
  const surface = { ka: gray, kd: gray, ks: gray, shininess: 2 };
  const camera = { right: [0.6, 0, -0.8], up: [0, 1, 0], back: [0.8, 0, 0.6] } as const;
  const numberOf = (light: LightValues, term: Term) =>
    String(shade(fragment, surface, [light], { camera }).shares[0]?.[term]);
  const lights = fc.sample(plainLight, { numRuns: 400, seed: 1 });
  for (const [key, { shading }] of Object.entries(LIGHT_FIELDS)) {
    const changed = TERMS.filter((term) =>
      lights.some((light, i) => {
        const other = { ...light, [key]: lights.at(i - 1)![key as keyof LightValues] };
        return numberOf(light, term) !== numberOf(other, term);
      }),
    );
    const selected = shading === 'none' ? [] : TERMS;
    expect(changed, key).toEqual(typeof shading === 'object' ? shading.terms : selected);
  }
});
