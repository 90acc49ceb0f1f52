// A walk through scenes, one random change after another, that counts from the markup alone what
// programs are needed.

import type { Locator, Page } from '@playwright/test';
import { Dice } from '../../visual/random-scene.js';
import { expect } from '../../support/test.js';
import { glPrograms, isSpecialised, isLit } from '../support/gl-log.js';
import type { PhongViewer } from '../support/viewer.js';

const LIGHTS = [
  '',
  'specular="0"',
  'ambient="20"',
  'position="1 2 1"',
  'position="-1 2 1" attenuation="1 0.2 0.1"',
  'position="0 2 0" axis="0 -1 0" aperture="30"',
  'position="0 2 1" axis="0 -1 -1" cutoff="4"',
  'position="0 2 1" axis="0 -1 -1" cutoff="2.5" aperture="100" ambient="9"',
] as const;

/** Steps and their values. Other names are attributes of the viewer. */
const STEPS: readonly (readonly [what: string, values: readonly string[]])[] = [
  ['add light', LIGHTS],
  ['add light', LIGHTS],
  ['remove light', ['']],
  ['move', ['-2', '0.3', '2']],
  ['toggle', ['']],
  ['recolour', ['1 9 9', '80 9 9', '255 9 9']],
  ['shininess', ['1', '8', '150', '150.5', '1000']],
  ['shading', ['phong', 'gouraud', 'flat']],
  ['reflection', ['phong', 'blinn-phong']],
  ['color-interpolation', ['srgb', 'linear']],
  ['terms', ['ambient diffuse specular', 'diffuse', 'ambient diffuse', '']],
  ['ks', ['0', '128', '90 100 80']],
  ['geometry', ['box', 'sphere', 'torus']],
  ['draw on', ['']],
];

/** Specialised programs that a picture keeps. */
const MOST_SPECIALISED = 32;

/** Takes this many random steps and compares the programs made with those needed. */
export async function expectFewPrograms(
  page: Page,
  viewer: Locator,
  seed: number,
  steps: number,
): Promise<void> {
  const dice = new Dice(seed);
  await viewer.evaluate((element: PhongViewer) => {
    element.geometry = 'box';
    element.innerHTML = '<phong-light></phong-light>';
  });
  /** Distinct feature sets that general programs were needed for. */
  const needs = new Set<string>();
  // Never removed: declared features stay.
  const declared = new Set<string>();
  for (let i = 0; i < steps; i++) {
    const [what, values] = dice.pick(STEPS);
    const { style, facts } = await take(viewer, what, dice.pick(values), i);
    for (const fact of facts) {
      declared.add(fact);
    }
    needs.add([style, ...[...declared].sort()].join());
    const live = (await glPrograms(page)).filter(
      (one) => one.live && isLit(one) && isSpecialised(one),
    );
    expect(live.length).toBeLessThanOrEqual(MOST_SPECIALISED);
  }
  const general = (await glPrograms(page)).filter((one) => isLit(one) && !isSpecialised(one));
  const texts = general.map(({ vertex, fragment }) => vertex + fragment);
  console.log(
    `Seed ${seed}, ${steps} steps: ${general.length} general programs for ${needs.size} sets of needs`,
  );
  expect(new Set(texts).size, 'no text twice').toBe(texts.length);
  expect(general.length).toBeLessThanOrEqual(needs.size);
}

interface Need {
  /** What is shown by one program or another, whatever the lights are. */
  readonly style: string;
  /** The features that lights and surface declare now. */
  readonly facts: readonly string[];
}

/** Takes one step, draws, and returns the features that the general program then needs. */
function take(viewer: Locator, what: string, value: string, step: number): Promise<Need> {
  return viewer.evaluate(
    async (element: PhongViewer, [change, given, number]) => {
      const { lights } = element;
      const light = lights[number % lights.length]!;
      const [, y, , w] = light.position;
      if (change === 'add light') {
        element.insertAdjacentHTML('beforeend', `<phong-light ${given}></phong-light>`);
      } else if (change === 'remove light' && lights.length > 1) {
        light.remove();
      } else if (change === 'move') {
        light.position = [Number(given), y, 1, w];
      } else if (change === 'toggle') {
        light.active = !light.active;
      } else if (change === 'recolour') {
        light.setAttribute('diffuse', given);
      } else if (!change.includes(' ')) {
        element.setAttribute(change, given);
      }
      // To draw on is long enough for a program of its own.
      for (let frame = 0; frame < (change === 'draw on' ? 40 : 1); frame++) {
        element.requestRender();
        await new Promise(requestAnimationFrame);
      }
      await element.ready;
      await new Promise<void>((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
      const facts: string[] = [];
      const declare = (fact: string, isDeclared: boolean): unknown =>
        isDeclared && facts.push(fact);
      const lit = (color: readonly number[]): boolean => color.some((x) => x !== 0);
      for (const one of element.lights) {
        const { aperture, cutoff, attenuation } = one;
        const positional = one.position[3] === 1;
        const spot = positional && lit(one.axis) && (aperture < 180 || cutoff > 0);
        facts.push(positional ? (spot ? 'spot' : 'point') : 'directional');
        declare(aperture > 90 ? 'wide' : 'narrow', spot && aperture < 180);
        declare('decay', spot && cutoff > 0);
        declare('attenuation', positional && (attenuation[0] > 1 || lit(attenuation.slice(1))));
        for (const term of ['ambient', 'diffuse', 'specular'] as const) {
          declare(term, lit(one[term]));
        }
      }
      for (const term of element.terms) {
        declare(`${term} term`, term !== 'specular' || lit(element.ks));
      }
      // The power function is shorter for exponents up to 150.
      declare('steep', element.shininess > 150);
      // Flat shading differs in its triangles alone.
      const shading = element.shading === 'gouraud' ? 'gouraud' : 'fragment';
      const { reflection, colorInterpolation, antialias } = element;
      return { facts, style: [shading, reflection, colorInterpolation, antialias].join() };
    },
    [what, value, step] as const,
  );
}
