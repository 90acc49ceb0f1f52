// Can lights in the picture be found, chosen and moved by keyboard and screen reader? Read from
// Chromium's accessibility tree; tree.spec.ts has the rules of axe.

import type { Locator } from '@playwright/test';
import { firstOf } from '../support/repeats.js';
import { expect, test } from '../support/test.js';
import { contrast, screenshot } from './contrast.js';
import { accessibleNode, accessibleNodes } from './tree.js';

const scene = `<main><h1>Lights</h1><phong-viewer alt="A box" geometry="box" helpers="lights axes grid normals bounds">
  <phong-light name="lamp" position="0.5 0.4 1 1"></phong-light>
  <phong-light name="spot" position="-0.6 0.5 0 1" axis="1 0 0" aperture="20" active="false"></phong-light>
</phong-viewer></main>`;

test('lights are options of a list, named and placed, one selected', async ({ page, mount }) => {
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
  expect(options.map(({ properties }) => properties['selected'])).toEqual([
    true,
    false,
    false,
    false,
  ]);
});

test('the start of a move announces the keys, and its end the light’s position', async ({
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

for (const background of firstOf(['#fff', '#777', '#000', '#00f', '#595959', '#fc8'], 2)) {
  test(`lights, arrows and names have a contrast of 3:1 on ${background}`, async ({ mount }) => {
    const lights = ['#00f', '#fc8', '#000', '#777', '#fff'].map(
      (color, i) =>
        `<phong-light name="${i}" diffuse="${color}" position="${(i - 2) * 0.6} 0.5 0 1"></phong-light>`,
    );
    const viewer = await mount(
      `<phong-viewer alt="Lights" helpers theta="0" phi="90" radius="4" target="0 0 0">${lights.join('')}
        <phong-light name="sun" diffuse="#400" position="0 -1 0 0"></phong-light></phong-viewer>`,
      { css: `phong-viewer { background: ${background} }` },
    );
    await expect(viewer.locator('svg text')).toHaveCount(6);
    const colorAt = await screenshot(viewer);
    const behind = colorAt(2, 2);
    /** The best contrast along the line of pixels across the middle of a shape. */
    const across = async (shape: Locator, beside = 0) => {
      const { x, y, width, height } = (await shape.boundingBox())!;
      const length = width + 2 * beside;
      const line = Array.from({ length }, (_, i) => colorAt(x - beside + i, y + height / 2));
      return Math.max(...line.map((color) => contrast(color, behind)));
    };
    const texts = await viewer.locator('svg text').all();
    const options = await viewer.getByRole('option').all();
    for (const shape of [...options, ...texts]) {
      expect(await across(shape), String(shape)).toBeGreaterThanOrEqual(3);
    }
    expect(await across(viewer.locator('svg path').last(), 2)).toBeGreaterThanOrEqual(3);
  });
}
