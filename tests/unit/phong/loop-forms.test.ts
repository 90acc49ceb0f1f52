// Does the stress run measure every program that is shipped? A new form, condition or feature fails
// here until a stress case has it. Do the published tables match the results of every category and
// stack, and does the contract hold there?
import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { LIGHT_FEATURES } from '../../../src/phong/light/light-layout.js';
import { LIGHT_FIELDS } from '../../../src/phong/light/light-state.js';
import { FORMS } from '../../../src/phong/material/program/special-variant.js';
import { LIGHT_LOOP_GLSL } from '../../../src/phong/material/program/source.js';
import { freshProgramsFor, programsFor } from '../../glsl/loop-forms.js';
import { LOOP_MARK, markOf } from '../../glsl/loop-mark.js';
import { WORST_DRIVERS } from '../../glsl/worst-driver.js';
import { pack } from '../../stress/case.js';
import { CATEGORIES } from '../../stress/categories.js';
import { BRANCHES, CONE_EDGE, EXACT } from '../../stress/contract.js';
import { Random } from '../../stress/random.js';
import { formNames, readmeText, readStacks, reportText } from '../../stress/report.mjs';

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

/**
 * Of every category but those with very many lights, which are lights of others: enough that each
 * shows every kind of light and exponent that it has.
 */
const cases = CATEGORIES.filter(({ lights = 1 }) => lights <= 8).flatMap(({ make, variants }) =>
  variants.flatMap((variant) => {
    const random = new Random(1);
    return Array.from({ length: 60 }, () => ({ stress: make(random, variant), variant }));
  }),
);
/** The names of all programs that a stress run measures. */
const names = [
  ...new Set(
    cases.flatMap(({ stress, variant }) =>
      [...programsFor(stress, variant)].map(({ name }) => name),
    ),
  ),
];
const BOTH = new Set([true, false]);

const text = (path: string) => readFileSync(new URL(`../../../${path}`, import.meta.url), 'utf8');
const stacks = readStacks();

describe('the stress run', () => {
  it('draws the general program and every specialised form', () => {
    expect(new Set(names.map((name) => name.split(' ')[0]))).toEqual(
      new Set(['general', ...FORMS]),
    );
  });

  it('draws with and without each condition that changes what a program computes', () => {
    const lines = LIGHT_LOOP_GLSL.match(/^#(if|elif).*$/gm) ?? [];
    const conditions = new Set(lines.flatMap((line) => line.match(/\b[A-Z][A-Z_]+\b/g) ?? []));
    for (const condition of conditions) {
      // HAS_… leaves code out: the numbers of what is left stay.
      if (condition in ELSEWHERE || /^(HAS|STORAGE|FEATURE)_/.test(condition)) continue;
      expect(new Set(names.map((name) => name.split(' ').includes(condition))), condition).toEqual(
        BOTH,
      );
    }
    const general = names.filter((name) => name.startsWith('general'));
    expect(
      new Set(general.map((name) => name.includes('without'))),
      'code for steep spots',
    ).toEqual(BOTH);
  });

  it('has lights with and without each feature', () => {
    const {
      powerShift,
      directional: _directional,
      point: _point,
      spot: _spot,
      ...bits
    } = LIGHT_FEATURES;
    const masks = cases.flatMap(({ stress, variant }) => {
      const { features, sent } = pack(stress, variant);
      return [...features.subarray(0, sent)];
    });
    for (const [name, bit] of Object.entries(bits)) {
      expect(new Set(masks.map((mask) => (mask & bit) !== 0)), name).toEqual(BOTH);
    }
    expect(new Set(masks.map((mask) => mask >> powerShift > 0))).toEqual(BOTH);
  });

  it('has lights that differ in each value that shading takes', () => {
    const lights = cases.flatMap(({ stress }) => stress.lights);
    for (const [key, { shading }] of Object.entries(LIGHT_FIELDS)) {
      const values = new Set(lights.map((light) => String(light[key as keyof typeof light])));
      if (typeof shading === 'object') {
        expect(values.size, key).toBeGreaterThan(1);
      }
    }
  });

  it('takes the programs that the shipped code makes for a case', () => {
    for (const { stress, variant } of cases) {
      const texts = [programsFor(stress, variant), freshProgramsFor(stress, variant)].map(
        (programs) =>
          Array.from(programs, ({ name, defines }) => `${name}: ${defines.join(', ')}`).join('\n'),
      );
      expect(texts[0]).toBe(texts[1]);
    }
  });

  it('was made in every category and every form of program on one stack at least', () => {
    const whole = stacks.filter(
      (stack) =>
        Object.values(stack.drivers).every(
          ({ measured }) => measured.length === CATEGORIES.length,
        ) && names.every((name) => formNames([stack]).includes(name)),
    );
    expect(whole).not.toEqual([]);
  });
});

describe('the published contract', () => {
  it('agrees with the results, in the report and in the README', () => {
    expect(text('tests/stress/REPORT.md')).toBe(reportText(stacks, LOOP_MARK));
    expect(text('README.md')).toContain(readmeText(stacks));
  });

  it('marks the measured loop by its code, whatever its comments and line breaks', () => {
    expect(markOf('a * b; // twice\n/* c */ d')).toBe(markOf('a * b;\n\n  d'));
    expect(markOf('a * b;')).not.toBe(markOf('a + b;'));
  });

  it('says where an earlier loop was measured, and where a category was not', () => {
    const first = stacks[0]!;
    const { title, bound } = CATEGORIES[0]!;
    const { shipped, ...worst } = first.drivers;
    const drivers = { ...worst, shipped: { ...shipped!, measured: shipped!.measured.slice(1) } };
    const both = [
      { ...first, loop: '', drivers },
      { ...first, loop: LOOP_MARK },
    ];
    const report = reportText(both, LOOP_MARK);
    for (const part of [
      '| as shipped |',
      '| an earlier one |',
      `| ${title} | ${bound} | not measured here |`,
    ]) {
      expect(report).toContain(part);
    }
  });

  it('was measured in software and on a GPU, on at least four stacks', () => {
    expect(stacks.length).toBeGreaterThanOrEqual(4);
    expect(stacks.map(({ renderer }) => renderer).join()).toMatch(
      /SwiftShader.*NVIDIA|NVIDIA.*SwiftShader/,
    );
  });

  describe.each(stacks)('on $name', ({ contract, drivers }) => {
    it('was measured with today’s bounds and exclusions or tighter ones, in categories that are still there', () => {
      const measured = drivers['shipped']!.measured.map(({ id, bound }) => ({ id, bound }));
      const ids = measured.map(({ id }) => id);
      const today = CATEGORIES.filter(({ id }) => ids.includes(id));
      expect(ids).toEqual(today.map(({ id }) => id));
      measured.forEach(({ id, bound }, i) =>
        expect(bound, id).toBeLessThanOrEqual(today[i]!.bound),
      );
      expect([contract.edge, contract.exact.share]).toEqual([CONE_EDGE, EXACT.share]);
      // What left out less, and held, holds.
      for (const key of Object.keys(BRANCHES) as (keyof typeof BRANCHES)[]) {
        expect(contract.branches[key], key).toBeLessThanOrEqual(BRANCHES[key]);
      }
    });

    it('holds, on its own driver and on the worst lawful ones', () => {
      expect(Object.keys(drivers).sort()).toEqual(['shipped', ...WORST_DRIVERS].sort());
      for (const { broken } of Object.values(drivers)) {
        expect(broken).toEqual([]);
      }
    });
  });
});
