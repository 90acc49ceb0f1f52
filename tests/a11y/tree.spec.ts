// What does a screen reader find in a viewer? Read from Chromium's accessibility tree, not from attributes.

import type { Page } from '@playwright/test';
import { expect, test } from '../support/test.js';
import { assign, type PhongViewer } from '../element/support/viewer.js';
import { accessibleNode, accessibleNodes } from './tree.js';

const sun = '<phong-light name="sun" position="1 2 3 0"></phong-light>';
const lamp = '<phong-light name="lamp" position="2 0.5 -1.2345 1" diffuse="255 204 136"></phong-light>';
const spot =
  '<phong-light position="0 3 3 1" axis="0 -1 -1" aperture="20" active="false" space="camera"></phong-light>';
const viewer = (attributes: string, inner = sun): string =>
  `<phong-viewer geometry="box" ${attributes}>${inner}</phong-viewer>`;

const roles = async (page: Page): Promise<string[]> => (await accessibleNodes(page)).map(({ role }) => role);

test('a viewer is an application with a name, its keys, and a description of camera and lights', async ({
  page,
  mount,
}) => {
  await mount(viewer('alt="A box" theta="30" phi="70" radius="4.0625"', sun + lamp + spot));
  await expect
    .poll(async () => (await accessibleNode(page, 'application')).description)
    .toBe(
      'Arrow keys rotate. Plus and minus zoom. Home resets the camera. ' +
        'Camera: azimuth 30°, polar angle 70°, distance 4.06. Lights: sun, lamp, light 3 (off).',
    );
  const { name, properties } = await accessibleNode(page, 'application');
  expect(name).toBe('A box');
  expect(properties).toMatchObject({
    focusable: true,
    keyshortcuts: 'ArrowLeft ArrowRight ArrowUp ArrowDown Plus - PageUp PageDown Home',
  });
});

test('only keys that have an effect are listed and described', async ({ page, mount }) => {
  const element = await mount(viewer('alt="A box" zoom="false"'));
  const keys = async (): Promise<unknown> =>
    (await accessibleNode(page, 'application')).properties['keyshortcuts'];
  expect(await keys()).toBe('ArrowLeft ArrowRight ArrowUp ArrowDown Home');
  expect((await accessibleNode(page, 'application')).description).toMatch(/^Arrow keys rotate. Home resets/);
  await assign(element, { orbit: false, zoom: true });
  await expect.poll(keys).toBe('Plus - PageUp PageDown Home');
  expect((await accessibleNode(page, 'application')).description).toMatch(
    /^Plus and minus zoom. Home resets/,
  );
});

test('a viewer that cannot be moved is an image, and no stop for the Tab key', async ({ page, mount }) => {
  const element = await mount(`${viewer('alt="A box" orbit="false" zoom="false"')}<a href="#next">Next</a>`);
  await expect
    .poll(async () => (await accessibleNode(page, 'image')).description)
    .toMatch(/^Camera: .* Lights: sun\.$/);
  const { name, properties } = await accessibleNode(page, 'image');
  expect(name).toBe('A box');
  expect(properties).not.toHaveProperty('keyshortcuts');
  await page.keyboard.press('Tab');
  expect(await page.evaluate(() => document.activeElement?.localName)).toBe('a');
  await assign(element, { zoom: true });
  expect(await roles(page)).toContain('application');
});

test('the description follows what scripts change', async ({ page, mount }) => {
  const element = await mount(viewer('alt="A box" radius="4"', sun));
  const description = async (): Promise<string> => (await accessibleNode(page, 'application')).description;
  await expect.poll(description).toMatch(/Lights: sun\.$/);
  await element.evaluate((target: PhongViewer) => {
    target.theta = -90.4;
    target.lights[0]!.name = 'moon';
    target.lights[0]!.active = false;
    target.append(document.createElement('phong-light'));
  });
  await expect
    .poll(description)
    .toMatch(/ Camera: azimuth −90°, polar angle 70°, distance 4. Lights: moon \(off\), light 2\.$/);
  await element.evaluate((target: PhongViewer) => target.replaceChildren());
  await expect.poll(description).toMatch(/distance 4\.$/);
  expect(await roles(page)).toEqual(['application']);
});

test('with many lights the description names eight', async ({ page, mount }) => {
  await mount(viewer('alt="A box"', '<phong-light></phong-light>'.repeat(40)));
  await expect
    .poll(async () => (await accessibleNode(page, 'application')).description)
    .toMatch(/Lights: light 1, .*light 8, \.{4}$/);
});

test('a fixed viewer with an empty alt is decoration: nothing of it is read', async ({ page, mount }) => {
  await mount(
    `${viewer('alt="" orbit="false" zoom="false"')}${viewer('role="presentation" orbit="false" zoom="false"')}`,
  );
  expect(await roles(page)).toEqual([]);
});

test('everything focusable has a name', async ({ page, mount }) => {
  await mount(viewer('alt=""'));
  expect((await accessibleNode(page, 'application')).name).toBe('3D scene');
});

test('aria-labelledby names the picture by other elements’ text, and aria-label goes before alt', async ({
  page,
  mount,
}) => {
  const element = await mount(`<h1 id="one">Heading</h1>${viewer('aria-labelledby="one" alt="A box"')}`);
  const name = async (): Promise<string> => (await accessibleNode(page, 'application')).name;
  expect(await name()).toBe('Heading');
  await element.evaluate((target) => {
    target.removeAttribute('aria-labelledby');
    target.setAttribute('aria-label', 'Label');
  });
  await expect.poll(name).toBe('Label');
  await element.evaluate((target) => target.removeAttribute('aria-label'));
  await expect.poll(name).toBe('A box');
});

test('a viewer hidden by its author stays hidden', async ({ page, mount }) => {
  await mount(viewer('aria-hidden="true" orbit="false" zoom="false"'));
  expect(await roles(page)).toEqual([]);
});
