// A walk through scenes, one random change after another, that counts from the markup alone what programs are needed.

import type { Locator, Page } from '@playwright/test';
import { Dice } from '../../visual/random-scene.js';
import { expect } from '../../support/test.js';
import { glPrograms, isSpecialised, isLit } from '../support/gl-log.js';
import type { PhongViewer } from '../support/viewer.js';

interface Walked {
  /** Distinct feature sets that general programs were needed for. */
  readonly needs: number;
  /** The most specialised programs at a time. */
  readonly mostSpecialised: number;
}

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

type Step = (dice: Dice) => readonly [what: string, value: string];

/** What one step changes; moving, toggling and colours are more frequent than what makes programs. */
const STEPS: readonly Step[] = [
  (dice) => ['add light', dice.pick(LIGHTS)],
  (dice) => ['add light', dice.pick(LIGHTS)],
  () => ['remove light', ''],
  (dice) => ['move', String(dice.from(-2, 2))],
  (dice) => ['toggle', String(dice.from(0, 1))],
  (dice) => ['recolour', String(Math.round(dice.from(1, 255)))],
  (dice) => ['shininess', String(dice.pick([1, 8, 200, 200.5, 1e3]))],
  (dice) => ['shading', dice.pick(['phong', 'gouraud', 'flat'])],
  (dice) => ['reflection', dice.pick(['phong', 'blinn-phong'])],
  (dice) => ['color-interpolation', dice.pick(['srgb', 'linear'])],
  (dice) => ['terms', dice.pick(['ambient diffuse specular', 'diffuse', 'ambient diffuse', ''])],
  (dice) => ['ks', dice.pick(['0', '128', '90 100 80'])],
  (dice) => ['geometry', dice.pick(['box', 'sphere', 'torus'])],
  () => ['draw on', ''],
];

/** Frames of "draw on": enough for a program of its own. */
const DRAWN_ON = 40;

/** Specialised programs that a picture keeps. */
const MOST_SPECIALISED = 32;

/** Takes this many random steps and compares the programs made with those needed. */
export async function expectFewPrograms(
  page: Page,
  viewer: Locator,
  seed: number,
  steps: number,
): Promise<void> {
  const { needs, mostSpecialised } = await walk(page, viewer, new Dice(seed), steps);
  const programs = (await glPrograms(page)).filter(isLit);
  const general = programs.filter((one) => !isSpecialised(one));
  const texts = general.map(({ vertex, fragment }) => vertex + fragment);
  console.log(`Seed ${seed}, ${steps} steps: ${general.length} general programs for ${needs} sets of needs, ${programs.length - general.length} specialised ones, ${mostSpecialised} at a time`); // prettier-ignore
  expect(new Set(texts).size, 'no text twice').toBe(texts.length);
  expect(general.length).toBeLessThanOrEqual(needs);
  expect(mostSpecialised).toBeLessThanOrEqual(MOST_SPECIALISED);
}

async function walk(page: Page, viewer: Locator, dice: Dice, steps: number): Promise<Walked> {
  await viewer.evaluate((element: PhongViewer) => {
    element.geometry = 'box';
    element.innerHTML = '<phong-light></phong-light>';
  });
  const needs = new Set<string>();
  // Never removed: declared features stay.
  const declared = new Set<string>();
  let mostSpecialised = 0;
  for (let i = 0; i < steps; i++) {
    const [what, value] = dice.pick(STEPS)(dice);
    const { style, facts } = await take(viewer, what, value, i);
    for (const fact of facts) declared.add(fact);
    needs.add([style, ...[...declared].sort()].join());
    const specialised = (await glPrograms(page)).filter(
      (one) => one.live && isLit(one) && isSpecialised(one),
    );
    mostSpecialised = Math.max(mostSpecialised, specialised.length);
  }
  return { needs: needs.size, mostSpecialised };
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
    async (element: PhongViewer, [change, given, number, frames]) => {
      const lights = element.lights;
      const light = lights[number % Math.max(lights.length, 1)];
      if (change === 'add light')
        element.insertAdjacentHTML('beforeend', `<phong-light ${given}></phong-light>`);
      else if (change === 'remove light') {
        if (lights.length > 1) light?.remove();
      } else if (change === 'move') {
        if (light) light.position = [Number(given), light.position[1], 1, light.position[3]];
      } else if (change === 'toggle') {
        if (light) light.active = !light.active;
      } else if (change === 'recolour') {
        if (light) light.diffuse = [Number(given), 9, 9];
      } else if (change !== 'draw on') element.setAttribute(change, given);
      for (let frame = 0; frame < (change === 'draw on' ? frames : 1); frame++) {
        element.requestRender();
        await new Promise(requestAnimationFrame);
      }
      await element.ready;
      await new Promise<void>((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
      const facts: string[] = [];
      for (const {
        position,
        axis,
        aperture,
        cutoff,
        attenuation,
        ambient,
        diffuse,
        specular,
      } of element.lights) {
        const lit = (color: readonly number[]): boolean => color.some((x) => x > 0);
        const spot = lit(axis.map(Math.abs)) && (aperture < 180 || cutoff > 0);
        const positional = position[3] === 1;
        facts.push(positional ? (spot ? 'spot' : 'point') : 'directional');
        if (positional && spot && aperture < 180) facts.push(aperture > 90 ? 'wide' : 'narrow');
        if (positional && spot && cutoff > 0) facts.push('decay');
        if (positional && (attenuation[0] > 1 || attenuation[1] > 0 || attenuation[2] > 0)) {
          facts.push('attenuation');
        }
        if (lit(ambient)) facts.push('ambient');
        if (lit(diffuse)) facts.push('diffuse');
        if (lit(specular)) facts.push('specular');
      }
      for (const term of element.terms) {
        if (term !== 'specular' || element.ks.some((k) => k > 0)) facts.push(`${term} term`);
      }
      // The power function is shorter for exponents up to 200.
      if (element.shininess > 200) facts.push('steep');
      // Flat shading differs in its triangles alone.
      const shading = element.shading === 'gouraud' ? 'gouraud' : 'fragment';
      return {
        facts,
        style: [shading, element.reflection, element.colorInterpolation, element.antialias].join(),
      };
    },
    [what, value, step, DRAWN_ON] as const,
  );
}
