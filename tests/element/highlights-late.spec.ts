// The code of antialias="highlights" comes with the first picture that asks for it: what is shown until then, and without it.

import type { Page } from '@playwright/test';
import type { PhongViewer } from '../../src/index.js';
import { compare, expect, pixels, test } from '../support/test.js';
import { assign, nextFrame } from './support.js';

const tiny = `<phong-viewer geometry="sphere" radius="30" shininess="2000" ks="255">
  <phong-light position="1 1 1 0"></phong-light>
</phong-viewer>`;

async function heldBack(page: Page): Promise<{ letGo: () => void }> {
  let letGo = (): void => undefined;
  const free = new Promise<void>((resolve) => {
    letGo = resolve;
  });
  await page.route(/averaged-highlights/, async (route) => {
    await free;
    await route.continue();
  });
  return { letGo };
}

test('until the code is there a picture that is shown goes on without, and ready waits for it', async ({
  page,
  mount,
}) => {
  const { letGo } = await heldBack(page);
  const viewer = await mount(tiny);
  const before = await pixels(viewer);
  await viewer.evaluate((element: PhongViewer) => {
    element.antialias = 'highlights';
    void element.ready.then(() => element.toggleAttribute('data-ready'));
  });
  await nextFrame(page);
  expect(compare(await pixels(viewer), before).max).toBe(0);
  await expect(viewer).not.toHaveAttribute('data-ready');
  letGo();
  await expect(viewer).toHaveAttribute('data-ready');
  expect(compare(await pixels(viewer), before).max).toBeGreaterThan(0);
  await assign(viewer, { antialias: 'edges' });
  expect(compare(await pixels(viewer), before).max).toBe(0);
});

test('a first picture waits for the code, and makes one program', async ({ page, mount }) => {
  const { letGo } = await heldBack(page);
  const viewer = await mount(tiny.replace('>', ' antialias="highlights">'), { waitForReady: false });
  await nextFrame(page);
  await nextFrame(page);
  expect(await viewer.evaluate((element: PhongViewer) => element.stats.frames)).toBe(0);
  letGo();
  await viewer.evaluate((element: PhongViewer) => element.ready);
  expect(await viewer.evaluate((element: PhongViewer) => element.stats)).toMatchObject({
    frames: 1,
    programs: 1,
  });
});

test('a first picture is drawn without where the code cannot be fetched', async ({
  page,
  mount,
  consoleGuard,
}) => {
  await page.route(/averaged-highlights/, (route) => route.abort());
  consoleGuard.allow(/Failed to load resource/, 1);
  consoleGuard.allow(/antialias="highlights" could not be fetched/, 1);
  const viewer = await mount(tiny.replace('>', ' antialias="highlights">'));
  expect(await viewer.evaluate((element: PhongViewer) => element.stats.frames)).toBe(1);
});

test('says so and leaves the picture where the code cannot be fetched', async ({
  page,
  mount,
  consoleGuard,
}) => {
  await page.route(/averaged-highlights/, (route) => route.abort());
  consoleGuard.allow(/Failed to load resource/, 1);
  const said = consoleGuard.allow(/antialias="highlights" could not be fetched/, 1);
  const viewer = await mount(tiny);
  const before = await pixels(viewer);
  await assign(viewer, { antialias: 'highlights' });
  await viewer.evaluate((element: PhongViewer) => element.ready);
  expect(said).toHaveLength(1);
  expect(compare(await pixels(viewer), before).max).toBe(0);
});
