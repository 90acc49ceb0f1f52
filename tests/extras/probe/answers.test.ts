// Do the digits of a line give its result, and does a question say only what is true?

import fc from 'fast-check';
import { expect, it } from 'vitest';
import { equationsOf, givenOf } from '../../../src/extras/probe/equations.js';
import { judge, questionOf, typedNumber } from '../../../src/extras/probe/answers.js';
import { isLeftOut } from '../../../src/phong/mistakes/slips.js';
import { TERMS } from '../../../src/phong/light/light-state.js';
import { cosDegrees } from '../../../src/phong/math/angle.js';
import { srgbEncode } from '../../../src/phong/math/color.js';
import type { LightValues, Surface } from '../../../src/phong/reference/index.js';
import { repeats } from '../../support/repeats.js';
import { light, worldLight } from '../../unit/arbitraries.js';
import { explained } from '../../unit/explained.js';

interface Given {
  readonly lights: readonly Partial<LightValues>[];
  readonly surface?: Partial<Surface>;
  readonly linear?: boolean;
  readonly halfway?: boolean;
}

/** The equations at the origin of a floor. */
function asked({ lights, surface, linear = false, halfway = false }: Given) {
  const reflection = halfway ? 'blinn-phong' : 'phong';
  const fragment = explained({
    lights,
    surface: { kd: grey(200), ks: grey(100), ...surface },
    eye: [0, 3, 4],
    linear,
    reflection,
  });
  const values = lights.map((one) => light(one));
  const texts = { decay: 'Abfall' };
  return equationsOf(fragment, { lights: values, linear, halfway, terms: TERMS }, texts);
}

const grey = (x: number): [number, number, number] => [x, x, x];

const GIVEN: fc.Arbitrary<Given> = fc.record({
  lights: fc.array(worldLight, { minLength: 1, maxLength: 3 }),
  surface: fc.record({
    shininess: fc.constantFrom(0, 1, 8, 32.5),
    emissive: fc.constantFrom(grey(0), grey(0.1)),
  }),
  linear: fc.boolean(),
  halfway: fc.boolean(),
});

/** A line's numbers as a reader computes them, in one channel. */
function computed(text: string, channel: number) {
  const js = text
    .replace(/−/g, '-')
    .replace(
      /\(([-\d.e+]+) ([-\d.e+]+) ([-\d.e+]+)\)/g,
      (_, ...xs: string[]) => `(${xs[channel]!})`,
    )
    .replace(/·/g, '*')
    .replace(/\^/g, '**');
  return Function('max', 'min', 'sRGB', `return ${js}`)(Math.max, Math.min, srgbEncode) as number;
}

it('has digits that give the digits of the result, or says ≈ (seed 53)', () => {
  let [exact, near] = [0, 0];
  fc.assert(
    fc.property(GIVEN, (given) => {
      for (const { numbers, sign, result } of asked(given)) {
        if (sign === '≈') {
          near += 1;
          continue;
        }
        exact += 1;
        for (const channel of [0, 1, 2]) {
          const shown = result.replace(/[()]/g, '').split(' ');
          const digits = shown.map((x) => x.split('.')[1]?.length ?? 0);
          const unit = 10 ** -Math.max(...digits);
          const right = Number(shown[channel] ?? shown[0]);
          const most = Math.max(...digits) === 0 ? 0.005 : 0.5 * unit;
          const value = computed(numbers, channel);
          expect(Math.abs(value - right), `${numbers} = ${result}`).toBeLessThanOrEqual(
            most + 1e-9,
          );
        }
      }
    }),
    { seed: 53, numRuns: repeats(2400) },
  );
  expect(near / (exact + near)).toBeLessThan(0.1);
});

/** With three digits too, though the right number may round to others. */
const spellings = (x: number) => [
  x.toFixed(9),
  x.toPrecision(3),
  x.toPrecision(3).replace('.', ','),
  `${(100 * x).toPrecision(4)} %`,
  `${Math.round(1e10 * x)}/${1e10}`,
  x.toExponential(3),
];

it('can be answered from what it shows, and takes that answer (seed 54)', () => {
  fc.assert(
    fc.property(GIVEN, fc.nat(2), (given, channel) => {
      for (const equation of asked(given)) {
        if (equation.term === 'sum') continue;
        const { values, facts } = givenOf(equation, channel);
        const answer = values.reduce((all, x) => all * x, 1);
        const question = questionOf(equation, channel);
        if (answer > 0 && answer < 1e-6) continue;
        for (const typed of answer === 0 ? ['0'] : spellings(answer)) {
          expect(judge(typed, question, null).correct, `${typed} of ${facts}`).toBe(true);
        }
      }
    }),
    { seed: 54, numRuns: repeats(2400) },
  );
});

/** What the formula in a fact's words gives. */
function saidBy(words: string) {
  const [, formula = '1'] = /(?:att|decay) = (.*)$/.exec(words) ?? [];
  const js = formula
    .replace(/(\d)\u00a0d/g, '$1*d')
    .replace('d²', 'd**2')
    .replace(/cos ([\d.]+)°/, (_, degrees: string) => String(cosDegrees(Number(degrees))));
  const d = Number(/^d = ([\d.]+)/.exec(words)?.[1]);
  return Function('max', 'd', `return ${js.replace('^', '**')}`)(Math.max, d) as number;
}

it('says in words the formula that gives a factor, whatever the values of a light (seed 57)', () => {
  fc.assert(
    fc.property(worldLight, (one) => {
      for (const { factors, at } of asked({ lights: [one] }).slice(0, -1)) {
        for (const { symbol, value, fact } of factors) {
          if (!['att', 'decay'].includes(symbol) || !at!.share.insideCone) continue;
          expect(saidBy(fact!.text(9)), fact!.text(9)).toBeCloseTo(value[0], 6);
        }
      }
    }),
    { seed: 57, numRuns: repeats(2400) },
  );
});

it('names the mistake that was made, or none, in over 200 answers, by one digit only if exact (seed 56)', () => {
  let [answers, named] = [0, 0];
  fc.assert(
    fc.property(GIVEN, fc.nat(2), (given, channel) => {
      for (const equation of asked(given)) {
        if (equation.term === 'sum') continue;
        const question = questionOf(equation, channel);
        for (const { mistake, value, text } of question.wrongs) {
          expect(text).not.toContain('Abfall'); // the formula has the symbol
          const verdict = judge(value.toFixed(4), question, null);
          // That can be told from 0 and from the right one.
          const { expected } = question;
          if (Math.abs(value) > 0.02 && Math.abs(value - expected) > 0.02 * Math.abs(value)) {
            answers += 1;
            named += Number(verdict.mistake === mistake);
          }
          const isSame =
            verdict.correct || [mistake, 'digits', 'above-full', null].includes(verdict.mistake);
          expect(isSame || isLeftOut(verdict.mistake!), `${verdict.text} for ${text}`).toBe(true);
          const typed = value.toPrecision(1);
          const told = judge(typed, question, null);
          const isExact = question.wrongs.some(
            (wrong) => wrong.text === told.text && Math.abs(wrong.value - Number(typed)) < 0.001,
          );
          expect(
            isExact || told.correct || ['digits', 'above-full', null].includes(told.mistake),
            `${typed} for ${expected}: ${told.text}`,
          ).toBe(true);
        }
      }
    }),
    { seed: 56, numRuns: repeats(800) },
  );
  expect(answers).toBeGreaterThan(200);
  expect(named / answers).toBeGreaterThan(0.6);
});

it('explains no 0, rounds nothing to 1, and takes digits of any script, commas, percent, fractions and powers', () => {
  const lamp = { position: [0, 1, -1, 0], ambient: grey(51), diffuse: grey(204) } as const;
  for (const equation of asked({ lights: [lamp] }).slice(0, -1)) {
    const verdict = judge('0', questionOf(equation, 0), null);
    expect(verdict.correct || ['digits', null].includes(verdict.mistake)).toBe(true);
  }
  for (const typed of [
    '0.75',
    '%75',
    '= ٪ ۷۵',
    '3/4',
    '۰٫۷۵',
    '০.৭৫',
    '０．７５',
    '¾',
    '7.5e-1',
    '7,5 · 10⁻¹',
    '= 75×10^-2',
    '~ 75 x 10^-2',
    '≈ +۰/۷۵',
    '٠،٧٥',
    '0.75.',
  ]) {
    expect(typedNumber(typed)?.value, typed).toBeCloseTo(0.75, 12);
  }
  expect(['1/0', '1½', '3²', '0.5 * 100'].map(typedNumber)).toEqual([null, null, null, null]);
  const [, diffuse] = asked({ lights: [{ ...lamp, diffuse: grey(255) }] });
  expect(judge('1', questionOf(diffuse!, 0), null).mistake).toBeNull();
});
