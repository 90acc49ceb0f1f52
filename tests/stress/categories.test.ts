// Are the adversarial cases valid: within the attributes' domains, the same for the same seed, and
// float32 for the shader?
import { serialize } from 'node:v8';
import { describe, expect, it } from 'vitest';
import { SURFACE_FIELDS } from '../../src/phong/material/material-values.js';
import { LIGHT_FIELDS } from '../../src/phong/light/light-state.js';
import { CATEGORIES } from './categories.js';
import type { StressCase, Variant } from './case.js';
import { branch, coneMargin, CONE_EDGE } from './contract.js';
import { reference } from './case.js';
import { Random } from './random.js';

const SEED = 11;

function cases(
  make: (random: Random, variant: Variant) => StressCase,
  variant: Variant,
  count: number,
) {
  const random = new Random(SEED);
  return Array.from({ length: count }, () => make(random, variant));
}

describe('the adversarial categories', () => {
  it('have distinct names', () => {
    expect(new Set(CATEGORIES.map(({ id }) => id)).size).toBe(CATEGORIES.length);
    expect(new Set(CATEGORIES.map(({ title }) => title)).size).toBe(CATEGORIES.length);
  });

  describe.each(CATEGORIES)('$title', ({ make, variants, lights = 1 }) => {
    const count = lights > 64 ? 2 : 50;

    it('hold only values within the attributes’ domains', () => {
      // Fields throw at values outside of their domains. One expectation for each value took most
      // of the time.
      for (const { lights: declared, surface } of cases(make, variants[0]!, count)) {
        for (const light of declared) {
          for (const [key, field] of Object.entries(LIGHT_FIELDS)) {
            field.check(light[key as keyof typeof light]);
          }
        }
        for (const [key, field] of Object.entries(SURFACE_FIELDS)) {
          field.check(surface[key as keyof typeof surface]);
        }
      }
    });

    it('give the shader and the reference the same float32 values', () => {
      for (const { p, eye, normal, normalMatrix = [], origin } of cases(
        make,
        variants[0]!,
        count,
      )) {
        const given = [...p, ...eye, ...normal, ...normalMatrix];
        expect(given.filter((x) => Math.fround(x) !== x)).toEqual([]);
        const rounded = p.filter((x, i) => origin[i]! + x - origin[i]! !== x);
        expect(rounded, 'world positions that are not exact').toEqual([]);
      }
    });

    it('are reproducible by their seed', () => {
      const [first, second] = [0, 1].map(() => cases(make, variants[0]!, 3));
      // Bytes, in which -0 and NaN count too, are quicker than a walk through thousands of lights.
      expect(serialize(first).equals(serialize(second))).toBe(true);
    });
  });

  it('lie on both sides of cones’ edges, down to the contract’s limit', () => {
    const { make, variants } = CATEGORIES.find(({ id }) => id === 'cone-edge')!;
    const margins = cases(make, variants[0]!, 2000)
      .map((stress) => ({ stress, shaded: reference(stress, variants[0]!) }))
      .filter(({ stress, shaded }) => branch(stress, shaded, variants[0]!) === null)
      .map(({ stress, shaded }) => coneMargin(stress.lights, shaded));
    for (const side of [-1, 1]) {
      const near = margins.map((margin) => margin * side).filter((margin) => margin > 0);
      expect(Math.min(...near)).toBeGreaterThanOrEqual(CONE_EDGE);
      expect(Math.min(...near)).toBeLessThan(2 * CONE_EDGE);
    }
  });
});
