// Does the stress run measure every program that is shipped? A new form, condition or feature fails here until a stress
// case has it.
import { describe, expect, it } from 'vitest';
import { LIGHT_FEATURES } from '../../src/light/light-layout.js';
import { LIGHT_FIELDS } from '../../src/light/light-state.js';
import { FORMS } from '../../src/material/program/variant.js';
import { LIGHT_LOOP_GLSL } from '../../src/material/program/source.js';
import { forSomeCases, formsOfAll, masksOfAll } from '../glsl/loop-coverage.js';
import { freshProgramsFor, programsFor } from '../glsl/loop-forms.js';

/** Conditions of the loop's text that no stress program has to differ in, and why. */
const ELSEWHERE: Readonly<Record<string, string>> = {
  LIGHT_STORAGE: 'every storage is read back whole by a check of its own',
  DECLARED_FEATURES: 'a mask of features',
  LIGHT_STATEMENTS: 'what a form is',
  DIRECTIONAL_FEATURES: 'what a form is',
  POINT_FEATURES: 'what a form is',
  SPOT_FEATURES: 'what a form is',
  REFLECTION_BLINN_PHONG: 'categories name their reflections',
};

describe('the stress run', () => {
  const names = [...formsOfAll()];

  it('draws the general program and every specialised form', () => {
    expect(new Set(names.map((name) => name.split(' ')[0]))).toEqual(new Set(['general', ...FORMS]));
  });

  it('draws with and without each condition that changes what a program computes', () => {
    const lines = LIGHT_LOOP_GLSL.match(/^#(if|elif).*$/gm) ?? [];
    const conditions = new Set(lines.flatMap((line) => line.match(/\b[A-Z][A-Z_]+\b/g) ?? []));
    for (const condition of conditions) {
      // HAS_… leaves code out: the numbers of what is left stay.
      if (condition in ELSEWHERE || /^(HAS|STORAGE|FEATURE)_/.test(condition)) continue;
      const has = names.map((name) => name.split(' ').includes(condition));
      expect(new Set(has), condition).toEqual(new Set([true, false]));
    }
  });

  it('has general programs with and without code for steep spots', () => {
    const general = names.filter((name) => name.startsWith('general'));
    expect(new Set(general.map((name) => name.includes('without')))).toEqual(new Set([true, false]));
  });

  it('has lights with and without each feature', () => {
    const { powerShift, directional: _directional, point: _point, spot: _spot, ...bits } = LIGHT_FEATURES;
    const masks = [...masksOfAll()];
    for (const [name, bit] of Object.entries(bits))
      expect(new Set(masks.map((mask) => (mask & bit) !== 0)), name).toEqual(new Set([true, false]));
    expect(new Set(masks.map((mask) => mask >> powerShift > 0))).toEqual(new Set([true, false]));
  });

  it('has lights that differ in each value that shading takes', () => {
    const seen = new Map<string, Set<string>>();
    forSomeCases(({ lights }) => {
      for (const light of lights)
        for (const [key, value] of Object.entries(light))
          seen.set(key, (seen.get(key) ?? new Set()).add(String(value)));
    });
    for (const [key, { shading }] of Object.entries(LIGHT_FIELDS))
      if (typeof shading === 'object') expect(seen.get(key)?.size, key).toBeGreaterThan(1);
  });

  it('takes the programs that the shipped code makes for a case', () => {
    forSomeCases((stress, variant) => {
      const texts = [programsFor(stress, variant), freshProgramsFor(stress, variant)].map((programs) =>
        Array.from(programs, ({ name, defines }) => `${name}: ${defines.join(', ')}`).join('\n'),
      );
      expect(texts[0]).toBe(texts[1]);
    });
  });
});
