// Does the panel as a whole work? Fetched on first use, styled under a strict CSP, clear of the
// picture, removed again.

import { readFileSync } from 'node:fs';
import { markupIn } from '../../../src/extras/png/index.js';
import { type ViewerLocator, expect, test } from '../../support/test.js';
import { countEverything, spentIn } from '../../element/support/counting.js';
import {
  assign,
  cameraOf,
  drag,
  htmlOf,
  nextFrame,
  type PhongViewer,
  record,
} from '../../element/support/viewer.js';
import {
  button,
  field,
  folderOf,
  listOf,
  opened,
  panelOf,
  slider,
  titleOf,
  titlesIn,
} from './panel-rows.js';

const light = (name: string) => `<phong-light name="${name}" diffuse="90 90 90"></phong-light>`;
const scene = (attributes = 'gui', ...lights: readonly string[]) =>
  `<phong-viewer geometry="box" theta="20" phi="60" ${attributes}>${lights.map(light).join('')}</phong-viewer>`;

const openFolders = (viewer: ViewerLocator) =>
  panelOf(viewer)
    .locator('> .lil-children > .lil-gui > .lil-title[aria-expanded=true]')
    .filter({ visible: true })
    .allTextContents();

test('has folders, of which the listed ones are open, and one for meshes if there are any', async ({
  mount,
}) => {
  const viewer = await mount(scene('gui', 'sun', 'lamp'));
  await expect(titleOf(viewer, 'Material')).toBeVisible();
  const titles = ['Lights', 'Camera', 'Shading', 'Show', 'Material', 'Meshes'];
  expect(await titlesIn(panelOf(viewer))).toEqual(titles);
  await expect(titleOf(viewer, 'Meshes')).toBeHidden();
  expect(await openFolders(viewer)).toEqual(['Lights', 'Camera']);
  const row = panelOf(viewer).locator('.lil-controller').filter({ hasText: 'auto-rotate' });
  await expect(row).toHaveAttribute('title', 'auto-rotate: Degrees per second about y');
  await expect(button(viewer, 'save PNG')).toBeVisible();
  await expect(button(viewer, 'open model…')).toHaveCount(0);
  await assign(viewer, { gui: ['shading'], droppable: true });
  await expect(titleOf(viewer, 'Lights')).toHaveAttribute('aria-expanded', 'false');
  expect(await openFolders(viewer)).toEqual(['Shading']);
  await expect(button(viewer, 'open model…')).toBeVisible();
  await viewer.evaluate((element) => {
    element.geometry = null;
    element.append(document.createElement('phong-mesh'));
  });
  await expect(titleOf(viewer, 'Material')).toBeHidden();
  await expect(titleOf(viewer, 'Meshes')).toBeVisible();
});

test('a list of attributes shows their rows in its order, and warns of others', async ({
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/the panel has no row for poster/, 1);
  const viewer = await mount(`<phong-viewer geometry="torus" gui="cutoff poster shininess theta">
    <phong-light name="sun"></phong-light>
    <phong-light name="spot" position="0 2 0 1" axis="0 -1 0" aperture="30" cutoff="8"></phong-light></phong-viewer>`);
  const rows = panelOf(viewer).locator('.lil-controller').filter({ visible: true });
  // The sun is no spot.
  await expect(rows.locator('.lil-name')).toHaveText(['spot: cutoff', 'shininess', 'θ azimuth °']);
  expect(await titlesIn(panelOf(viewer))).toEqual([]);
  await expect(panelOf(viewer).getByRole('button')).toHaveText(['Controls']);
  await viewer.evaluate((element) => (element.lights[1]!.name = 'lamp'));
  await expect(rows.first().locator('.lil-name')).toHaveText('lamp: cutoff');
  await slider(viewer, 'shininess').press('ArrowRight');
  expect(await viewer.evaluate(({ shininess }) => shininess)).toBeGreaterThan(32);
  await viewer.evaluate((element) => {
    element.theta = -70;
    element.lights[1]!.remove();
    Object.assign(element.lights[0]!, { position: [0, 1, 0, 1], cutoff: 3 });
  });
  await expect(rows.locator('.lil-name')).toHaveText(['cutoff', 'shininess', 'θ azimuth °']);
  await expect(slider(viewer, 'θ azimuth °')).toHaveAttribute('aria-valuetext', '-70');
});

test('has the range of the whole scene, even if it is there before the shapes', async ({
  page,
  mount,
}) => {
  await page.route('**/teapot.*', async (route) => {
    await page.waitForSelector('[title=radius]');
    await route.continue();
  });
  const viewer = await mount('<phong-viewer gui geometry="teapot" radius="2"></phong-viewer>');
  // 0.54 where the scene is empty.
  await expect(slider(viewer, 'radius')).toHaveValue(/0\.[6-9]/);
});

test('lies inside the viewer, scrolls there, and opens and closes by pointer and by keys', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene('gui', 'a', 'b'), { width: 600, height: 300 });
  for (const title of ['a', 'b']) {
    await opened(viewer, title);
  }
  const outer = (await viewer.boundingBox())!;
  const inner = (await panelOf(viewer).boundingBox())!;
  expect(inner.x + inner.width).toBeLessThanOrEqual(outer.x + outer.width);
  expect(inner.x).toBeGreaterThan(outer.x + outer.width / 2);
  expect(inner.y + inner.height).toBeLessThanOrEqual(outer.y + outer.height);
  await page.mouse.move(inner.x + 40, inner.y + 150);
  await page.mouse.wheel(0, 200);
  await expect.poll(() => listOf(viewer).evaluate((list) => list.scrollTop)).toBeGreaterThan(100);
  const title = titleOf(viewer, 'Controls');
  await expect(title).toBeInViewport();
  await title.click();
  await expect(title).toHaveAttribute('aria-expanded', 'false');
  await expect(listOf(viewer)).toBeHidden();
  await title.focus();
  await page.keyboard.press('Enter');
  await expect(listOf(viewer)).toBeVisible();
  await page.keyboard.press('Tab');
  await expect(viewer.getByRole('button', { name: 'Full screen' })).toBeFocused();
  for (let stops = 0; stops < 3; stops++) {
    await page.keyboard.press('Tab'); // past undo and redo
  }
  await page.keyboard.press('Space');
  await expect(titleOf(viewer, 'Lights')).toHaveAttribute('aria-expanded', 'false');
});

test('starts closed on a phone, as a sheet that leaves half of the screen to the picture', async ({
  page,
  mount,
}) => {
  await page.setViewportSize({ width: 360, height: 640 });
  const viewer = await mount(scene('gui', 'sun'), { width: 360, height: 640 });
  const picture = viewer.locator('[part=surface]');
  await expect(titleOf(viewer, 'Controls')).toHaveAttribute('aria-expanded', 'false');
  expect((await panelOf(viewer).boundingBox())!.width).toBeLessThan(130);
  await titleOf(viewer, 'Controls').click();
  await opened(viewer, 'sun');
  expect(await picture.boundingBox()).toMatchObject({ width: 360, height: 320 });
  expect(await panelOf(viewer).boundingBox()).toEqual({ x: 0, y: 320, width: 360, height: 320 });
});

test('never rotates or zooms the camera by input on the panel', async ({ page, mount }) => {
  const viewer = await mount(scene('gui="lights"', 'sun'));
  await opened(viewer, 'sun');
  const before = await cameraOf(viewer);
  const moves = await record(viewer, 'camera-change');
  const panel = (await panelOf(viewer).boundingBox())!;
  // On a title, a label, a slider, a field, and beside everything.
  for (const y of [15, 50, 150, 260]) {
    for (const x of [20, 150, 240]) {
      await drag(page, [panel.x + x, panel.y + y], [-150 - x, 60]);
      await page.mouse.move(panel.x + x, panel.y + y);
      await page.mouse.wheel(0, 50);
    }
  }
  expect(await moves.take()).toEqual([]);
  expect(await cameraOf(viewer)).toEqual(before);
});

test('removes everything when gui is removed, and comes back, also while its code is loading', async ({
  mount,
}) => {
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
  await viewer.evaluate(async (element) => {
    for (const gui of [true, false, true, true]) {
      element.gui = gui;
      await element.updateComplete;
    }
  });
  await expect(panelOf(viewer)).toHaveCount(1);
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
  expect(sheets, "the viewer's two and the panel's").toBe(3);
  await field(b, 'position x').fill('0.5');
  expect(await b.evaluate((element: PhongViewer) => element.lights[0]?.position[0])).toBe(0.5);
});

test('saves a PNG with the scene, and copies the scene or shows it if no clipboard is there', async ({
  page,
  mount,
  context,
}) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  const viewer = await mount(scene('gui', 'sun'));
  const download = page.waitForEvent('download');
  await button(panelOf(viewer), 'save PNG').click();
  const file = await download;
  expect(file.suggestedFilename()).toBe('phong-viewer.png');
  const html = await htmlOf(viewer);
  expect(await markupIn(new Uint8Array(readFileSync(await file.path())))).toBe(html);

  await button(panelOf(viewer), 'copy HTML').click();
  await expect(button(panelOf(viewer), 'copied ✓')).toBeVisible();
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(html);

  await page.evaluate(
    () => void Object.defineProperty(navigator, 'clipboard', { value: undefined }),
  );
  await button(panelOf(viewer), 'copy HTML').click();
  const text = viewer.getByRole('textbox', { name: "The scene's HTML" });
  await expect(text).toHaveValue(html);
  await expect(text).toBeFocused();
  const selected = text.evaluate((area: HTMLTextAreaElement) => [
    area.selectionStart,
    area.selectionEnd,
  ]);
  expect(await selected).toEqual([0, html.length]);
});

test('starts closed in a viewer without a size, and opens depending on its first size', async ({
  mount,
}) => {
  for (const [width, expanded] of [
    [300, 'false'],
    [500, 'true'],
  ] as const) {
    const viewer = await mount(`<dialog>${scene('gui loading="eager"', 'sun')}</dialog>`, {
      width,
      height: 300,
    });
    await expect(panelOf(viewer)).toBeAttached();
    await expect(titleOf(viewer, 'Controls')).toHaveAttribute('aria-expanded', 'false');
    await viewer.evaluate((element) => element.closest('dialog')!.showModal());
    await expect(titleOf(viewer, 'Controls')).toHaveAttribute('aria-expanded', expanded);
    // Only once: from then on it is the user's.
    await titleOf(viewer, 'Controls').click();
    await viewer.evaluate((element) => (element.style.width = '490px'));
    await nextFrame(viewer.page());
    await expect(titleOf(viewer, 'Controls')).toHaveAttribute(
      'aria-expanded',
      String(expanded === 'false'),
    );
  }
});

test('leaves the wheel over the picture to zoom while the panel has the focus', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene('gui', 'sun'), { css: 'body { height: 3000px }' });
  const radius = async () => (await cameraOf(viewer)).radius;
  const wheel = async () => {
    await page.mouse.move(200, 200);
    await page.mouse.wheel(0, 50);
    await nextFrame(page);
  };
  const first = await radius();
  await field(await opened(viewer, 'sun'), 'name').focus();
  await wheel();
  expect(await radius()).toBeCloseTo(first * Math.exp(0.05), 6);
  await button(panelOf(viewer), 'add light').click();
  await wheel();
  await page.mouse.click(200, 200);
  await wheel();
  expect(await radius()).toBeCloseTo(first * Math.exp(0.15), 6);
  expect(await page.evaluate(() => scrollY)).toBe(0);
});

test('shows the viewer in full screen, and back by the button or Escape, if browsers can', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene());
  const isOn = () => viewer.evaluate((element) => element.matches(':fullscreen'));
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

  await page.evaluate(() => {
    Object.defineProperty(Document.prototype, 'fullscreenEnabled', { value: false });
  });
  await assign(viewer, { texts: { Controls: 'Regler' }, gui: false });
  await assign(viewer, { gui: true });
  await expect(titleOf(viewer, 'Regler')).toBeVisible();
  await expect(panelOf(viewer).getByRole('button', { name: 'Full screen' })).toHaveCount(0);
});

test('requests no frame and no timer while nothing changes, and refreshes once for many writes', async ({
  page,
  mount,
}) => {
  await countEverything(page);
  const viewer = await mount(`<phong-viewer gui geometry="box">
    <phong-light name="sun" position="1 2 1 0"></phong-light>
    <phong-light name="spot" position="0 3 3 1" axis="0 -1 -1" aperture="20"></phong-light></phong-viewer>`);
  for (const title of ['sun', 'spot', 'Camera', 'Shading', 'Show', 'Material']) {
    await opened(viewer, title);
  }
  await page.mouse.move(10, 390);
  await spentIn(page, 300);
  expect(await spentIn(page, 1000)).toMatchObject({ frames: 0, timers: 0, idleCallbacks: 0 });
  const reads = await viewer.evaluate(async (element) => {
    const light = element.lights[0]!;
    const place = element.shadowRoot!.querySelector('.lil-root')!;
    let changes = 0;
    const observer = new MutationObserver((records) => (changes += records.length));
    observer.observe(place, {
      subtree: true,
      attributes: true,
      attributeFilter: ['aria-valuetext'],
    });
    for (let i = 0; i < 100; i++) {
      light.diffuse = light.specular = light.ambient = [i, 0, 0];
    }
    for (let frame = 0; frame < 3; frame++) {
      await new Promise(requestAnimationFrame);
    }
    return changes;
  });
  expect(reads).toBe(3);
  await expect(field(folderOf(viewer, 'sun'), 'diffuse')).toHaveValue('99 0 0');
});
