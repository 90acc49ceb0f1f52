// Does the tutor say what is wrong with an answer, and only what is true?

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type Equation, equationsOf, judge } from '../../../src/extras/overlay/probe/equations.js';
import { TERMS } from '../../../src/phong/light/light-state.js';
import { latexOf } from '../../../src/extras/overlay/probe/tutor.js';
import type { LightValues, Surface } from '../../../src/phong/reference/index.js';
import { repeats } from '../../support/repeats.js';
import { light } from '../../unit/arbitraries.js';
import { explained } from '../../unit/explained.js';

interface Given {
  readonly lights: readonly Partial<LightValues>[];
  readonly surface?: Partial<Surface>;
  readonly linear?: boolean;
  readonly halfway?: boolean;
}

/** The equations at the origin of a floor. */
function asked({ lights, surface, linear = false, halfway = false }: Given): Equation[] {
  const reflection = halfway ? 'blinn-phong' : 'phong';
  const fragment = explained({
    lights,
    surface: { kd: grey(200), ks: grey(100), ...surface },
    eye: [0, 3, 4],
    linear,
    reflection,
  });
  const values = lights.map((one) => light(one));
  return equationsOf(fragment, { lights: values, linear, halfway, terms: TERMS }, null);
}

const grey = (x: number): [number, number, number] => [x, x, x];
const of = (equations: readonly Equation[], term: string): Equation =>
  equations.find((equation) => equation.term === term)!;

/** 60 degrees from the normal, 2 away: att = 1 / (1 + 0.25 · 4) = 0.5. */
const LAMP = {
  position: [Math.sqrt(3), 1, 0, 1],
  ambient: grey(51),
  diffuse: grey(204),
  specular: grey(255),
  attenuation: [1, 0, 0.25],
} as const satisfies Partial<LightValues>;

it('has the numbers of the point, a line per channel only where they differ, and min where the sum is clamped', () => {
  const diffuse = of(asked({ lights: [LAMP] }), 'diffuse');
  expect(diffuse.symbols).toBe('Kd · Id · att · max(N · L, 0)');
  expect(`${diffuse.numbers} = ${diffuse.result}`).toBe('0.78 · 0.80 · 0.50 · 0.50 = 0.16');
  expect(diffuse.channel).toBeNull();
  expect(diffuse.facts).toBe('N ∠L 60.0°, d = 2, att = 1 / (1 + 0.25 d²)');
  const colored = asked({ lights: [{ ...LAMP, diffuse: [255, 0, 0] }] });
  const channels = colored.filter(({ term }) => term === 'diffuse').map(({ channel }) => channel);
  expect(channels).toEqual(['red', 'green', 'blue']);
  const behind = of(asked({ lights: [{ ...LAMP, position: [0, -1, 1, 0] }] }), 'diffuse');
  expect(`${behind.numbers} = ${behind.result}`).toMatch(/max\(−0\.71, 0\) = 0$/);
  expect(latexOf('Kd · max(N · L, 0)^32 = 0,35')).toBe(
    'K_d \\cdot \\max(N \\cdot L, 0)^{32} = 0{,}35',
  );
  const bright = of(asked({ lights: [{ ...LAMP, ambient: grey(255) }] }), 'sum');
  expect(`${bright.numbers} = ${bright.result}`).toMatch(/^min\(.*, 1\) = 1$/);
});

describe('a usual mistake', () => {
  const cone = { axis: [-Math.sqrt(3), -3, 0], aperture: 40, cutoff: 2 } as const;
  const spot = { ...LAMP, ...cone, attenuation: [1, 0, 0] } as const;
  it.each([
    ['diffuse', LAMP, 0.314, 'left-out', 'without att'],
    ['diffuse', LAMP, 18.82, 'angle', 'the angle is 60.0°'],
    ['diffuse', LAMP, -0.299, 'radians', '60.0 radians'],
    ['diffuse', LAMP, 0.2717, 'sine', 'sin in place of cos'],
    ['diffuse', LAMP, 40, 'scale', 'not 255'],
    ['diffuse', LAMP, 15.69, 'scale', 'not 100'],
    ['diffuse', { ...LAMP, position: [0, -1, 1, 0] }, -0.4437, 'unclamped', 'max(…, 0)'],
    ['ambient', LAMP, 0.1, 'attenuation', 'ambient term'],
    ['diffuse', spot, 0, 'aperture', 'from the axis to the edge'],
    ['diffuse', { ...spot, aperture: 20 }, 0.2733, 'cone', 'outside the cone'],
    ['sum', { ...LAMP, ambient: grey(255), diffuse: grey(255) }, 1.196, 'unclamped', 'min(…, 1)'],
  ] as const)('in the %s term is named (%#)', (term, light, typed, mistake, words) => {
    const verdict = judge(String(typed), of(asked({ lights: [light] }), term), null);
    expect(verdict.correct).toBe(false);
    expect(verdict.text).toContain(words);
    expect(verdict.mistake).toBe(mistake);
  });

  it('in the highlight is named: the other lobe, no exponent, the exponent as a factor, a light behind', () => {
    const highlight = {
      lights: [{ ...LAMP, position: [0, 1, -1, 0] as const }],
      surface: { ks: grey(255) },
    };
    const [phong, blinn] = [false, true].map((halfway) =>
      of(asked({ ...highlight, halfway }), 'specular'),
    );
    expect(judge(blinn!.value.toFixed(4), phong!, null).text).toContain('N · H in place of R · V');
    expect(judge(phong!.value.toFixed(4), blinn!, null).text).toContain('R · V in place of N · H');
    const cosine = phong!.value ** (1 / 8);
    expect(judge(cosine.toFixed(4), phong!, null).mistake).toBe('exponent');
    expect(judge((8 * cosine).toFixed(3), phong!, null).mistake).toBe('times-exponent');
  });
});

it('takes commas, percent and the minus of the page, and asks for a number or for more digits', () => {
  const diffuse = of(asked({ lights: [LAMP] }), 'diffuse');
  for (const typed of ['0.157', '0,157', ' .1569 ', '15.7 %', '0.16']) {
    expect(judge(typed, diffuse, null).correct, typed).toBe(true);
  }
  for (const typed of ['', 'abc', '1.2.3', '0x1', '1e999', 'Infinity']) {
    expect(judge(typed, diffuse, null), typed).toMatchObject({
      value: null,
      correct: false,
      mistake: null,
    });
  }
  expect(judge('0.2', diffuse, null).mistake).toBe('digits');
  expect(judge('0', diffuse, null).text).toBe('Not yet: too small by 0.16.');
  expect(judge('0.45', diffuse, null)).toMatchObject({
    mistake: null,
    text: 'Not yet: too large by 0.29.',
  });
});

const unit = fc.integer({ min: 1, max: 255 });
const coordinate = fc.double({ min: -3, max: 3, noNaN: true });
const LIGHT = fc.record({
  position: fc.tuple(coordinate, coordinate, coordinate, fc.constantFrom(0, 1)),
  ambient: fc.tuple(unit, unit, unit),
  diffuse: fc.tuple(unit, unit, unit),
  specular: fc.tuple(unit, unit, unit),
  axis: fc.tuple(coordinate, coordinate, coordinate),
  aperture: fc.constantFrom(180, 20, 60),
  cutoff: fc.constantFrom(0, 2, 8),
  attenuation: fc.constantFrom([1, 0, 0] as const, [1, 0.2, 0.5] as const),
});
const GIVEN: fc.Arbitrary<Given> = fc.record({
  lights: fc.array(LIGHT, { minLength: 1, maxLength: 3 }),
  surface: fc.record({
    shininess: fc.constantFrom(0, 1, 8, 32.5),
    emissive: fc.constantFrom(grey(0), grey(0.1)),
  }),
  linear: fc.boolean(),
  halfway: fc.boolean(),
});

it('calls every right answer right, and each wrong value a mistake that its text can claim (seed 39)', () => {
  fc.assert(
    fc.property(GIVEN, fc.integer({ min: 4, max: 9 }), (given, digits) => {
      for (const equation of asked(given)) {
        if (equation.value >= 0.01 || equation.value <= 0) {
          const right = judge(equation.value.toFixed(digits), equation, null);
          expect(right).toMatchObject({ correct: true, mistake: null });
        }
        for (const { value, text } of equation.wrongs) {
          if (!Number.isFinite(value) || Math.abs(value) > 1e6 || Math.abs(value) < 0.02) continue;
          const verdict = judge(value.toFixed(7), equation, null);
          if (verdict.correct) {
            expect(Math.abs(value - equation.value)).toBeLessThan(0.0021 * equation.value + 1e-6);
            continue;
          }
          expect(verdict.mistake).not.toBeNull();
          // Of more than two mistakes that give this number the likelier ones are named.
          const near = equation.wrongs.filter(
            (each) => Math.abs(each.value - value) <= 0.002 * Math.abs(each.value) + 1e-6,
          );
          if (new Set(near.map((each) => each.text)).size <= 2) {
            expect(verdict.text).toContain(text);
          }
        }
      }
    }),
    { seed: 39, numRuns: repeats(1600) },
  );
});
