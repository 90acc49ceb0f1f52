// Does the tutor say what is wrong with an answer, and only what is true?

import fc from 'fast-check';
import { Mesh } from 'three';
import { describe, expect, it } from 'vitest';
import type { FragmentExplanation, LightExplanation } from '../../src/element/explanation.js';
import type { PhongViewer } from '../../src/element/phong-viewer.js';
import { type Equation, equationsOf, judge } from '../../src/overlay/probe/equations.js';
import { latexOf } from '../../src/overlay/probe/notation.js';
import { coefficientsOf, LightState, shade, type Surface } from '../../src/reference/index.js';

const ALL = ['ambient', 'diffuse', 'specular'] as const;

interface Given {
  readonly lights: readonly Readonly<Record<string, unknown>>[];
  readonly surface?: Partial<Surface>;
  readonly eye?: readonly [number, number, number];
  readonly linear?: boolean;
  readonly halfway?: boolean;
}

/** The equations at the origin of a floor. */
function asked({ lights, surface, eye = [0, 3, 4], linear = false, halfway = false }: Given): Equation[] {
  const own: Surface = {
    ka: [255, 255, 255],
    kd: [200, 200, 200],
    ks: [100, 100, 100],
    shininess: 8,
    ...surface,
  };
  const values = lights.map((given) => {
    const light = new LightState();
    for (const [key, value] of Object.entries(given)) light.set(key as 'position', value as never);
    return light.values;
  });
  const reflection = halfway ? 'blinn-phong' : 'phong';
  const shaded = shade({ p: [0, 0, 0], normal: [0, 1, 0], eye }, own, values, { linear, reflection });
  const fragment: FragmentExplanation = {
    ...{ p: [0, 0, 0], mesh: {} as PhongViewer, object: new Mesh(), triangle: 0, opacity: 1 },
    ...{ baseColor: [1, 1, 1], metalness: 0, unlit: false, filtered: false, ...shaded },
    ...coefficientsOf(own, linear),
    shininess: own.shininess,
    emissive: own.emissive ?? [0, 0, 0],
    shares: shaded.shares.map(
      (share, i): LightExplanation | null => share && { ...share, light: null, name: `light ${i + 1}` },
    ),
  };
  return equationsOf(fragment, { lights: values, linear, halfway, terms: ALL }, null);
}

const grey = (x: number): [number, number, number] => [x, x, x];
const of = (equations: readonly Equation[], term: string): Equation =>
  equations.find((equation) => equation.term === term)!;

/** 60 degrees from the normal, 2 away: att = 1 / (1 + 0.25 · 4) = 0.5. */
const LAMP = {
  position: [Math.sqrt(3), 1, 0, 1],
  ...{ ambient: grey(51), diffuse: grey(204), specular: grey(255), attenuation: [1, 0, 0.25] },
};

describe('the equation', () => {
  it('has the numbers of the point, and one line per channel only where they differ', () => {
    const diffuse = of(asked({ lights: [LAMP] }), 'diffuse');
    expect(diffuse.symbols).toBe('Kd · Id · att · max(N · L, 0)');
    expect(`${diffuse.numbers} = ${diffuse.result}`).toBe('0.78 · 0.80 · 0.50 · 0.50 = 0.16');
    expect(diffuse.channel).toBeNull();
    const colored = asked({ lights: [{ ...LAMP, diffuse: [255, 0, 0] }] });
    expect(colored.filter(({ term }) => term === 'diffuse').map(({ channel }) => channel)).toEqual([
      'red',
      'green',
      'blue',
    ]);
    const behind = of(asked({ lights: [{ ...LAMP, position: [0, -1, 1, 0] }] }), 'diffuse');
    expect(`${behind.numbers} = ${behind.result}`).toMatch(/max\(−0\.71, 0\) = 0$/);
    expect(latexOf('Kd · max(N · L, 0)^32 = 0,35')).toBe('K_d \\cdot \\max(N \\cdot L, 0)^{32} = 0{,}35');
  });

  it('says min where the sum is clamped', () => {
    const bright = asked({ lights: [{ ...LAMP, ambient: grey(255) }] });
    expect(of(bright, 'sum').numbers).toMatch(/^min\(.*, 1\)$/);
    expect(of(bright, 'sum').result).toBe('1');
  });
});

describe('a usual mistake', () => {
  const spot = { ...LAMP, axis: [-Math.sqrt(3), -3, 0], aperture: 40, cutoff: 2, attenuation: [1, 0, 0] };
  it.each([
    ['diffuse', { lights: [LAMP] }, 0.314, 'left-out', 'without att'],
    ['diffuse', { lights: [LAMP] }, 18.82, 'angle', 'the angle is 60.0°'],
    ['diffuse', { lights: [LAMP] }, -0.299, 'radians', '60.0 radians'],
    ['diffuse', { lights: [LAMP] }, 0.2717, 'sine', 'sin in place of cos'],
    ['diffuse', { lights: [LAMP] }, 40, 'scale', 'not 255'],
    ['diffuse', { lights: [LAMP] }, 15.69, 'scale', 'not 100'],
    ['diffuse', { lights: [{ ...LAMP, position: [0, -1, 1, 0] }] }, -0.4437, 'unclamped', 'max(…, 0)'],
    ['ambient', { lights: [LAMP] }, 0.1, 'attenuation', 'ambient term'],
    ['diffuse', { lights: [spot] }, 0, 'aperture', 'from the axis to the edge'],
    ['diffuse', { lights: [{ ...spot, aperture: 20 }] }, 0.2733, 'cone', 'outside the cone'],
    [
      'sum',
      { lights: [{ ...LAMP, ambient: grey(255), diffuse: grey(255) }] },
      1.196,
      'unclamped',
      'min(…, 1)',
    ],
  ] as const)('in the %s term is named (%#)', (term, given, typed, mistake, words) => {
    const verdict = judge(String(typed), of(asked(given as unknown as Given), term), null);
    expect(verdict.correct).toBe(false);
    expect(verdict.text).toContain(words);
    expect(verdict.mistake).toBe(mistake);
  });

  it('in the highlight is named: the other lobe, no exponent, the exponent as a factor, a light behind', () => {
    const highlight = {
      lights: [{ ...LAMP, position: [0, 1, -1, 0], specular: grey(255) }],
      surface: { ks: grey(255) },
    };
    const [phong, blinn] = [false, true].map((halfway) => of(asked({ ...highlight, halfway }), 'specular'));
    expect(judge(blinn!.value.toFixed(4), phong!, null).text).toContain('N · H in place of R · V');
    expect(judge(phong!.value.toFixed(4), blinn!, null).text).toContain('R · V in place of N · H');
    const cosine = phong!.value ** (1 / 8);
    expect(judge(cosine.toFixed(4), phong!, null).mistake).toBe('exponent');
    expect(judge((8 * cosine).toFixed(3), phong!, null).mistake).toBe('times-exponent');
  });
});

it('takes commas, percent and the minus of the page, and asks for a number or for more digits', () => {
  const diffuse = of(asked({ lights: [LAMP] }), 'diffuse');
  for (const typed of ['0.157', '0,157', ' .1569 ', '15.7 %', '0.16'])
    expect(judge(typed, diffuse, null).correct, typed).toBe(true);
  for (const typed of ['', 'abc', '1.2.3', '0x1', '1e999', 'Infinity'])
    expect(judge(typed, diffuse, null), typed).toMatchObject({ value: null, correct: false, mistake: null });
  expect(judge('0.2', diffuse, null).mistake).toBe('digits');
  expect(judge('0', diffuse, null).text).toBe('Not yet: too small by 0.16.');
  expect(judge('0.45', diffuse, null)).toMatchObject({ mistake: null, text: 'Not yet: too large by 0.29.' });
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
  attenuation: fc.constantFrom([1, 0, 0], [1, 0.2, 0.5]),
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

it('calls every right answer right, and the value is that of the equation (seed 39)', () => {
  fc.assert(
    fc.property(GIVEN, fc.integer({ min: 4, max: 9 }), (given, digits) => {
      for (const equation of asked(given)) {
        if (equation.value < 0.01 && equation.value > 0) continue;
        expect(judge(equation.value.toFixed(digits), equation, null)).toMatchObject({
          correct: true,
          mistake: null,
        });
      }
    }),
    { seed: 39, numRuns: 200 },
  );
});

it('adds up to the colour that shadeAt gives, and each named value is one that the text can claim (seed 40)', () => {
  fc.assert(
    fc.property(GIVEN, (given) => {
      for (const equation of asked(given))
        for (const { value, text } of equation.wrongs) {
          if (!Number.isFinite(value) || Math.abs(value) > 1e6 || Math.abs(value) < 0.02) continue;
          const verdict = judge(value.toFixed(7), equation, null);
          if (verdict.correct)
            expect(Math.abs(value - equation.value)).toBeLessThan(0.0021 * equation.value + 1e-6);
          else {
            expect(verdict.mistake).not.toBeNull();
            // Of more than two mistakes that give this number the likelier ones are named.
            const near = equation.wrongs.filter(
              (each) => Math.abs(each.value - value) <= 0.002 * Math.abs(each.value) + 1e-6,
            );
            if (new Set(near.map((each) => each.text)).size <= 2) expect(verdict.text).toContain(text);
          }
        }
    }),
    { seed: 40, numRuns: 200 },
  );
});
