// Does everything over the picture keep to the room that is free: between dividers, beside the
// panel, below a notice, at any text size?

import type { Locator, Page } from '@playwright/test';
import { decodePng, pixelAt } from '../../support/picture.js';
import { firstOf } from '../../support/repeats.js';
import { type ViewerLocator, allReady, expect, type Mount, test } from '../../support/test.js';
import { field, opened, panelOf, titleOf } from '../panel/panel-rows.js';
import { assign, cameraOf, drag, nextFrame } from '../../element/support/viewer.js';

const LIGHTS = `
  <phong-light name="sun" position="-1 1.4 1.2 0" ambient="120" diffuse="190" specular="150"></phong-light>
  <phong-light name="a lamp with a long name" position="0.9 0.5 0.6 1" ambient="101" diffuse="#d98c46" attenuation="1 0.2 0.6"></phong-light>
  <phong-light name="back" position="-1 -1 -2 0" ambient="111"></phong-light>`;

const ball = (attributes: string) =>
  `<phong-viewer alt="" geometry="sphere" segments="8" theta="0" phi="90" ${attributes}>${LIGHTS}</phong-viewer>`;

interface Rect {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

const rectOf = (target: Locator): Promise<Rect> =>
  target.evaluate((element) => {
    const { left, top, right, bottom } = element.getBoundingClientRect();
    return { left, top, right, bottom };
  });

const meet = (a: Rect, b: Rect) =>
  a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

/** For release runs. */
const EACH_WIDTH = Array.from({ length: 87 }, (_, i) => 140 + 10 * i);

/** Two frames: layout is observed in the first, and followed in the second. */
async function laidOut(page: Page) {
  await nextFrame(page);
  await nextFrame(page);
}

const setWidth = (viewer: ViewerLocator, width: number) =>
  viewer.evaluate((element, w) => (element.style.width = `${w}px`), width);

test.describe('the probe between the dividers of a comparison', () => {
  const comparison = `<phong-compare labels="left, right">${ball('probe probe-at="0 0 0.5"').repeat(2)}</phong-compare>`;
  const css = 'phong-compare { display: block; height: 420px }';

  /** The texts of sums that are not wholly in the part of the picture that the dividers leave. */
  const cutSums = (page: Page) =>
    page.evaluate(() => {
      const compare = document.querySelector('phong-compare')!;
      const { left, width } = compare.getBoundingClientRect();
      const place = left + (width * Number((compare.at as readonly number[])[0])) / 100;
      return Array.from(compare.querySelectorAll('phong-viewer'), (viewer, i) => {
        const [from, to] = i === 0 ? [left, place] : [place, left + width];
        const box = viewer.shadowRoot!.querySelector('[part=probe]')!;
        if (!box.checkVisibility()) return to - from < 50 ? [] : [`no box at ${to - from}`];
        const texts = [...box.querySelectorAll('.codes, tr > :last-child')];
        const isCut = (text: Element) => {
          const range = document.createRange();
          range.selectNodeContents(text);
          const rect = range.getBoundingClientRect();
          return rect.left < from || rect.right > to;
        };
        const cut = texts.filter((text) => text.checkVisibility() && isCut(text));
        const isSmall = box.scrollWidth > box.clientWidth || box.scrollHeight > box.clientHeight;
        return [
          ...cut.map((text) => text.textContent),
          ...(isSmall ? ['a box that is too small'] : []),
        ].map((text) => `${i} at ${to - from}: ${text}`);
      }).flat();
    });

  test('never cuts a sum, whatever the width and the place of the divider', async ({
    page,
    mount,
  }) => {
    test.setTimeout(600_000);
    await mount(comparison, { css, waitForReady: false });
    await expect(page.locator('[part=probe]').filter({ visible: true })).toHaveCount(2);
    const cut: string[] = [];
    for (const width of firstOf([140, 266, 390, 532, 800, 1000, ...EACH_WIDTH], 6)) {
      for (const at of firstOf(
        [12, 37, 50, 85, ...Array.from({ length: 21 }, (_, i) => 5 * i)],
        4,
      )) {
        await page.evaluate(
          ([w, a]) => {
            const compare = document.querySelector('phong-compare')!;
            compare.style.width = `${w}px`;
            compare.at = a;
          },
          [width, at] as const,
        );
        await laidOut(page);
        cut.push(...(await cutSums(page)).map((text) => `${width}, ${at} %: ${text}`));
      }
    }
    expect(cut).toEqual([]);
  });

  test('leaves out columns in their order, and at last all but the colour', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(ball('probe probe-at="0 0 0.5"'), { height: 500 });
    const columns = viewer.locator('[part=probe] thead th').filter({ visible: true });
    const seen: string[] = [];
    for (const width of [700, 480, 420, 360, 300, 260, 200, 180]) {
      await setWidth(viewer, width);
      await laidOut(page);
      const texts = await columns.allTextContents();
      seen.push(texts.slice(1, -1).join(' '));
    }
    const all = 'ambient diffuse specular att decay';
    const fewer = [
      'ambient diffuse specular att',
      'ambient diffuse specular',
      '… diffuse specular',
    ];
    const order = [all, ...fewer, '… diffuse', '…'];
    expect([...new Set(seen)]).toEqual(order.filter((each) => seen.includes(each)));
    expect(seen[0]).toBe(all);
    expect(seen).toContain('…');
    await setWidth(viewer, 90);
    await laidOut(page);
    await expect(viewer.locator('[part=probe] .codes')).toBeVisible();
    await expect(viewer.locator('[part=probe] table')).toBeHidden();
  });
});

/** The names that a box covers, and the boxes that cover each other or leave the picture. */
const clashes = (viewer: ViewerLocator) =>
  viewer.evaluate((element) => {
    const root = element.shadowRoot!;
    const whole = element.getBoundingClientRect();
    const boxes = [...root.querySelectorAll('.legend, .box')]
      .filter((box) => box.checkVisibility())
      .map((box) => [box.className, box.getBoundingClientRect()] as const);
    const names = Array.from(
      root.querySelectorAll('.helpers text'),
      (name) => [name.textContent, name.getBoundingClientRect()] as const,
    );
    const all = [...boxes, ...names];
    return all.flatMap(([what, a], i) => [
      ...all
        .slice(i + 1)
        .filter(
          ([, b]) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom,
        )
        .map(([other]) => `${what} and ${other}`),
      ...(a.left < whole.left ||
      a.right > whole.right ||
      a.top < whole.top ||
      a.bottom > whole.bottom
        ? [`${what} leaves the picture`]
        : []),
    ]);
  });

test('names of lights and axes keep clear of legend and probe at any width', async ({
  page,
  mount,
}) => {
  test.setTimeout(600_000);
  const extras = 'view="n-dot-l" probe probe-at="0 0 0.5" helpers="lights axes"';
  const viewer = await mount(ball(extras), { height: 400 });
  const found: string[] = [];
  const names: number[] = [];
  for (const view of ['n-dot-l', 'shaded'] as const) {
    await assign(viewer, { view });
    for (const width of firstOf(
      [140, 259, 260, 479, 480, 1000, 210, 340, 560, 640, 800, ...EACH_WIDTH],
      6,
    )) {
      await setWidth(viewer, width);
      await laidOut(page);
      await nextFrame(page);
      found.push(...(await clashes(viewer)).map((text) => `${view}, ${width}: ${text}`));
      names.push(await viewer.locator('.helpers text').count());
    }
  }
  expect(found).toEqual([]);
  expect(Math.max(...names), 'where there is room').toBeGreaterThan(4);
});

test('the lines of helpers lie below the box of the probe and the legend', async ({
  page,
  mount,
}) => {
  const viewer = await mount(ball('view="n-dot-l" probe probe-at="0 0 0.5" helpers="grid axes"'));
  await laidOut(page);
  const order = await viewer.evaluate((element) => {
    const root = element.shadowRoot!;
    const heights = ['.helpers', '.probe', '.room'].map((part) =>
      Number(getComputedStyle(root.querySelector(part)!).zIndex.replace('auto', '0')),
    );
    const inRoom = ['[part=probe]', '[part=legend]'].map((part) =>
      root.querySelector(part)!.closest('.room'),
    );
    return { heights, inRoom: inRoom.every((room) => room !== null) };
  });
  expect(order).toEqual({ heights: [0, 1, 2], inRoom: true });
});

test('a notice keeps clear of the panel, and has a border in forced colours', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/404/);
  const viewer = await mount(
    '<phong-viewer alt="" gui src="/none.glb" view="n-dot-l"></phong-viewer>',
  );
  const notice = viewer.locator('[part=notice]');
  await expect(notice).toBeVisible();
  await expect(viewer.locator('.legend')).toHaveCount(1);
  for (const dir of ['ltr', 'rtl']) {
    for (const width of [300, 520, 640, 900]) {
      await page.evaluate((value) => (document.documentElement.dir = value), dir);
      await setWidth(viewer, width);
      for (const open of [width >= 480, false]) {
        const title = titleOf(viewer, 'Controls');
        if ((await title.getAttribute('aria-expanded')) !== String(open)) {
          await title.click();
        }
        await laidOut(page);
        const rects = await Promise.all(
          [notice, panelOf(viewer), viewer.locator('.legend')].map(rectOf),
        );
        const [message, panel, legend] = rects as [Rect, Rect, Rect];
        const met = [meet(message, panel), meet(message, legend), meet(legend, panel)];
        expect(met, `${dir}, ${width}, ${open}`).toEqual([false, false, false]);
      }
    }
  }
  await page.emulateMedia({ forcedColors: 'active' });
  await expect(notice).toHaveCSS('border-top-width', '1px');
});

test.describe('text over the picture', () => {
  const sizes = (viewer: ViewerLocator) =>
    viewer.evaluate((element) =>
      ['[part=legend]', '[part=probe]', 'text[part=light-name]', '.lil-root'].map(
        (part) => getComputedStyle(element.shadowRoot!.querySelector(part)!).fontSize,
      ),
    );

  test("follows the element's font size; slotted text keeps its own", async ({
    page,
    mount,
    consoleGuard,
  }) => {
    consoleGuard.allow(/404/);
    const markup = ball('gui view="n-dot-l" probe probe-at="0 0 0.5" helpers');
    const failing =
      '<phong-viewer alt="" src="/none.glb"><p slot="error">Nothing</p></phong-viewer>';
    const viewer = await mount(markup + failing, {
      width: 900,
      height: 700,
      css: 'body { font-size: 20px } .named::part(light-name) { font-size: 30px }',
    });
    await expect(viewer.locator('text[part=light-name]')).not.toHaveCount(0);
    expect(await sizes(viewer)).toEqual(Array(4).fill('12px'));
    await viewer.evaluate((element) => (element.style.fontSize = '24px'));
    await laidOut(page);
    expect(await sizes(viewer)).toEqual(Array(4).fill('24px'));
    const slotted = page.locator('[slot=error]');
    await expect(slotted).toHaveCSS('font-size', '20px');
    await page
      .locator('phong-viewer')
      .last()
      .evaluate((element) => (element.style.fontSize = '40px'));
    await expect(slotted).toHaveCSS('font-size', '20px');
    await viewer.evaluate((element) => element.classList.add('named'));
    await expect(viewer.locator('text[part=light-name]').first()).toHaveCSS('font-size', '30px');
  });

  test('grows with the height in full screen, unless the page sets a size', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(ball('view="n-dot-l"'));
    const legend = viewer.locator('.legend');
    await page.keyboard.press('Tab'); // full screen needs a user's gesture
    await viewer.evaluate((element) => element.requestFullscreen());
    const expected = await page.evaluate(
      () => `${Math.max(12, Math.round(2200 * innerHeight) / 1e5)}px`,
    );
    await expect(legend).toHaveCSS('font-size', expected);
    await viewer.evaluate((element) => (element.style.fontSize = '31px'));
    await expect(legend).toHaveCSS('font-size', '31px');
    await page.evaluate(() => document.exitFullscreen());
  });

  test("a comparison's size is that of its labels and viewers", async ({ page, mount }) => {
    const markup = `<phong-compare labels="a, b">${ball('view="n-dot-l"').repeat(2)}</phong-compare>`;
    await mount(markup, { css: 'phong-compare { font-size: 18px }', waitForReady: false });
    await allReady(page);
    await expect(page.locator('phong-compare .label').first()).toHaveCSS('font-size', '18px');
    await expect(page.locator('phong-viewer .legend').first()).toHaveCSS('font-size', '18px');
  });
});

test.describe('an open panel', () => {
  const picture = (viewer: ViewerLocator) => rectOf(viewer.locator('[part=surface]'));

  async function withPanel(page: Page, mount: Mount, width: number): Promise<Locator> {
    const viewer = await mount(ball('gui'), { width });
    await expect(panelOf(viewer)).toBeVisible();
    await laidOut(page);
    return viewer;
  }

  test('stands beside the picture from 640 pixels on, and over it below', async ({
    page,
    mount,
  }) => {
    const viewer = await withPanel(page, mount, 640);
    expect(meet(await picture(viewer), await rectOf(panelOf(viewer)))).toBe(false);
    const beside = (await cameraOf(viewer)).radius;
    expect((await picture(viewer)).right).toBeGreaterThan(320);
    await viewer.evaluate((element) => (element.style.fontSize = '24px'));
    await laidOut(page);
    expect((await picture(viewer)).right, 'half of the width where text is large').toBe(320);
    await viewer.evaluate((element) => (element.style.fontSize = ''));
    await setWidth(viewer, 639);
    await laidOut(page);
    expect((await picture(viewer)).right).toBe(639);
    expect((await cameraOf(viewer)).radius, 'framed by the width of the picture').toBeLessThan(
      beside,
    );
    await titleOf(viewer, 'Controls').click();
    await expect(viewer.locator('.lil-root > .lil-children')).toBeHidden();
  });

  test('is not printed beside the picture; a drag across the picture is 360 degrees', async ({
    page,
    mount,
  }) => {
    const viewer = await withPanel(page, mount, 900);
    const screen = await picture(viewer);
    const before = (await cameraOf(viewer)).theta;
    await drag(page, [20, 200], [screen.right / 4, 0]);
    expect((await cameraOf(viewer)).theta).toBeCloseTo(before - 90, 0);
    await page.emulateMedia({ media: 'print' });
    await expect(panelOf(viewer)).toBeHidden();
    const paper = await picture(viewer);
    expect(paper.right - paper.left).toBeCloseTo(screen.right - screen.left, 0);
    expect(paper.left + paper.right, 'in the middle').toBeCloseTo(900, 0);
  });

  test('has room for `140 140 140` in fields of colours', async ({ mount }) => {
    const viewer = await mount(ball('gui'), { width: 700, height: 600 });
    await assign(viewer.locator('phong-light').first(), { diffuse: [140, 140, 140] });
    const diffuse = field(await opened(viewer, 'sun'), 'diffuse');
    await expect(diffuse).toHaveValue('140 140 140');
    expect(
      await diffuse.evaluate((input) => input.scrollWidth - input.clientWidth),
    ).toBeLessThanOrEqual(0);
  });
});

test.describe('a legend', () => {
  test('has one line in pictures below 260 pixels, or two where its scale or its lights need them, and fits', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(ball('view="n-dot-l"'), { width: 260, height: 200 });
    const legend = viewer.locator('.legend');
    const height = async () => {
      await laidOut(page);
      const { top, bottom } = await rectOf(legend);
      return bottom - top;
    };
    expect(await height()).toBeGreaterThan(40);
    for (const view of ['n-dot-l', 'normals', 'diffuse'] as const) {
      for (const width of [259, 180, 140]) {
        await assign(viewer, { view });
        await setWidth(viewer, width);
        const lines = width < { 'n-dot-l': 0, normals: 200, diffuse: 150 }[view] ? 2 : 1;
        expect(Math.round((await height()) / 20), `${view}, ${width}`).toBe(lines);
        expect((await rectOf(legend)).right, `${view}, ${width}`).toBeLessThanOrEqual(width);
        const cut = await legend.evaluate((element) => element.scrollWidth - element.clientWidth);
        expect(cut, `${view}, ${width}`).toBeLessThanOrEqual(0);
      }
    }
  });

  test('is beside a picture whose white plane has an outline on white, not in files', async ({
    page,
    mount,
  }) => {
    const plane = `<phong-viewer alt="" geometry="plane" phi="0" radius="3" view="attenuation"><phong-light position="0 1 0 1"></phong-light></phong-viewer>`;
    const viewer = await mount(plane, {
      width: 200,
      height: 200,
      css: 'body { background: #fff }',
    });
    await expect(viewer.locator('.legend')).toHaveCount(1);
    await nextFrame(page);
    const screen = decodePng(await viewer.screenshot());
    // Up from the middle: away from the legend.
    const column = Array.from({ length: 100 }, (_, y) => pixelAt(screen, 100, y)[0]);
    expect(Math.min(...column)).toBeLessThan(180);
    await assign(viewer, { view: 'normals' });
    await nextFrame(page);
    await assign(viewer, { view: 'attenuation' });
    const codes = await viewer.evaluate(async (element) => {
      const blob = await element.toBlob({ width: 50, height: 50, type: 'image/jpeg' });
      const context = new OffscreenCanvas(50, 50).getContext('2d')!;
      context.drawImage(await createImageBitmap(blob), 0, 0);
      return [...context.getImageData(25, 0, 1, 25).data];
    });
    expect(Math.min(...codes)).toBeGreaterThan(240);
  });
});
