// Does <phong-control> edit one value of viewers, lights and meshes, from anywhere on the page?

import type { Locator, Page } from '@playwright/test';
import { decodePng } from '../../support/picture.js';
import { compare, expect, test } from '../../support/test.js';
import { assign, cameraOf, drag } from '../../element/support/viewer.js';
import { readyTexts } from '../../support/texts.js';

const de = readyTexts('de');

const css = 'phong-viewer { display: block; width: 160px; height: 100px }';
const scene = `<phong-viewer id="v" geometry="torus"><phong-light id="spot" name="spot" position="0 2 0"
  axis="0 -1 0" aperture="30" cutoff="8"></phong-light><phong-mesh id="m" geometry="plane"></phong-mesh></phong-viewer>`;
const control = (attributes: string, label = '') =>
  `<phong-control ${attributes}>${label}</phong-control>`;

const lightOf = (page: Page) => page.locator('phong-light').first();
const valueOf = (of: Locator, key: string) =>
  of.evaluate((element, name) => Number(Reflect.get(element, name)), key);

test('a number is a field with its unit in a sentence, and a slider alone or as asked', async ({
  mount,
  page,
}) => {
  const aperture = control('for="spot" attribute="aperture" max="60"');
  await mount(
    `${scene}<p>The spot's ${aperture} is half its cone.</p>${control('for="spot" attribute="cutoff" max="60"', 'softness')}
      <p>In a line ${control('for="v" attribute="fov" type="slider"')}</p>`,
    { css },
  );
  const light = lightOf(page);
  const field = page.getByRole('spinbutton', { name: 'aperture' });
  await expect(field).toHaveValue('30');
  await expect(page.locator('phong-control').first().locator('[part=unit]')).toHaveText('°');
  await expect(page.getByRole('slider')).toHaveCount(2);
  const heights = await page.evaluate(() =>
    ['p', 'phong-control'].map(
      (name) => document.querySelector(name)!.getBoundingClientRect().height,
    ),
  );
  expect(heights[0]).toBeLessThan(1.5 * heights[1]!);
  // It is dragged, turned by arrow keys and typed.
  const box = (await field.boundingBox())!;
  await drag(page, [box.x + 5, box.y + 5], [20, 0]);
  expect(await valueOf(light, 'aperture')).toBeGreaterThan(30);
  await field.focus();
  await page.keyboard.press('ArrowUp');
  await field.fill('200');
  await page.keyboard.press('Enter');
  expect(await valueOf(light, 'aperture')).toBe(60);
  await field.press('Control+z');
  expect(await valueOf(light, 'aperture')).toBeLessThan(60);

  const slider = page.getByRole('slider', { name: 'softness' });
  await expect(page.getByRole('slider', { name: 'fov' })).toBeVisible();
  await slider.focus();
  await page.keyboard.press('End');
  expect(await valueOf(light, 'cutoff')).toBe(60);
  await page.keyboard.press('Control+z');
  expect(await valueOf(light, 'cutoff')).toBe(8);
  await assign(light, { cutoff: 100 });
  await expect(page.getByRole('spinbutton', { name: 'softness' })).toHaveValue('100');
  await expect(slider).toHaveAttribute('max', '1');
});

test('looks as the value asks: switch, choice, colour, component, stepper through values', async ({
  mount,
  page,
}) => {
  const steps = 'ambient | ambient diffuse | ambient diffuse specular';
  const viewer = await mount(
    scene +
      control('for="spot" attribute="active"') +
      control('for="v" attribute="shading"') +
      control('for="spot" attribute="diffuse"') +
      control('for="spot" attribute="position" component="x" min="-2" max="2"', 'left and right') +
      control('for="m" attribute="segments" type="number"') +
      control('for="v" attribute="orbit"') +
      control(`for="v" attribute="terms" values="${steps}"`, 'the sum'),
    { css },
  );
  await page.getByRole('checkbox', { name: 'active' }).uncheck();
  await page.getByRole('combobox', { name: 'shading' }).selectOption('flat');
  await page.getByRole('textbox', { name: 'diffuse', exact: true }).fill('10 20 30');
  await page.getByRole('spinbutton', { name: 'left and right' }).fill('1.5');
  await page.getByRole('spinbutton', { name: 'segments' }).fill('7');
  await page.getByRole('checkbox', { name: 'orbit' }).uncheck();
  await page.getByRole('button', { name: 'the sum back' }).click();
  expect(
    await viewer.evaluate(({ shading, orbit, terms, lights, meshes }) => [
      shading,
      orbit,
      terms,
      lights[0]!.active,
      lights[0]!.diffuse,
      lights[0]!.position,
      meshes[0]!.segments,
    ]),
  ).toEqual(['flat', false, ['ambient', 'diffuse'], false, [10, 20, 30], [1.5, 2, 0, 1], 7]);
  await expect(page.locator('output')).toHaveText('ambient diffuse');
  await page.getByRole('button', { name: 'the sum forward' }).click();
  await expect(page.getByRole('button', { name: 'the sum forward' })).toHaveAttribute(
    'aria-disabled',
    'true',
  );
});

test('a stepper points along the page’s direction in every language', async ({ mount, page }) => {
  const steps = control('for="v" attribute="theta" values="1|2|3"');
  await mount(scene.replace('id="v"', 'id="v" theta="2"') + steps, { css });
  const shown = async (i: number) =>
    decodePng(await page.locator('.steps button').nth(i).screenshot());
  const [back, forward] = [await shown(0), await shown(1)];
  for (const [lang, dir, isTurned] of [
    ['ar', 'rtl', true],
    ['ku', 'ltr', false],
  ] as const) {
    await page.evaluate((root) => Object.assign(document.documentElement, root), { lang, dir });
    const now = await shown(0);
    expect(compare(now, forward).share < compare(now, back).share, lang).toBe(isTurned);
  }
});

test('turns two viewers together, as one step of each, and follows the camera in a drag', async ({
  mount,
  page,
}) => {
  const pair = ['a', 'b']
    .map((id) => `<phong-viewer id="${id}" geometry="box"></phong-viewer>`)
    .join('');
  await mount(
    pair + control('for="a b" attribute="theta"') + control('for="a b" attribute="shininess"'),
    {
      css,
    },
  );
  const [a, b] = [page.locator('#a'), page.locator('#b')];
  const theta = page.getByRole('spinbutton', { name: 'θ azimuth' });
  await theta.fill('75');
  for (const viewer of [a, b]) {
    expect((await cameraOf(viewer)).theta).toBeCloseTo(75);
  }
  await page.getByRole('spinbutton', { name: 'shininess' }).fill('7');
  expect([await valueOf(a, 'shininess'), await valueOf(b, 'shininess')]).toEqual([7, 7]);
  await page.keyboard.press('Enter');
  await page.getByRole('spinbutton', { name: 'shininess' }).press('Control+z');
  expect([await valueOf(a, 'shininess'), await valueOf(b, 'shininess')]).toEqual([32, 32]);
  const box = (await a.boundingBox())!;
  await page.mouse.move(box.x + 80, box.y + 50);
  await page.mouse.down();
  await page.mouse.move(box.x + 120, box.y + 50, { steps: 4 });
  await expect(theta).not.toHaveValue('75');
  await page.mouse.up();
  // Written while it is off the page.
  await page
    .locator('phong-control')
    .first()
    .evaluate(async (element) => {
      element.remove();
      await new Promise((resolve) => setTimeout(resolve));
      element.setAttribute('attribute', 'phi');
      document.body.append(element);
    });
  await expect(page.getByRole('spinbutton', { name: 'φ polar' })).toBeVisible();
});

test('waits for later elements, and warns once of those that never come', async ({
  consoleGuard,
  mount,
  page,
}) => {
  const said = [
    /no element has the id "sput"\. Did you mean "spot"\?/,
    /<phong-light> has no attribute "cutof"\. Did you mean "cutoff"\?/,
    /<p id="p"> is no viewer, light or mesh/,
  ].map((pattern) => consoleGuard.allow(pattern, 1));
  const wrong =
    control('for="sput" attribute="cutoff"') + control('for="spot" attribute="cutof"').repeat(2);
  await mount(`${scene}<p id="p"></p>${wrong}${control('for="p" attribute="ka"')}`, { css });
  await page.evaluate(async (html) => {
    document.body.insertAdjacentHTML('beforeend', html);
    const away = document
      .querySelector('phong-control')!
      .cloneNode() as HTMLElementTagNameMap['phong-control'];
    document.body.append(away);
    away.remove();
    await new Promise((resolve) => setTimeout(resolve, 100));
    away.min = 5; // says nothing, as it is not there
    const light = '<phong-light id="late" cutoff="3"></phong-light>';
    document.querySelector('phong-viewer')!.insertAdjacentHTML('beforeend', light);
  }, control('for="late" attribute="cutoff"'));
  const late = page.locator('phong-control[for=late]');
  await expect(late.locator('.number')).toHaveValue('3');
  await page.locator('#late').evaluate((light) => light.remove());
  await expect(late.locator('.number')).toHaveCount(0);
  await expect.poll(() => said.map(({ length }) => length)).toEqual([1, 1, 1]);
});

test('speaks the page’s language, works under a strict policy, prints name and value in it', async ({
  mount,
  page,
}) => {
  const texts = `<script type="application/json" data-phong-viewer-texts>${JSON.stringify(de)}</script>`;
  await mount(`${scene}<p>Der ${control('for="spot" attribute="aperture"')} des Spots</p>`, {
    css,
    head: texts,
  });
  const only = page.locator('phong-control');
  await expect(only.locator('[part~=label]')).toHaveText(de['aperture °'].replace(/\s*°$/, ''));
  await assign(lightOf(page), { aperture: 30.5 });
  await page.emulateMedia({ media: 'print' });
  await expect(only.locator('input').first()).toBeHidden();
  await expect(only.locator('.printed')).toHaveText('30,5°');
  await expect(only.locator('.printed')).toBeVisible();
});

test('in a sentence what has no label is alone, a number is rounded as `step` says, and one edit is one step', async ({
  page,
  mount,
}) => {
  const viewer = await mount(
    `<main lang="de">${scene}<p>Öffnung ${control('for="spot" attribute="aperture" step="1"')}, mit Namen ${control('for="spot" attribute="cutoff"', 'weich')}, Farbe ${control('for="spot" attribute="diffuse"')}.</p>${control('for="spot" attribute="active"')}</main>`,
    { head: '<script type="application/json" data-phong-viewer-texts>{"on":"an"}</script>' },
  );
  const light = page.locator('#spot');
  await assign(light, { aperture: 30.123456 });
  const [number, named, colour, flag] = [0, 1, 2, 3].map((i) =>
    page.locator('phong-control').nth(i),
  );
  const field = page.getByRole('spinbutton', { name: 'aperture' });
  await expect(field).toHaveValue('30');
  const nameWidth = (of: Locator) =>
    of.locator('[part~=label]').evaluate((label) => label.getBoundingClientRect().width);
  expect(await nameWidth(number!)).toBeLessThanOrEqual(1);
  expect(await nameWidth(colour!)).toBeLessThanOrEqual(1);
  expect(await nameWidth(named!)).toBeGreaterThan(10);
  await field.focus();
  for (let presses = 0; presses < 3; presses++) {
    await field.press('ArrowUp');
  }
  expect(await valueOf(light, 'aperture')).toBeCloseTo(33.123456, 6);
  await field.blur();
  await viewer.press('Control+z');
  expect(await valueOf(light, 'aperture')).toBe(30.123456);
  await page.emulateMedia({ media: 'print' });
  await expect(flag!.locator('.printed')).toHaveText('an');
  const [name, state] = await flag!.evaluate(({ shadowRoot }) =>
    ['.lil-name', '.printed'].map(
      (one) => shadowRoot!.querySelector(one)!.getBoundingClientRect().left,
    ),
  );
  expect(name).toBeLessThan(state!);
});
