// Does <phong-exercise> run what learners write, and say what is wrong with it?

import type { Locator, Page } from '@playwright/test';
import { assign } from '../../element/support/viewer.js';
import { firstOf, fullOr } from '../../support/repeats.js';
import type { CheckDetail, PhongExercise } from '../../../src/viewer/element/phong-exercise.js';
import { expect, type Mount, test } from '../../support/test.js';
import {
  REFUSED_ONES,
  RIGHT_ONES,
  SLOW,
  STOPPED_ONES,
  UNDEFINED_POWER,
  UNUSUAL_ONES,
  WRONG_ONES,
} from './functions.js';

const css = 'phong-viewer { display: block; width: 150px; height: 100px }';
const markup = `<phong-viewer id="v" alt="A torus under a lamp" geometry="torus" shininess="20">
  <phong-light position="1 1 1" ambient="40" attenuation="1 0 0.5"></phong-light>
  <phong-light position="-2 1 1 0" diffuse="120 40 40"></phong-light>
  <phong-light position="1 2 2" axis="-1 -2 -2" aperture="20" cutoff="4"></phong-light></phong-viewer>
  <phong-exercise for="v"></phong-exercise>`;

/** Writes a function, presses run, and waits for the verdict. */
const checkOf = (exercise: Locator, source: string) =>
  exercise.evaluate(
    (element, text) =>
      new Promise<CheckDetail>((resolve) => {
        const own = element as PhongExercise;
        own.value = text;
        own.addEventListener('check', ({ detail }) => resolve(detail), {
          once: true,
        });
        own.shadowRoot!.querySelector('button')!.click();
      }),
    source,
  );

const mountOne = async (page: Page, mount: Mount) => {
  await mount(markup, { css });
  const one = page.locator('phong-exercise');
  await expect(one.getByRole('button', { name: 'Run' })).toBeVisible();
  return one;
};

test('right functions are right, in every writing', async ({ mount, page }) => {
  test.setTimeout(240_000);
  const one = await mountOne(page, mount);
  for (const [name, source] of firstOf(Object.entries(RIGHT_ONES), 4)) {
    const { right, mistakes, share } = await checkOf(one, source);
    expect({ name, right, mistakes }).toEqual({ name, right: true, mistakes: [] });
    expect(share).toBeGreaterThan(0.99);
  }
  await checkOf(one, UNDEFINED_POWER);
  await expect(one.locator('[part=verdict]')).toHaveText(/^\s*Right: [^]*another GPU/);
});

test('wrong functions are named by the mistake in their code', async ({ mount, page }) => {
  test.setTimeout(600_000);
  const one = await mountOne(page, mount);
  // phong/judge.test.ts names each by the same colours.
  let tried = 0;
  for (const [i, [ids, forms]] of Object.entries(WRONG_ONES).entries()) {
    for (const [form, source] of firstOf(Object.entries(forms), i % 9 === 0 ? 1 : 0)) {
      const { right, mistakes } = await checkOf(one, source);
      expect(right, `${ids}, ${form}`).toBe(false);
      expect.soft(mistakes.join(' + '), form).toBe(ids);
      tried += 1;
    }
  }
  expect(tried).toBeGreaterThan(fullOr(60, 4));
});

test('functions that are wrong in an unusual way get no name, and are not right where nothing is lit or asked', async ({
  mount,
  page,
}) => {
  test.setTimeout(240_000);
  const one = await mountOne(page, mount);
  for (const [name, source] of firstOf(Object.entries(UNUSUAL_ONES), 4)) {
    const { right, mistakes } = await checkOf(one, source);
    expect({ name, right, mistakes }).toEqual({ name, right: false, mistakes: [] });
  }
  await assign(one, { terms: ['ambient'] });
  await checkOf(one, UNUSUAL_ONES['a constant']!);
  await expect(one.locator('[part=verdict]')).toContainText('It differs in: Ambient term.');
  await page
    .locator('phong-light')
    .evaluateAll((lights) => lights.forEach((light) => light.setAttribute('active', 'false')));
  const black = UNUSUAL_ONES['black']!;
  expect((await checkOf(one, black)).right).toBe(false);
  await assign(page.locator('phong-viewer'), { geometry: null, innerHTML: '' });
  await assign(one, { terms: [], kinds: [] });
  expect((await checkOf(one, black)).share).toBeLessThan(1);
});

test('what cannot run says why, at its line, and what was written stays', async ({
  mount,
  page,
}) => {
  test.setTimeout(240_000);
  const one = await mountOne(page, mount);
  // guard.test.ts refuses the others in Node.
  const some = [
    ...firstOf(Object.entries(STOPPED_ONES), 11),
    ...firstOf(Object.entries(REFUSED_ONES), 2),
  ];
  for (const [name, [source, reason]] of some) {
    const { right } = await checkOf(one, source);
    expect({ name, right }).toEqual({ name, right: false });
    await expect(one.getByRole('alert'), name).toContainText(reason);
    await expect(one.getByRole('textbox')).toHaveValue(source);
  }
  await checkOf(one, SLOW);
  await expect(one.getByRole('alert')).toContainText('The function takes too long');
  const [source] = STOPPED_ONES['a wrong name']!;
  await checkOf(one, source);
  await expect(one.locator('.faulty')).toHaveText('19');
  await expect(one.getByRole('textbox')).toHaveAttribute('aria-invalid', 'true');
});
