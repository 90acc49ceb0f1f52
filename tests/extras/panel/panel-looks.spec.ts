// Is the panel legible and reachable in light and dark pages, as a sheet on phones, at 200 % zoom,
// with long words, from right to left?

import { axeOn } from '../../support/axe.js';
import type { Locator } from '@playwright/test';
import { firstOf } from '../../support/repeats.js';
import { expect, test } from '../../support/test.js';
import { field, listOf, opened, panelOf, titleOf } from './panel-rows.js';
import { assign, holdBack } from '../../element/support/viewer.js';
import { readyTexts, VIEWER_TEXTS } from '../../support/texts.js';

const scene = `<phong-viewer alt="A scene" geometry="box" gui
    theta="-15.9944" target="-15.9944 -15.9944 -15.9944">
  <phong-light name="lamp" position="-15.9944 -15.9944 -15.9944 1" cutoff="4" axis="-0.9944 -0.9944 -0.9944" attenuation="15.9944 15.9944 15.9944"></phong-light>
  <phong-mesh name="ball" geometry="sphere" position="-15.9944 -15.9944 -15.9944" rotation="-15.9944 -15.9944 -15.9944"></phong-mesh></phong-viewer>`;

/** Opens every folder, so that all rows are shown. */
async function openAll(viewer: Locator) {
  const folders = ['lamp', 'Camera', 'Shading', 'Show', 'Material', 'Meshes', 'ball'];
  for (const title of folders) {
    await opened(viewer, title);
  }
}

for (const [scheme, width, height] of [
  ['light', 900, 1800], // high enough for all rows
  ['dark', 900, 1800],
  ['light', 390, 800],
] as const) {
  test(`is legible in the page's scheme and has names (${scheme}, ${width} × ${height})`, async ({
    page,
    mount,
  }) => {
    await page.setViewportSize({ width, height });
    const viewer = await mount(`${scene}<main></main>`, { width, height: height - 10 });
    await page.evaluate((value) => {
      Object.assign(document.documentElement.style, { colorScheme: value, background: 'Canvas' });
    }, scheme);
    const brightness = (property: 'color' | 'backgroundColor') =>
      panelOf(viewer).evaluate((panel, key) => {
        const pixel = new OffscreenCanvas(1, 1).getContext('2d')!;
        pixel.fillStyle = getComputedStyle(panel)[key];
        pixel.fillRect(0, 0, 1, 1);
        return pixel.getImageData(0, 0, 1, 1).data[1]!;
      }, property);
    const [text, ground] = [await brightness('color'), await brightness('backgroundColor')];
    expect(scheme === 'light' ? ground - text : text - ground).toBeGreaterThan(200);
    if (width === 900) {
      await openAll(viewer);
    } else {
      await titleOf(viewer, 'Controls').click();
      await opened(viewer, 'lamp'); // axe takes labels that are scrolled out of view for missing ones
    }
    const { violations } = await axeOn(page)
      .include({ fromShadowDom: ['phong-viewer', '.panel'] })
      .analyze();
    expect(violations.map(({ id, nodes }) => [id, ...nodes.map(({ html }) => html)])).toEqual([]);
    await expectNothingCut(viewer);
  });
}

/** Texts and numbers fit into their boxes, and scrolling the panel shows each of them whole. */
async function expectNothingCut(viewer: Locator) {
  const cut = await listOf(viewer).evaluate((list) => {
    const found: string[] = [];
    const { left, right, top, bottom } = list.getBoundingClientRect();
    for (const element of list.querySelectorAll<HTMLElement>(
      '.lil-name, .lil-title, button, select, input',
    )) {
      if (!element.checkVisibility() || element.closest('.lil-display') !== null) continue;
      element.scrollIntoView({ block: 'nearest' });
      const box = element.getBoundingClientRect();
      const name = element.getAttribute('aria-label') ?? element.textContent;
      // Names that the user writes scroll in their fields.
      const isName = element instanceof HTMLInputElement && element.placeholder !== '';
      const tooWide =
        element.scrollWidth > element.clientWidth + 1 ||
        element.scrollHeight > element.clientHeight + 1;
      const isText =
        !element.matches('[type=checkbox], [type=range], [type=color], select') && !isName;
      if (isText && tooWide) {
        found.push(`cut: ${name}`);
      }
      if (
        box.left < left - 1 ||
        box.right > right + 1 ||
        box.top < top - 1 ||
        box.bottom > bottom + 1
      ) {
        found.push(`out of reach: ${name}`);
      }
    }
    return found;
  });
  expect(cut).toEqual([]);
}

const long = Object.fromEntries(VIEWER_TEXTS.map((text) => [text, `${text} Sonderbezeichnung`]));

for (const [width, height, of] of [
  [320, 256, '640 × 512'],
  [195, 350, '390 × 700'],
  [450, 310, '900 × 620'],
] as const) {
  test(`at 200 % zoom a viewer of ${of} cuts nothing, not even long words, in ltr or rtl`, async ({
    page,
    mount,
  }) => {
    await page.setViewportSize({ width, height });
    const viewer = await mount(scene, { width, height });
    await titleOf(viewer, 'Controls').click();
    await openAll(viewer);
    for (const texts of firstOf([long, null], 1)) {
      await assign(viewer, { texts });
      for (const dir of ['rtl', 'ltr']) {
        // The panel takes the page's direction when it is made.
        await viewer.evaluate((element, value) => {
          document.documentElement.dir = value;
          element.shadowRoot!.querySelector<HTMLElement>('.lil-root')!.dir = value;
        }, dir);
        await expectNothingCut(viewer);
      }
    }
  });
}

test('text of 16 and 24 pixels cuts nothing, in a column and as a sheet', async ({
  page,
  mount,
}) => {
  await page.setViewportSize({ width: 1280, height: 800 });
  const css = 'phong-viewer { font-size: 24px }';
  const viewer = await mount(scene, { width: 1280, height: 800, css });
  await openAll(viewer);
  const arrow = await titleOf(viewer, 'Controls').evaluate(
    (title) => getComputedStyle(title, '::before').width,
  );
  expect(parseFloat(arrow), 'signs grow with the text').toBeGreaterThan(15);
  for (const texts of [null, readyTexts('de')]) {
    await assign(viewer, { texts });
    for (const css of [
      'width: 1280px',
      'width: 390px',
      'font-size: 16px',
      'width: 390px; font-size: 16px',
    ]) {
      await viewer.evaluate((element, style) => (element.style.cssText = style), css);
      await expectNothingCut(viewer);
      expect(await cutChoices(viewer), css).toEqual([]);
    }
  }
});

/** Selects that are too narrow for their present choice. Only its width as text tells. */
const cutChoices = (viewer: Locator) =>
  listOf(viewer).evaluate((list) =>
    [...list.querySelectorAll('select')]
      .filter((select) => select.checkVisibility())
      .flatMap((select) => {
        const { font, paddingLeft, paddingRight } = getComputedStyle(select);
        const context = new OffscreenCanvas(1, 1).getContext('2d')!;
        context.font = font;
        const text = select.selectedOptions[0]?.text ?? '';
        const room = select.clientWidth - parseFloat(paddingLeft) - parseFloat(paddingRight);
        return context.measureText(text).width > room + 1 ? [text] : [];
      }),
  );

test('in rtl the picture stands to the right of the panel, and numbers keep their order', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene, { width: 900, height: 600 });
  await page.evaluate(() => {
    document.documentElement.dir = 'rtl';
  });
  await assign(viewer, { gui: false });
  await assign(viewer, { gui: true });
  const lamp = await opened(viewer, 'lamp');
  const panel = (await panelOf(viewer).boundingBox())!;
  const picture = (await viewer.locator('[part=surface]').boundingBox())!;
  const whole = (await viewer.boundingBox())!;
  expect(panel.x).toBeLessThan(whole.x + 20);
  expect(picture.x).toBeGreaterThanOrEqual(panel.x + panel.width);
  expect(picture.x + picture.width).toBeCloseTo(whole.x + whole.width, 0);
  for (const name of ['position x', 'cutoff', 'diffuse']) {
    await expect(field(lamp, name)).toHaveCSS('direction', 'ltr');
  }
  await expect(field(lamp, 'name')).toHaveCSS('direction', 'rtl');
  // The eye: x left of y left of z.
  const places = await viewer
    .locator('.readout .lil-widget')
    .first()
    .evaluate((widget) => {
      const text = document.createTreeWalker(widget, NodeFilter.SHOW_TEXT).nextNode() as Text;
      return Array.from(text.data.matchAll(/[\d.]+/g), ({ index, 0: digits }) => {
        const range = document.createRange();
        range.setStart(text, index);
        range.setEnd(text, index + digits.length);
        return range.getBoundingClientRect().x;
      });
    });
  expect(places).toHaveLength(3);
  expect(places).toEqual([...places].sort((a, b) => a - b));
  await expectNothingCut(viewer);
});

test('the picture leaves the panel its place before its code is there, and is drawn once', async ({
  page,
  mount,
}) => {
  const send = await holdBack(page, /\/panel[-.]/);
  const viewer = (kind: string) =>
    `<phong-viewer class="${kind}" alt="${kind}" geometry="box" gui></phong-viewer>`;
  const compared = `<phong-compare>${viewer('split')}<phong-viewer alt="B" geometry="box"></phong-viewer></phong-compare>`;
  await mount(viewer('wide') + viewer('small') + viewer('phone') + compared, {
    css: `.wide, phong-compare { width: 900px !important; height: 100px !important }
      .small { width: 300px !important; height: 100px !important }
      .phone { width: 400px !important; height: 430px !important; font-size: 8px }`,
  });
  const pictures = () =>
    page.evaluate(() =>
      [...document.querySelectorAll('phong-viewer')].map(({ shadowRoot, stats }) => {
        const { clientWidth, clientHeight } = shadowRoot!.querySelector('.holder')!;
        return [Math.round(clientWidth), Math.round(clientHeight), stats.frames];
      }),
    );
  const wide = [594, 100, 1];
  const expected = [wide, [300, 100, 1], [400, 215, 1], wide, wide];
  expect(await pictures()).toEqual(expected);
  send();
  await expect(page.locator('.lil-root')).toHaveCount(4);
  expect(await pictures()).toEqual(expected);
});
