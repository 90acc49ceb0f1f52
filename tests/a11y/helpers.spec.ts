// Can the lights in the picture be found, chosen and moved without seeing them? Read from Chromium's accessibility tree; rules by axe.

import AxeBuilder from '@axe-core/playwright';
import { expect, test } from '../support/test.js';
import { accessibleNode, accessibleNodes } from './tree.js';

const scene = `<main><h1>Lights</h1><phong-viewer alt="A box" geometry="box" helpers="lights axes grid normals bounds">
  <phong-light name="lamp" position="0.5 0.4 1 1"></phong-light>
  <phong-light name="spot" position="-0.6 0.5 0 1" axis="1 0 0" aperture="20" active="false"></phong-light>
</phong-viewer></main>`;

test('lights are a list of options with names and places, of which one has been chosen', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene);
  await expect(viewer.getByRole('option')).toHaveCount(4);
  const { name } = await accessibleNode(page, 'listbox');
  expect(name).toBe('Lights in the picture');
  const options = (await accessibleNodes(page)).filter(({ role }) => role === 'option');
  expect(options.map((option) => [option.name, option.description])).toEqual([
    ['lamp: point light, position 0.5 0.4 1, diffuse 255 255 255', 'Enter starts moving.'],
    ['spot (off): spot light, position −0.6 0.5 0, diffuse 255 255 255', 'Enter starts moving.'],
    ['spot: axis', 'Enter starts moving.'],
    ['spot: edge of the cone, 20°', 'Enter starts moving.'],
  ]);
  expect(options.map(({ properties }) => properties['selected'])).toEqual([true, false, false, false]);
});

test('what keys do is announced at the start of a move, and where the light is after it', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene);
  await viewer.getByRole('option', { name: /^lamp/ }).press('Enter');
  await expect(viewer.locator('.helpers [aria-live=polite]')).toHaveText(
    'Arrow keys move, with Shift toward you and away. Enter ends, Escape restores.',
  );
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Enter');
  await expect(viewer.locator('.helpers [aria-live=polite]')).toHaveText('');
  await expect(viewer.locator('.reader [aria-live=polite]')).toHaveText(
    /^lamp: point light, position \S+ 0.4/,
  );
});

test('helpers break no rule of axe', async ({ page, mount }) => {
  const viewer = await mount(scene);
  await expect(viewer.getByRole('option')).toHaveCount(4);
  const { violations } = await new AxeBuilder({ page }).analyze();
  expect(violations.map(({ id, nodes }) => [id, nodes.map(({ html }) => html)])).toEqual([]);
});
