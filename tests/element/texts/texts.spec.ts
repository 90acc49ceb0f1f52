// Does `texts` replace every text that a viewer shows or announces? The test puts all texts in
// brackets and looks for text without brackets.

import { VIEWER_TEXTS } from '../../support/texts.js';
import { type ViewerLocator, expect, test } from '../../support/test.js';
import {
  button,
  choice,
  field,
  folderOf,
  listOf,
  opened,
  panelOf,
  row,
  titleOf,
} from '../../extras/panel/panel-rows.js';
import { assign } from '../support/viewer.js';

const bracketed = Object.fromEntries(VIEWER_TEXTS.map((text) => [text, `[${text}]`]));

const scene = `<phong-viewer alt="Szene" geometry="box" gui><phong-light name="Sonne"></phong-light>
  <phong-light position="1 2 3 1" cutoff="4" axis="0 -1 0"></phong-light>
  <phong-light space="camera" active="false"></phong-light>
  <phong-mesh geometry="sphere"></phong-mesh><phong-mesh src=""></phong-mesh></phong-viewer>`;

/**
 * All texts that users see, hear or get as a tooltip: text nodes, and attributes that contain text.
 */
const textsIn = (viewer: ViewerLocator) =>
  viewer.evaluate(({ shadowRoot }) => {
    const found: string[] = [];
    for (const element of shadowRoot!.querySelectorAll('*')) {
      // lil-gui's copy of a choice, which is never shown.
      if (element.matches('style, .lil-display')) continue;
      for (const node of element.childNodes) {
        if (node instanceof Text) {
          found.push(node.data);
        }
      }
      for (const name of ['aria-label', 'aria-description', 'title', 'placeholder', 'alt']) {
        found.push(element.getAttribute(name) ?? '');
      }
    }
    return [...new Set(found.filter((text) => text.trim() !== ''))];
  });

/** A text of the viewer itself is in brackets; a sentence for screen readers is several. */
const isReplaced = (text: string) => /^\[.*\]\.?$/s.test(text);

/** Waits for the description in the new texts, which follows a second later. */
const described = (viewer: ViewerLocator) =>
  expect.poll(async () => (await textsIn(viewer)).join()).toContain('[Camera: ');

async function openAll(viewer: ViewerLocator) {
  const closed = viewer.locator('.lil-title[aria-expanded=false]');
  while ((await closed.filter({ visible: true }).count()) > 0) {
    await closed.filter({ visible: true }).first().click();
  }
}

test('texts replaces every text of the panel, of the picture and of its description', async ({
  mount,
}) => {
  const viewer = await mount(scene);
  await expect(panelOf(viewer)).toBeVisible();
  await assign(viewer, { texts: bracketed });
  await expect(titleOf(viewer, '[Controls]')).toBeVisible();
  await openAll(viewer);
  await expect(field(folderOf(viewer, 'Sonne'), '[name]')).toBeVisible();
  await described(viewer);
  const attribute = /^[a-z]+(-[a-z]+)*(: \[.*\])?$/s;
  const left = (await textsIn(viewer)).filter((text) => !isReplaced(text) && !attribute.test(text));
  // The page's own names, numbers and symbols.
  expect(left.filter((text) => !/^[-\d., e]+$/.test(text)).sort()).toEqual([
    'Sonne',
    'Szene',
    '↑',
    '↓',
  ]);
});

test('texts replaces every text of helpers, legend and probe', async ({ page, mount }) => {
  const viewer = await mount(
    `<phong-viewer alt="Szene" geometry="sphere" helpers="lights" view="n-dot-l" probe probe-at="0 0 0.5" phi="90" theta="0">
      <phong-light name="Sonne"></phong-light><phong-light position="1 2 3 1" cutoff="4" axis="0 -1 0"></phong-light></phong-viewer>`,
  );
  await assign(viewer, { texts: bracketed });
  await expect(viewer.locator('[part=probe]')).toContainText('[light 2]');
  await page.mouse.move(300, 200);
  await expect.poll(() => textsIn(viewer)).toContain('[Lights in the picture]');
  await described(viewer);
  const left = (await textsIn(viewer)).filter((text) => !isReplaced(text));
  // Without numbers, the names of vectors, the cross of the button "Unpin", and the mark of what is
  // left out.
  expect(left.filter((text) => !/^[-−≈\d., e+°]+$|^[NLVR]\b|^[×…]$/.test(text)).sort()).toEqual([
    'Sonne',
    'Szene',
  ]);
});

test('texts relabels an open panel without changing its state', async ({ page, mount }) => {
  const viewer = await mount(scene);
  const sun = await opened(viewer, 'Sonne');
  const second = await opened(viewer, 'light 2');
  await field(sun, 'cutoff').or(field(sun, 'position y')).first().focus();
  await listOf(viewer).evaluate((list) => (list.scrollTop = 60));
  const german = {
    position: 'Lage',
    '{row} y': '{row}: y',
    'light {number}': 'Licht {number}',
    '{name} active': '{name} an',
    space: 'Raum',
    world: 'Welt',
    camera: 'Kamera',
    Camera: 'Kameraordner',
    'add light': 'Licht hinzufügen',
  };
  await assign(viewer, { texts: german });
  await expect(titleOf(viewer, 'Licht 2')).toHaveAttribute('aria-expanded', 'true');
  await expect(viewer.getByRole('checkbox', { name: 'Licht 2 an' })).toBeVisible();
  await expect(row(sun, 'Lage')).toBeVisible();
  await expect(field(sun, 'Lage: y')).toBeFocused();
  expect(await listOf(viewer).evaluate((list) => list.scrollTop)).toBe(60);
  await expect(titleOf(viewer, 'Kameraordner')).toHaveAttribute('aria-expanded', 'true');
  await choice(sun, 'Raum').selectOption('Kamera');
  expect(await viewer.evaluate((element) => element.lights[0]!.space)).toBe('camera');
  await button(viewer, 'Licht hinzufügen').click();
  await expect(titleOf(viewer, 'Licht 4')).toBeFocused();
  await page.keyboard.press('F2');
  await expect(field(folderOf(viewer, 'Licht 4'), 'Lage: y')).toBeVisible();
  await assign(viewer, { texts: null });
  await expect(titleOf(viewer, 'light 4')).toBeVisible();
  await expect(field(sun, 'position y')).toBeVisible();
  await expect(second).toHaveCount(1);
  // The description follows a second later.
  const left = async () =>
    (await textsIn(viewer)).filter((text) => /Licht|Lage|Welt|Raum/.test(text));
  await expect.poll(left).toEqual([]);
});

test('texts replaces temporary labels of the panel’s buttons', async ({ page, mount }) => {
  await page.addInitScript(() =>
    Object.defineProperty(navigator, 'clipboard', { value: undefined }),
  );
  const viewer = await mount(scene);
  await assign(viewer, { texts: bracketed });
  await button(viewer, '[copy HTML]').click();
  await expect(button(viewer, '[select and copy below]')).toBeVisible();
  await expect(viewer.getByRole('textbox', { name: "[The scene's HTML]" })).toBeVisible();
  await assign(viewer, { texts: null });
  await expect(button(viewer, 'select and copy below')).toBeVisible();
  await expect(button(viewer, 'copy HTML')).toBeVisible();
  await button(viewer, 'copy HTML').click();
  await assign(viewer, { gui: false });
  await assign(viewer, { gui: true });
  await expect(button(viewer, 'copy HTML')).toBeVisible();
});

test('texts replaces announcements and messages; null restores them', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/404/);
  const viewer = await mount('<phong-viewer alt="Nichts" src="/none.glb"></phong-viewer>');
  const alert = viewer.getByRole('alert');
  const message = (await alert.locator('[part=notice]').textContent())!;
  await assign(viewer, { texts: { ...bracketed, 'load-failed': 'Nicht da: {url} ({message})' } });
  await expect(alert).toContainText(
    `Nicht da: ${new URL('/none.glb', page.url()).href} (${message})`,
  );
  await expect(alert.getByRole('button', { name: '[Try again]' })).toBeVisible();
  await viewer.focus();
  await page.keyboard.press('ArrowLeft');
  await expect(viewer.locator('[aria-live]')).toHaveText(/^\[Camera: azimuth \d+°/);
  await assign(viewer, { texts: null });
  await expect(alert.locator('[part=notice]')).toHaveText(message);
  await expect(alert.getByRole('button', { name: 'Try again', exact: true })).toBeVisible();
});
