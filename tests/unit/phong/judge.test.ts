// Does the judge name each usual mistake from its colours, alone and in pairs, and nothing that the
// colours do not bear out?
import { describe, expect, it } from 'vitest';
import { map, normalize, type Vec3 } from '../../../src/phong/math/vector.js';
import { both, type Form, formsOf, MISTAKE_IDS } from '../../../src/phong/mistakes/mistakes.js';
import {
  type Case,
  compare as comparing,
  differenceOf,
  isRight,
  type Judged,
  mistakesIn as naming,
  sumAt,
  type Work,
} from '../../../src/phong/mistakes/judge.js';
import { SCENE_NAMES, sheetOf, type Task } from '../../../src/phong/mistakes/sheet.js';
import { TERMS } from '../../../src/phong/light/light-state.js';
import { fullOr } from '../../support/repeats.js';
import type { Given } from '../../../src/phong/mistakes/steps.js';

const ALL: Task = { kinds: ['directional', 'point', 'spot'], terms: TERMS, reflection: 'phong' };
const casesOf = (task: Task) => sheetOf(task, 120).map(({ given }) => [given]);
const phong = casesOf(ALL);
const blinn = casesOf({ ...ALL, reflection: 'blinn-phong' });
const sheetFor = (id: string) => (id === 'phong-for-blinn' ? blinn : phong);

function resultOf<Result>(work: Work<Result>) {
  for (;;) {
    const { done, value } = work.next();
    if (done === true) return value;
  }
}
const compare = (...given: Parameters<typeof comparing>) => resultOf(comparing(...given));
const mistakesIn = (judged: readonly Judged[]) => resultOf(naming(judged));

/** Colours by a function, with the noise of float32 in another order. */
const colorsOf = (cases: readonly Case[], of: (at: Case) => Vec3) =>
  Float32Array.from(
    cases.flatMap((at, i) =>
      of(at).map((x, k) => x * (1 + 3e-6 * Math.sin(7 * i + k)) + 1e-9 * Math.cos(i)),
    ),
  );

const judged = (cases: readonly Case[], form: Form = {}) =>
  compare(
    cases,
    colorsOf(cases, (at) => sumAt(at, form)),
    true,
  );

const forms = MISTAKE_IDS.flatMap((id) => formsOf(id).map((form, i) => ({ id, i, form })));

describe('from the colours at the sheet', () => {
  it('the right equation is right, with the noise of another order', () => {
    expect(isRight(judged(phong))).toBe(true);
    expect(isRight(judged(blinn))).toBe(true);
  });

  it.each(forms)('$id in form $i is named, and shows in a fiftieth of a scene', ({ id, form }) => {
    const cases = sheetFor(id);
    const found = judged(cases, form);
    expect(mistakesIn([found])).toEqual([id]);
    const perScene = SCENE_NAMES.map(
      (_, scene) => found.wrong.filter((i) => Math.floor(i / 120) === scene).length,
    );
    expect(Math.max(...perScene)).toBeGreaterThan(120 / 50);
  });

  it('two mistakes are named, or the one of them that hides the other', () => {
    let count = 0;
    let named = 0;
    for (const [i, a] of forms.entries()) {
      for (const [k, b] of forms.entries()) {
        const isTaken = k > i && a.id !== b.id && (i * 31 + k) % fullOr(97, 389) === 0;
        const isOfBlinn = a.id === 'phong-for-blinn' || b.id === 'phong-for-blinn';
        const form = isTaken && !isOfBlinn ? both(a.form, b.form) : undefined;
        if (form === undefined) continue;
        const found = mistakesIn([judged(phong, form)]);
        count++;
        if (found.length === 2) {
          named++;
        }
        if (found.length > 0) {
          expect(found.some((id) => id === a.id || id === b.id)).toBe(true);
        }
      }
    }
    expect(count).toBeGreaterThan(fullOr(40, 9));
    expect(named).toBeGreaterThan(0.9 * count);
  }, 60_000);

  it('two mistakes are named of a function that keeps its result between 0 and 1', () => {
    const form = both(formsOf('normal-not-unit')[0]!, formsOf('no-decay')[0]!);
    const colors = phong.flatMap((at) => sumAt(at, form, true));
    expect(mistakesIn([compare(phong, colors, true)])).toEqual(['normal-not-unit', 'no-decay']);
  });

  it('the search of pairs of mistakes can pause after each of them, and at each point', () => {
    const half = phong.map((at) => sumAt(at).map((x) => x / 2));
    const work = naming([resultOf(comparing(phong, half.flat(), true))]);
    let pauses = 0;
    while (work.next().done !== true) {
      pauses++;
    }
    expect(pauses).toBeGreaterThan(forms.length ** 2 / 3);
  });

  const nonsense: Readonly<Record<string, (given: Given) => Vec3>> = {
    black: () => [0, 0, 0],
    'the normal as a colour': ({ normal }) => normalize(normal),
    'half of the light': (given) => map(sumAt([given]), (x) => x / 2),
    'a gamma curve': (given) => map(sumAt([given]), (x) => x ** (1 / 2.2)),
    'red and blue exchanged': (given) => {
      const [r, g, b] = sumAt([given]);
      return [b, g, r];
    },
    'not a number': () => [NaN, NaN, NaN],
    infinite: () => [Infinity, Infinity, Infinity],
  };
  it.each([
    [['directional', 'point', 'spot'], TERMS],
    [['directional'], TERMS],
    [['point'], TERMS],
    [['spot'], TERMS],
    [['directional'], ['ambient', 'diffuse']],
    [['point'], ['diffuse', 'specular']],
    [['spot'], ['ambient', 'specular']],
  ] as const)('nonsense gets no name under %s lights with %s terms', (kinds, terms) => {
    const cases = casesOf({ kinds, terms, reflection: 'phong' });
    for (const [name, of] of Object.entries(nonsense)) {
      const found = compare(
        cases,
        colorsOf(cases, ([given]) => of(given!)),
        true,
      );
      expect([isRight(found), ...mistakesIn([found])], name).toEqual([false]);
    }
  });

  it('a function that differs without a name is described by terms, lights and region', () => {
    // Attenuation and highlight by a curve of one's own, for lamps at a place.
    const form: Form = {
      lobe: ({ cosine }, { light, material }) =>
        Math.max(cosine, 0) **
        (light.position[3] === 1 ? material.shininess + 9 : material.shininess),
    };
    expect(mistakesIn([judged(phong, form)])).toEqual([]);
    expect(differenceOf(judged(phong, form))).toEqual({
      kinds: ['point', 'spot'],
      regions: ['highlight'],
    });
  });
});

it('no edge of a cone is named where a few directions do not tell one from another', () => {
  const cases = casesOf({ ...ALL, kinds: ['directional'] });
  for (const id of ['aperture-in-radians', 'whole-aperture'] as const) {
    const found = formsOf(id).map((form) => judged(cases, form));
    // All lights taken for suns.
    found.push(judged(phong, { ...formsOf('w-ignored')[3], ...formsOf(id).at(-1) }));
    const wrong = found.filter((one) => !isRight(one));
    expect(wrong.length, id).toBeGreaterThan(0);
    for (const one of wrong) {
      expect(mistakesIn([one]), id).toEqual([]);
    }
  }
});

it('of two equal functions the one is named whose sentence is true of both', () => {
  const cases = casesOf({ ...ALL, terms: ['specular'], kinds: ['directional'] });
  const form = both(formsOf('no-gate')[0]!, formsOf('light-reversed')[0]!);
  expect(mistakesIn([judged(cases, form)])).toEqual(['no-gate', 'view-reversed']);
});

it.each([
  ['diffuse', { ...ALL, terms: ['diffuse'], kinds: ['directional'] }, 'no-clamp'],
  [
    'ambient and diffuse of lamps',
    { ...ALL, terms: ['ambient', 'diffuse'], kinds: ['point'] },
    'no-attenuation',
  ],
  ['spots only', { ...ALL, kinds: ['spot'] }, 'no-cone'],
  ['spots without a highlight', { ...ALL, terms: ['ambient', 'diffuse'] }, 'ambient-outside-cone'],
  ['ambient light', { ...ALL, terms: ['ambient'] }, 'no-ambient'],
  ['a highlight', { ...ALL, terms: ['specular'] }, 'no-gate'],
] as const)('an exercise of %s keeps to it', (_, task, id) => {
  const cases = casesOf(task);
  expect(cases.length).toBeGreaterThan(0);
  expect(mistakesIn([judged(cases, formsOf(id)[0])])).toEqual([id]);
  // A function that knows the other terms and lights too is right.
  const full = colorsOf(cases, ([given]) => sumAt([{ ...given!, terms: TERMS }]));
  expect(isRight(compare(cases, full, true))).toBe(true);
  // A few points without a number say nothing about terms and lights that are not asked for.
  const some = full.map((x, i) => (i % 60 < 3 ? NaN : x));
  expect(mistakesIn([compare(cases, some, true)])).toEqual([]);
});
