// Which code a program holds: nothing that was not declared, and few programs however much changes.

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { gatherFacts, type LightFacts, noFacts } from '../../src/light/light-features.js';
import {
  ANTIALIASES,
  REFLECTIONS,
  SHADINGS,
  TERMS,
  type Variant,
  variantDefines,
} from '../../src/material/program/variant.js';
import { anyLight, light } from './arbitraries.js';

const plain: Variant = {
  shading: 'phong',
  reflection: 'phong',
  terms: TERMS,
  antialias: 'edges',
  linear: false,
  map: false,
  vertexColors: false,
  alphaMode: 'opaque',
};

const allFacts = Object.fromEntries(
  Object.keys(noFacts()).map((fact) => [fact, true]),
) as unknown as LightFacts;

const names = (variant: Partial<Variant>, facts: LightFacts = noFacts()): string[] =>
  Object.keys(variantDefines({ ...plain, ...variant }, facts)).sort();

const anyVariant: fc.Arbitrary<Variant> = fc.record({
  shading: fc.constantFrom(...SHADINGS),
  reflection: fc.constantFrom(...REFLECTIONS),
  terms: fc.subarray([...TERMS]),
  antialias: fc.constantFrom(...ANTIALIASES),
  linear: fc.boolean(),
  map: fc.boolean(),
  vertexColors: fc.boolean(),
  alphaMode: fc.constantFrom('opaque', 'mask', 'blend'),
});

describe("a program's code", () => {
  it('is nothing but where lights are read from, for a plain surface without lights', () => {
    expect(variantDefines(plain, noFacts())).toStrictEqual({ LIGHT_STORAGE: 'STORAGE_TEXTURE' });
  });

  it.each<[Partial<Variant>, string[]]>([
    [{ shading: 'gouraud' }, ['SHADING_GOURAUD']],
    [{ shading: 'flat' }, []],
    [{ reflection: 'blinn-phong' }, ['REFLECTION_BLINN_PHONG']],
    [{ linear: true }, ['IS_LINEAR']],
    [{ map: true }, ['HAS_MAP']],
    [{ vertexColors: true }, ['HAS_VERTEX_COLOR']],
    [{ alphaMode: 'mask' }, ['HAS_ALPHA_MASK']],
    [{ alphaMode: 'blend' }, ['IS_BLENDED']],
  ])('of a surface with %j has %j', (variant, defines) => {
    expect(names(variant)).toStrictEqual([...defines, 'LIGHT_STORAGE'].sort());
  });

  it.each([
    ['ambient', 'HAS_AMBIENT'],
    ['diffuse', 'HAS_DIFFUSE'],
    ['specular', 'HAS_SPECULAR'],
    ['directional', 'HAS_DIRECTIONAL'],
    ['point', 'HAS_POINT'],
    ['spot', 'HAS_SPOT'],
    ['attenuation', 'HAS_ATTENUATION'],
    ['cone', 'HAS_CONE'],
    ['decay', 'HAS_DECAY'],
  ] as const)('for %s light is there once a light has declared it: %s', (fact, define) => {
    expect(names({}, { ...noFacts(), [fact]: true })).toStrictEqual([define, 'LIGHT_STORAGE'].sort());
    expect(names({}, { ...allFacts, [fact]: false })).not.toContain(define);
  });

  it('filters highlights where there is specular light to filter, at fragments alone', () => {
    const filter = (variant: Partial<Variant>, facts = allFacts): boolean =>
      names({ antialias: 'highlights', ...variant }, facts).includes('FILTER_HIGHLIGHTS');
    expect(filter({})).toBe(true);
    expect(filter({ shading: 'flat', reflection: 'blinn-phong' })).toBe(true);
    expect(filter({ antialias: 'edges' })).toBe(false);
    expect(filter({ shading: 'gouraud' })).toBe(false);
    expect(filter({ terms: ['ambient', 'diffuse'] })).toBe(false);
    expect(filter({}, { ...allFacts, specular: false })).toBe(false);
  });

  it('leaves out the terms that have never been needed', () => {
    const terms = (variant: Partial<Variant>): string[] =>
      names(variant, allFacts).filter((name) => /AMBIENT|DIFFUSE|SPECULAR/.test(name));
    expect(terms({ terms: ['diffuse'] })).toStrictEqual(['HAS_DIFFUSE']);
    expect(terms({ terms: ['ambient', 'diffuse'] })).toStrictEqual(['HAS_AMBIENT', 'HAS_DIFFUSE']);
    expect(terms({ terms: [] })).toStrictEqual([]);
  });

  it('has a light fact only where that fact was declared', () => {
    fc.assert(
      fc.property(anyVariant, fc.array(anyLight, { maxLength: 4 }), (variant, lights) => {
        const facts = noFacts();
        for (const values of lights) gatherFacts(values, facts);
        const defines = variantDefines(variant, facts);
        for (const [fact, known] of Object.entries(facts)) {
          if (!known) expect(defines).not.toHaveProperty(`HAS_${fact.toUpperCase()}`);
        }
      }),
    );
  });

  it('only grows while lights come and go', () => {
    fc.assert(
      fc.property(anyVariant, fc.array(anyLight, { maxLength: 8 }), (variant, lights) => {
        const facts = noFacts();
        let before = Object.keys(variantDefines(variant, facts));
        for (const values of lights) {
          gatherFacts(values, facts);
          const now = Object.keys(variantDefines(variant, facts));
          expect(now).toStrictEqual(expect.arrayContaining(before));
          before = now;
        }
      }),
    );
  });
});

describe('the number of programs', () => {
  const programs = (states: readonly (readonly [Variant, LightFacts])[]): number =>
    new Set(states.map(([variant, facts]) => JSON.stringify(variantDefines(variant, facts)))).size;

  it('is one for any number of lights of kinds already declared', () => {
    const facts = noFacts();
    const states = Array.from({ length: 300 }, (_, i) => {
      gatherFacts(light({ position: [i, 0, 0, 1], diffuse: [i, 1, 1] }), facts);
      return [plain, { ...facts }] as const;
    });
    expect(programs(states)).toBe(1);
  });

  it('grows by one at most for the first light of each kind', () => {
    const facts = noFacts();
    const states = [
      light(),
      light({ position: [0, 1, 0, 1] }),
      light({ position: [0, 1, 0, 1], aperture: 20 }),
      light({ aperture: 20 }),
      light({ position: [0, 1, 0, 1], aperture: 50, cutoff: 3 }),
    ].map((values) => {
      gatherFacts(values, facts);
      return [plain, { ...facts }] as const;
    });
    expect(programs(states)).toBe(4); // a cone about a directional light needs none: it is the same everywhere
  });

  it('is the same for flat and phong, and for the order of terms', () => {
    expect(variantDefines({ ...plain, shading: 'flat' }, allFacts)).toStrictEqual(
      variantDefines(plain, allFacts),
    );
    expect(variantDefines({ ...plain, terms: ['specular', 'ambient', 'diffuse'] }, allFacts)).toStrictEqual(
      variantDefines(plain, allFacts),
    );
  });

  it('stays the same for equal states, in the same order of defines', () => {
    fc.assert(
      fc.property(anyVariant, (variant) => {
        const once = Object.entries(variantDefines(variant, allFacts));
        expect(Object.entries(variantDefines({ ...variant }, { ...allFacts }))).toStrictEqual(once);
      }),
    );
  });
});
