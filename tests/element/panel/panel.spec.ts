// Does the panel as a whole work? Fetched on first use, styled under a strict CSP, clear of the picture, removed again.

import { readFileSync } from 'node:fs';
import type { Locator } from '@playwright/test';
import { expect, test } from '../../support/test.js';
import { assign, cameraOf, nextFrame, type PhongViewer, record } from '../support/viewer.js';
import { button, field, listOf, opened, panelOf, titleOf, titlesIn } from './panel-rows.js';

const light = (name: string): string => `<phong-light name="${name}" diffuse="90 90 90"></phong-light>`;
const scene = (attributes = 'gui', ...lights: readonly string[]): string =>
  `<phong-viewer geometry="box" theta="20" phi="60" ${attributes}>${lights.map(light).join('')}</phong-viewer>`;

test('has a folder for lights, camera, shading and material, and one for meshes if there are any', async ({
  mount,
}) => {
  const viewer = await mount(scene('gui', 'sun', 'lamp'));
  await expect(titleOf(viewer, 'Material')).toBeVisible();
  expect(await titlesIn(panelOf(viewer))).toEqual([
    'Lights',
    'Camera',
    'Shading',
    'Show',
    'Material',
    'Meshes',
  ]);
  await expect(titleOf(viewer, 'Meshes')).toBeHidden();
  await viewer.evaluate((element: PhongViewer) => {
    element.geometry = null;
    element.append(document.createElement('phong-mesh'));
  });
  await expect(titleOf(viewer, 'Material')).toBeHidden();
  await expect(titleOf(viewer, 'Meshes')).toBeVisible();
});

test('lies at the top right inside the viewer and scrolls there', async ({ page, mount }) => {
  const viewer = await mount(scene('gui', 'a', 'b'), { width: 600, height: 300 });
  for (const title of ['a', 'b']) await opened(viewer, title);
  const outer = (await viewer.boundingBox())!;
  const inner = (await panelOf(viewer).boundingBox())!;
  expect(inner.x + inner.width).toBeLessThanOrEqual(outer.x + outer.width);
  expect(inner.x).toBeGreaterThan(outer.x + outer.width / 2);
  expect(inner.y + inner.height).toBeLessThanOrEqual(outer.y + outer.height);
  await page.mouse.move(inner.x + 40, inner.y + 150);
  await page.mouse.wheel(0, 200);
  await expect.poll(() => listOf(viewer).evaluate((list) => list.scrollTop)).toBeGreaterThan(100);
  await expect(titleOf(viewer, 'Controls')).toBeInViewport();
});

test('opens and closes by pointer and by keys', async ({ page, mount }) => {
  const viewer = await mount(scene());
  const title = titleOf(viewer, 'Controls');
  await expect(title).toHaveAttribute('aria-expanded', 'true');
  await title.click();
  await expect(title).toHaveAttribute('aria-expanded', 'false');
  await expect(listOf(viewer)).toBeHidden();
  await title.focus();
  await page.keyboard.press('Enter');
  await expect(listOf(viewer)).toBeVisible();
  await page.keyboard.press('Tab');
  await expect(viewer.getByRole('button', { name: 'Full screen' })).toBeFocused();
  for (let stops = 0; stops < 3; stops++) await page.keyboard.press('Tab'); // past undo and redo
  await page.keyboard.press('Space');
  await expect(titleOf(viewer, 'Lights')).toHaveAttribute('aria-expanded', 'false');
});

test('starts closed in a viewer as narrow as a phone, so that the picture stays visible', async ({
  page,
  mount,
}) => {
  await page.setViewportSize({ width: 360, height: 640 });
  const viewer = await mount(scene('gui', 'sun'), { width: 360, height: 640 });
  await expect(titleOf(viewer, 'Controls')).toHaveAttribute('aria-expanded', 'false');
  expect((await panelOf(viewer).boundingBox())!.width).toBeLessThan(130);
  await titleOf(viewer, 'Controls').click();
  await opened(viewer, 'sun');
  const { x, width } = (await panelOf(viewer).boundingBox())!;
  expect(x).toBeGreaterThanOrEqual(0);
  expect(x + width).toBeLessThanOrEqual(360);
});

test('never rotates or zooms the camera by input on the panel', async ({ page, mount }) => {
  const viewer = await mount(scene('gui="lights"', 'sun'));
  await opened(viewer, 'sun');
  const before = await cameraOf(viewer);
  const moves = await record(viewer, 'camera-change');
  const panel = (await panelOf(viewer).boundingBox())!;
  // On a title, a label, a slider, a field, and beside everything.
  for (const y of [15, 50, 150, 200, 260, 300]) {
    for (const x of [20, 60, 150, 240]) {
      await page.mouse.move(panel.x + x, panel.y + y);
      await page.mouse.down();
      await page.mouse.move(panel.x - 150, panel.y + y + 60, { steps: 3 });
      await page.mouse.up();
      await page.mouse.move(panel.x + x, panel.y + y);
      await page.mouse.wheel(0, 50);
    }
  }
  expect(await moves.take()).toEqual([]);
  expect(await cameraOf(viewer)).toEqual(before);
});

test('removes everything when gui is removed, and comes back', async ({ mount }) => {
  const viewer = await mount(scene('', 'sun'));
  const census = () =>
    viewer.evaluate((element) => {
      const root = element.shadowRoot!;
      return {
        sheets: root.adoptedStyleSheets.length,
        nodes: root.querySelectorAll('*').length,
        styled: document.querySelectorAll('head style').length,
        body: document.body.outerHTML.length,
      };
    });
  const without = await census();
  for (let round = 0; round < 3; round++) {
    await assign(viewer, { gui: true });
    await opened(viewer, 'sun');
    await expect(field(viewer, 'name')).toHaveValue('sun');
    expect((await census()).sheets).toBe(without.sheets + 1);
    await assign(viewer, { gui: false });
    await expect(panelOf(viewer)).toHaveCount(0);
    expect(await census()).toEqual(without);
  }
});

test('ends in the last state when gui is toggled while its code is loading', async ({ mount }) => {
  const viewer = await mount(scene(''));
  await viewer.evaluate(async (element: PhongViewer) => {
    for (const gui of [true, false, true, true]) {
      element.gui = gui;
      await element.updateComplete;
    }
  });
  await expect(panelOf(viewer)).toHaveCount(1);
});

test('keeps two viewers on a page apart', async ({ page, mount }) => {
  await mount(scene('gui id="a"', 'one') + scene('gui id="b"', 'two'), { height: 340 });
  const [a, b] = [page.locator('#a'), page.locator('#b')];
  await opened(a, 'one');
  await opened(b, 'two');
  await field(b, 'name').fill('three');
  await expect(titleOf(b, 'three')).toBeVisible();
  await expect(titleOf(a, 'one')).toBeVisible();
  await assign(a, { gui: false });
  await expect(panelOf(a)).toHaveCount(0);
  const sheets = await b.evaluate((element) => element.shadowRoot!.adoptedStyleSheets.length);
  expect(sheets, "the viewer's, the panel's, and the width of its column").toBe(3);
  await field(b, 'position x').fill('0.5');
  expect(await b.evaluate((element: PhongViewer) => element.lights[0]?.position[0])).toBe(0.5);
});

test('warns and keeps the picture if its code cannot be fetched', async ({ page, mount, consoleGuard }) => {
  await page.route('**/panel-*.js', (route) => route.abort());
  consoleGuard.allow(/Failed to load resource/, 1);
  const said = consoleGuard.allow(/control panel could not be fetched/, 1);
  const viewer = await mount(scene(''));
  await assign(viewer, { gui: true });
  await expect.poll(() => said.length).toBe(1);
  await expect(panelOf(viewer)).toHaveCount(0);
});

test.describe('an open panel', () => {
  const picture = (viewer: Locator) => viewer.locator('[part=surface]');

  test('stands beside the picture where there is room', async ({ mount }) => {
    const viewer = await mount(scene('gui', 'sun'), { width: 1000, height: 400 });
    await expect(panelOf(viewer)).toBeVisible();
    const beside = (await picture(viewer).boundingBox())!;
    expect(beside.width).toBeGreaterThan(650);
    expect(beside.x + beside.width).toBeLessThanOrEqual((await panelOf(viewer).boundingBox())!.x);
    await titleOf(viewer, 'Controls').click();
    expect((await picture(viewer).boundingBox())!.width).toBe(1000);
  });

  test('is a sheet on a phone and leaves half of the screen to the picture', async ({ page, mount }) => {
    await page.setViewportSize({ width: 390, height: 800 });
    const viewer = await mount(scene('gui', 'sun'), { width: 390, height: 800 });
    await titleOf(viewer, 'Controls').click();
    await opened(viewer, 'sun');
    const above = (await picture(viewer).boundingBox())!;
    expect([above.width, above.height]).toEqual([390, 400]);
    const sheet = (await panelOf(viewer).boundingBox())!;
    expect([sheet.x, sheet.y, sheet.width, sheet.height]).toEqual([0, 400, 390, 400]);
  });
});

test('saves the picture as a PNG under a strict policy', async ({ page, mount }) => {
  const viewer = await mount(scene('gui', 'sun'));
  const download = page.waitForEvent('download');
  await button(panelOf(viewer), 'save PNG').click();
  const file = await download;
  expect(file.suggestedFilename()).toBe('phong-viewer.png');
  const bytes = readFileSync(await file.path());
  expect([...bytes.subarray(1, 4)]).toEqual([...Buffer.from('PNG')]);
});

test.describe('copy HTML', () => {
  const copied = (viewer: Parameters<typeof button>[0]) =>
    viewer.getByRole('textbox', { name: "The scene's HTML" });

  test('puts the scene on the clipboard and says so', async ({ page, mount, context }) => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write']);
    const viewer = await mount(scene('gui', 'sun'));
    await button(panelOf(viewer), 'copy HTML').click();
    await expect(button(panelOf(viewer), 'copied ✓')).toBeVisible();
    const html = await viewer.evaluate((element: PhongViewer) => element.toHTML());
    expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(html);
    await expect(button(panelOf(viewer), 'copy HTML')).toBeVisible();
  });

  test('shows the markup, selected, if the clipboard is refused', async ({ page, mount }) => {
    await page.addInitScript(() => {
      Object.defineProperty(navigator, 'clipboard', { value: undefined });
    });
    const viewer = await mount(scene('gui', 'sun'));
    await button(panelOf(viewer), 'copy HTML').click();
    const html = await viewer.evaluate((element: PhongViewer) => element.toHTML());
    await expect(copied(viewer)).toHaveValue(html);
    await expect(copied(viewer)).toBeFocused();
    const selected = await copied(viewer).evaluate((area: HTMLTextAreaElement) => [
      area.selectionStart,
      area.selectionEnd,
    ]);
    expect(selected).toEqual([0, html.length]);
  });
});

test('starts closed in a viewer without a size, and opens depending on its first size', async ({ mount }) => {
  for (const [width, expanded] of [
    [300, 'false'],
    [500, 'true'],
  ] as const) {
    const viewer = await mount(`<dialog>${scene('gui', 'sun')}</dialog>`, { width, height: 300 });
    await expect(panelOf(viewer)).toBeAttached();
    await expect(titleOf(viewer, 'Controls')).toHaveAttribute('aria-expanded', 'false');
    await viewer.evaluate((element) => element.closest('dialog')!.showModal());
    await expect(titleOf(viewer, 'Controls')).toHaveAttribute('aria-expanded', expanded);
    // Only once: from then on it is the user's.
    await titleOf(viewer, 'Controls').click();
    await viewer.evaluate((element) => (element.style.width = '490px'));
    await nextFrame(viewer.page());
    await expect(titleOf(viewer, 'Controls')).toHaveAttribute('aria-expanded', String(expanded === 'false'));
  }
});

test('leaves the wheel over the picture to zoom while the panel has the focus', async ({ page, mount }) => {
  const viewer = await mount(scene('gui', 'sun'), { css: 'body { height: 3000px }' });
  const radius = async (): Promise<number> => (await cameraOf(viewer)).radius;
  const scrolled = (): Promise<number> => page.evaluate(() => scrollY);
  const wheel = async (): Promise<void> => {
    await page.mouse.move(200, 200);
    await page.mouse.wheel(0, 50);
    await nextFrame(page);
  };
  const first = await radius();
  const light = await opened(viewer, 'sun');
  await field(light, 'name').focus();
  await wheel();
  expect(await radius()).toBeCloseTo(first * Math.exp(0.05), 6);
  await button(panelOf(viewer), 'add light').click();
  await wheel();
  await page.mouse.click(200, 200);
  await wheel();
  expect(await radius()).toBeCloseTo(first * Math.exp(0.15), 6);
  expect(await scrolled()).toBe(0);
  await viewer.evaluate((element) => element.blur());
  await wheel();
  await expect.poll(scrolled).toBeGreaterThan(0);
  expect(await radius()).toBeCloseTo(first * Math.exp(0.15), 6);
});

test('shows the viewer in full screen, and back by the button or by Escape', async ({ page, mount }) => {
  const viewer = await mount(scene());
  const isOn = (): Promise<boolean> => viewer.evaluate((element) => element.matches(':fullscreen'));
  const enter = panelOf(viewer).getByRole('button', { name: 'Full screen', exact: true });
  const leave = panelOf(viewer).getByRole('button', { name: 'Leave full screen' });
  const { width, height } = (await enter.boundingBox())!;
  expect(Math.min(width, height)).toBeGreaterThanOrEqual(24);
  const before = await cameraOf(viewer);
  await enter.click();
  await expect(leave).toBeVisible();
  expect(await isOn()).toBe(true);
  expect(await viewer.evaluate(({ clientWidth }) => clientWidth / innerWidth)).toBe(1);
  await leave.click();
  await expect(enter).toBeVisible();
  expect(await isOn()).toBe(false);
  await enter.focus();
  await page.keyboard.press('Enter');
  await expect(leave).toBeVisible();
  await viewer.evaluate(() => document.exitFullscreen()); // as browsers do at Escape
  await expect(enter).toBeVisible();
  expect((await cameraOf(viewer)).theta).toBe(before.theta);
});

test('has no full-screen button in browsers without full screen, and otherwise works the same', async ({
  page,
  mount,
}) => {
  await page.addInitScript(() => {
    Object.defineProperty(Document.prototype, 'fullscreenEnabled', { value: false });
  });
  const viewer = await mount(scene());
  await expect(panelOf(viewer)).toBeVisible();
  await expect(panelOf(viewer).getByRole('button', { name: 'Full screen' })).toHaveCount(0);
  await assign(viewer, { texts: { Controls: 'Regler' }, gui: false });
  await assign(viewer, { gui: true });
  await expect(titleOf(viewer, 'Regler')).toBeVisible();
});
