// What does a screen reader find in a viewer, and where does Tab stop? Read from Chromium's
// accessibility tree, not from attributes; rules by axe.

import type { Page } from '@playwright/test';
import { axeOn } from '../support/axe.js';
import { expect, test } from '../support/test.js';
import { assign } from '../element/support/viewer.js';
import { accessibleNode, accessibleNodes } from './tree.js';

const sun = '<phong-light name="sun" position="1 2 3 0"></phong-light>';
const lamp =
  '<phong-light name="lamp" position="2 0.5 -1.2345 1" diffuse="255 204 136"></phong-light>';
const spot =
  '<phong-light position="0 3 3 1" axis="0 -1 -1" aperture="20" active="false" space="camera"></phong-light>';
const viewer = (attributes: string, inner = sun) =>
  `<phong-viewer geometry="box" ${attributes}>${inner}</phong-viewer>`;
const fixed = 'orbit="false" zoom="false"';
const pinned = 'loading="eager" probe probe-at="0 0.5 0"';

const application = (page: Page) => accessibleNode(page, 'application');
const description = async (page: Page) => (await application(page)).description;

test('a page of viewers, lights in pictures, probes and comparisons breaks no rule of axe', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/404/);
  const three = ['Gouraud', 'Phong', 'Flat'].map((alt) => viewer(`alt="${alt}"`)).join('');
  await mount(
    `<main><h1>Viewers</h1>${viewer('alt="A box under one light"')}${viewer('')}${viewer('role="img" aria-label="A box"')}
    ${viewer('alt="A box" gui')}${viewer('alt="Nothing" src="/none.glb"')}
    ${viewer(`alt="A still" ${fixed}`)}${viewer(`alt="" ${fixed}`)}
    ${viewer('alt="Lights" loading="eager" helpers="lights axes grid normals bounds"', lamp + spot)}
    ${viewer(`alt="A point" ${pinned}`, lamp)}${viewer(`alt="A point, small" ${pinned} class="small"`)}
    <phong-compare>${three}</phong-compare><phong-compare layout="side">${three}</phong-compare>
    <phong-compare direction="vertical" labels="one, two, three">${three}</phong-compare></main>`,
    {
      width: 300,
      height: 200,
      css: 'phong-compare { display: block; width: 400px; height: 200px } .small { width: 120px; height: 90px }',
    },
  );
  await expect(page.getByRole('separator')).toHaveCount(4);
  await expect(page.locator('[part=probe]').filter({ visible: true })).toHaveCount(2);
  await expect(page.getByRole('listbox')).toBeVisible();
  expect((await axeOn(page).analyze()).violations).toEqual([]);
});

test('a viewer is an application with its keys, and its description follows scripts', async ({
  page,
  mount,
}) => {
  const element = await mount(
    viewer('alt="A box" theta="30" phi="70" radius="4.0625"', sun + lamp + spot),
  );
  await expect
    .poll(() => description(page))
    .toBe(
      'Arrow keys rotate. Plus and minus zoom. Home resets the camera. ' +
        'Camera: azimuth 30°, polar angle 70°, distance 4.06. Lights: sun, lamp, light 3 (off).',
    );
  const { name, properties } = await application(page);
  expect(name).toBe('A box');
  const keys = 'ArrowLeft ArrowRight ArrowUp ArrowDown Plus - PageUp PageDown Home';
  expect(properties).toMatchObject({ focusable: true, keyshortcuts: keys });
  await element.evaluate((target) => {
    target.theta = -90.4;
    Object.assign(target.lights[0]!, { name: 'moon', active: false });
    target.lights[1]!.remove();
  });
  await expect
    .poll(() => description(page))
    .toMatch(/ Camera: azimuth −90°, .*, distance 4.06. Lights: moon \(off\), light 2 \(off\)\.$/);
  await element.evaluate((target) => {
    for (let i = 0; i < 40; i++) {
      target.append(document.createElement('phong-light'));
    }
  });
  await expect
    .poll(() => description(page), 'eight of many')
    .toMatch(/Lights: moon .*light 8, \.{4}$/);
  await element.evaluate((target) => target.replaceChildren());
  await expect.poll(() => description(page)).toMatch(/distance 4.06\.$/);
  expect(await accessibleNodes(page)).toHaveLength(1);
});

test('only keys with an effect are listed; without any, a viewer is an image, no Tab stop', async ({
  page,
  mount,
}) => {
  const element = await mount(`${viewer('alt="A box" zoom="false"')}<a href="#next">Next</a>`);
  const keys = async () => (await application(page)).properties['keyshortcuts'];
  expect(await keys()).toBe('ArrowLeft ArrowRight ArrowUp ArrowDown Home');
  expect(await description(page)).toMatch(/^Arrow keys rotate. Home resets/);
  await assign(element, { orbit: false, zoom: true });
  await expect.poll(keys).toBe('Plus - PageUp PageDown Home');
  expect(await description(page)).toMatch(/^Plus and minus zoom. Home resets/);
  await assign(element, { zoom: false });
  await expect
    .poll(
      async () => (await accessibleNodes(page)).find(({ role }) => role === 'image')?.description,
    )
    .toMatch(/^Camera: .* Lights: sun\.$/);
  const { name, properties } = await accessibleNode(page, 'image');
  expect(name).toBe('A box');
  expect(properties).not.toHaveProperty('keyshortcuts');
  await page.keyboard.press('Tab');
  await expect(page.getByText('Next')).toBeFocused();
});

test('a fixed viewer that is decoration, or any that its author hides, is not read', async ({
  page,
  mount,
}) => {
  const attributes = ['alt=""', 'role="presentation"', 'aria-hidden="true"'];
  await mount(attributes.map((each) => viewer(`${each} ${fixed}`)).join(''));
  expect(await accessibleNodes(page)).toEqual([]);
});

test('aria-labelledby, aria-label, alt name the picture, in this order; stops have names', async ({
  page,
  mount,
}) => {
  const names = 'aria-labelledby="one" aria-label="Label" alt="A box"';
  const element = await mount(`<h1 id="one">Heading</h1>${viewer(names)}`);
  const name = async () => (await application(page)).name;
  expect(await name()).toBe('Heading');
  for (const [attribute, next] of [
    ['aria-labelledby', 'Label'],
    ['aria-label', 'A box'],
    ['alt', '3D scene'],
  ] as const) {
    await element.evaluate((target, gone) => target.removeAttribute(gone), attribute);
    await expect.poll(name).toBe(next);
  }
  await assign(element, { alt: 'Another box' });
  await expect.poll(name).toBe('Another box');
  await mount(viewer('alt=""'));
  expect(await name()).toBe('3D scene');
});

test("the author's role, aria-label and tabindex are left as they are", async ({ page, mount }) => {
  const element = await mount(
    `${viewer('role="figure" aria-label="Mine" tabindex="-1" alt="Other"')}${viewer('alt="A box" tabindex="-1"')}
    <a href="#next">Next</a>`,
  );
  const facts = await element.evaluate((target) =>
    ['role', 'aria-label', 'tabindex'].map((name) => target.getAttribute(name)),
  );
  expect(facts).toEqual(['figure', 'Mine', '-1']);
  const plain = page.locator('phong-viewer').last();
  expect(await plain.evaluate((target) => target.getAttributeNames())).toEqual([
    'geometry',
    'alt',
    'tabindex',
  ]);
  await page.keyboard.press('Tab');
  await expect(page.getByText('Next')).toBeFocused();
});

test('Tab reaches each viewer once, there and back', async ({ page, mount }) => {
  const first = await mount(`${viewer('')}${viewer('')}<a href="#next">Next</a>`);
  await page.keyboard.press('Tab');
  await expect(first).toBeFocused();
  await page.keyboard.press('Tab');
  await expect(page.locator('phong-viewer').nth(1)).toBeFocused();
  await page.keyboard.press('Tab');
  await expect(page.getByText('Next')).toBeFocused();
  await page.keyboard.press('Shift+Tab');
  await page.keyboard.press('Shift+Tab');
  await expect(first).toBeFocused();
});
