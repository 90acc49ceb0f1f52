// Does <phong-compare> show its viewers split or side by side, and can its dividers be moved by
// mouse, finger and keys? A comparison is 400 × 200 CSS pixels at the page's top left, unless a
// test says otherwise.

import type { Locator, Page } from '@playwright/test';
import type { PhongCompare } from '../../../src/viewer/index.js';
import { decodePng, type Picture, pixelAt } from '../../support/picture.js';
import {
  type ViewerLocator,
  allReady,
  expect,
  strictPolicy,
  test,
  type Mount,
} from '../../support/test.js';
import { countEverything, countsOf } from '../../element/support/counting.js';
import { opened, panelOf, titleOf } from '../panel/panel-rows.js';
import {
  assign,
  cameraOf,
  drag,
  Fingers,
  nextFrame,
  type PhongViewer,
  record,
  settled,
} from '../../element/support/viewer.js';

const light = '<phong-light position="1 2 3 0" ambient="40" diffuse="180"></phong-light>';
const sphere = (attributes: string) =>
  `<phong-viewer geometry="sphere" segments="12" ${attributes}>${light}</phong-viewer>`;
const two = sphere('shading="gouraud" alt="Gouraud"') + sphere('alt="Phong"');
const comparison = (attributes = '', inner = two) =>
  `<phong-compare ${attributes}>${inner}</phong-compare>`;

const css = 'phong-compare { display: block; width: 400px; height: 200px } main { display: block }';

/** Mounts a page with a comparison. Resolves when its viewers have drawn. */
async function compared(page: Page, mount: Mount, markup: string, more = '') {
  await mount(markup, { css: css + more, waitForReady: false });
  const compare = page.locator('phong-compare').first();
  await expect(compare.locator('.box')).toBeAttached();
  await allReady(page);
  await nextFrame(page);
  return compare;
}

const dividers = (compare: Locator) => compare.getByRole('separator', { includeHidden: true });

const placeOf = (divider: Locator) =>
  divider.evaluate((element) => Number(element.getAttribute('aria-valuenow')));

const at = (compare: Locator) => compare.evaluate((element: PhongCompare) => element.at);

test('two viewers fill the comparison, with a divider in the middle and labels by their names', async ({
  page,
  mount,
}) => {
  const compare = await compared(page, mount, comparison());
  await expect(dividers(compare)).toHaveCount(1);
  expect(await placeOf(dividers(compare))).toBe(50);
  const whole = { x: 0, y: 0, width: 400, height: 200 };
  for (const viewer of await page.locator('phong-viewer').all()) {
    expect(await viewer.boundingBox()).toEqual(whole);
  }
  const { x, width } = (await dividers(compare).boundingBox())!;
  expect(x + width / 2).toBe(200);
  expect(width).toBeGreaterThanOrEqual(24);
  const texts = () => compare.locator('.label:visible').allTextContents();
  expect(await texts()).toEqual(['Gouraud', 'Phong']);
  await assign(page.locator('phong-viewer').first(), { alt: 'Per vertex' });
  await expect.poll(texts).toEqual(['Per vertex', 'Phong']);
  await expect(dividers(compare)).toHaveAccessibleName('Divider between Per vertex and Phong');
  await compare.evaluate((element) => element.setAttribute('labels', 'left, right'));
  expect(await texts()).toEqual(['left', 'right']);
  await assign(compare, { labels: ['a list', 'of texts'] });
  expect(await texts()).toEqual(['a list', 'of texts']);
  await assign(compare, { labels: '' });
  expect(await texts()).toEqual([]);
});

test('a divider stays while the comparison is hidden, and is let go when the window blurs', async ({
  page,
  mount,
}) => {
  const compare = await compared(page, mount, comparison('at="40"'));
  const pull = (type: string, clientX: number) =>
    dividers(compare).dispatchEvent(type, {
      pointerId: 7,
      clientX,
      clientY: 20,
      buttons: 1,
      isPrimary: true,
    });
  const show = (display: string): Promise<void> =>
    compare.evaluate((element, value) => void (element.style.display = value), display);
  await pull('pointerdown', 160);
  await show('none');
  await pull('pointermove', 200);
  expect(await at(compare)).toEqual([40]);
  await show('');
  await pull('pointermove', 200);
  expect(await at(compare)).toEqual([50]);
  await page.evaluate(() => dispatchEvent(new Event('blur')));
  await pull('pointermove', 240);
  expect(await at(compare)).toEqual([50]);
});

test('a divider follows pointer and finger from the press, and updates its value', async ({
  page,
  mount,
}) => {
  const compare = await compared(page, mount, comparison('at="40"'));
  const heard = await record(compare, 'divider-change');
  await drag(page, [165, 20], [-60, 30], { steps: 2 });
  expect(await heard.take()).toEqual([
    { type: 'divider-change', detail: { at: [32.5] } },
    { type: 'divider-change', detail: { at: [25] } },
  ]);
  expect(await placeOf(dividers(compare))).toBe(25);
  expect(await compare.getAttribute('at')).toBe('40');
  await page.mouse.move(300, 100);
  expect(await at(compare)).toEqual([25]);
  const fingers = await Fingers.on(page);
  await fingers.down([103, 100]);
  await fingers.move([123, 100]);
  await fingers.move([143, 100]);
  await fingers.up();
  expect(await at(compare)).toEqual([35]);
  // A drag past the edge ends there.
  await drag(page, [140, 100], [900, 0]);
  expect(await at(compare)).toEqual([100]);
  const { x, width } = (await dividers(compare).boundingBox())!;
  expect(x + width).toBe(400);
});

test('a divider returns by Escape during a drag, and by a double click to its start', async ({
  page,
  mount,
}) => {
  const compare = await compared(page, mount, comparison('at="40"'));
  await drag(page, [160, 20], [100, 0], { release: false });
  expect(await at(compare)).toEqual([65]);
  await page.keyboard.press('Escape');
  expect(await at(compare)).toEqual([40]);
  await page.mouse.move(300, 20);
  await page.mouse.up();
  expect(await at(compare)).toEqual([40]);
  await page.keyboard.press('End');
  const heard = await record(compare, 'divider-change');
  await page.mouse.dblclick(395, 60);
  expect(await at(compare)).toEqual([40]);
  expect(await heard.take()).toEqual([{ type: 'divider-change', detail: { at: [40] } }]);
});

test('a divider moves up and down if vertical, and with mirrored arrow keys in rtl', async ({
  page,
  mount,
}) => {
  const vertical = await compared(page, mount, comparison('direction="vertical"'));
  await expect(dividers(vertical)).toHaveAttribute('aria-orientation', 'horizontal');
  await drag(page, [300, 100], [50, 40]);
  expect(await at(vertical)).toEqual([70]);
  await page.keyboard.press('ArrowUp');
  expect(await at(vertical)).toEqual([69]);

  const compare = await compared(page, mount, `<main dir="rtl">${comparison('at="25"')}</main>`);
  const right = (await compare.boundingBox())!.x + 400;
  const { x, width } = (await dividers(compare).boundingBox())!;
  expect(right - x - width / 2).toBe(100);
  await drag(page, [right - 100, 50], [-100, 0]);
  expect(await at(compare)).toEqual([50]);
  await page.keyboard.press('ArrowRight');
  expect(await at(compare)).toEqual([49]);
});

test('both halves of a split show exactly what each viewer alone shows there', async ({
  page,
  mount,
}) => {
  const views = [
    sphere('shading="gouraud" alt="Gouraud" theta="20"'),
    sphere('reflection="blinn-phong" alt="Blinn-Phong" theta="20"'),
  ];
  const bare =
    'phong-compare::part(line), phong-compare::part(divider), phong-compare::part(label) { display: none }';
  const shot = async () =>
    decodePng(await page.screenshot({ clip: { x: 0, y: 0, width: 400, height: 200 } }));
  await compared(page, mount, comparison('at="45"', views.join('')), bare);
  const split = await shot();
  const alone: Picture[] = [];
  for (const view of views) {
    await mount(view, { width: 400, height: 200 });
    await nextFrame(page);
    alone.push(await shot());
  }
  const different = Array.from(split.data.keys()).filter((i) => {
    const side = (i >> 2) % 400 < 180 ? 0 : 1;
    return split.data[i] !== alone[side]!.data[i];
  });
  expect(different.slice(0, 5)).toEqual([]);
  expect(pixelAt(alone[0]!, 180, 90)).not.toEqual(pixelAt(alone[1]!, 180, 90));
});

test('a drag on either picture turns both, unless a viewer has a camera group of its own', async ({
  page,
  mount,
}) => {
  await compared(page, mount, comparison('', two + sphere('alt="Other" camera-group="other"')));
  const viewers = await page.locator('phong-viewer').all();
  const before = await cameraOf(viewers[2]!);
  await drag(page, [60, 100], [20, 10]);
  const [first, second, other] = await Promise.all(viewers.map(cameraOf));
  expect(first!.theta).not.toBe(before.theta);
  expect(second).toEqual(first);
  expect(other).toEqual(before);
  await drag(page, [200, 100], [20, 10]);
  expect(await cameraOf(viewers[0]!)).toEqual(await cameraOf(viewers[1]!));
  expect(await cameraOf(viewers[0]!)).not.toEqual(first);
});

test('two fingers on both sides of a divider are one pinch', async ({ page, mount }) => {
  await compared(page, mount, comparison());
  const viewers = await page.locator('phong-viewer').all();
  const before = await cameraOf(viewers[0]!);
  const fingers = await Fingers.on(page);
  await fingers.down([150, 100]);
  await fingers.down([150, 100], [250, 100]);
  await fingers.move([125, 100], [275, 100]);
  await fingers.move([100, 100], [300, 100]);
  const after = await cameraOf(viewers[1]!);
  expect(after.theta).toBe(before.theta);
  expect(after.radius).toBeCloseTo(before.radius / 2, 6);
  expect(await cameraOf(viewers[0]!)).toEqual(after);
  await fingers.up();
  // Each finger alone turns both.
  await fingers.down([300, 100]);
  await fingers.move([340, 100]);
  await fingers.up();
  expect((await cameraOf(viewers[0]!)).theta).toBeLessThan(before.theta);
});

test('a move draws each viewer once, except those that the divider hides', async ({
  page,
  mount,
}) => {
  const compare = await compared(page, mount, comparison());
  const first = page.locator('phong-viewer').first();
  const frames = () =>
    page.evaluate(() =>
      Array.from(document.querySelectorAll('phong-viewer'), (viewer) => viewer.stats.frames),
    );
  const moved = async () => {
    const before = await frames();
    for (let i = 0; i < 5; i++) {
      await first.evaluate((element: PhongViewer) => (element.phi += 1));
      await nextFrame(page);
    }
    return (await frames()).map((count, i) => count - before[i]!);
  };
  expect(await moved()).toEqual([5, 5]);
  await assign(compare, { at: 0 });
  await nextFrame(page);
  expect(await moved()).toEqual([0, 5]);
  await assign(compare, { at: 20 });
  await settled(first);
  await nextFrame(page);
  expect(await cameraOf(first)).toEqual(await cameraOf(page.locator('phong-viewer').nth(1)));
});

test('side by side, each viewer has a share of the width, and rows where that is narrow', async ({
  page,
  mount,
}) => {
  const compare = await compared(page, mount, comparison('layout="side"', two + two));
  await expect(dividers(compare)).toHaveCount(0);
  const viewers = await page.locator('phong-viewer').all();
  const boxes = () => Promise.all(viewers.map((viewer) => viewer.boundingBox()));
  expect(new Set((await boxes()).map((box) => box!.y)).size).toBe(2);
  await page.setViewportSize({ width: 1000, height: 700 });
  await compare.evaluate((element) => (element.style.width = '800px'));
  expect((await boxes()).map((box) => [box!.y, Math.round(box!.width)])).toEqual(
    Array.from({ length: 4 }, () => [0, 199]),
  );
  await assign(compare, { direction: 'vertical' });
  expect(new Set((await boxes()).map((box) => box!.y)).size).toBe(4);
  await assign(compare, { layout: 'split', direction: null });
  await expect(dividers(compare)).toHaveCount(3);
});

test('viewers can be added and removed, and the comparison can move on its page', async ({
  page,
  mount,
}) => {
  const compare = await compared(page, mount, `<main></main>${comparison('at="30"', '')}`);
  await expect(dividers(compare)).toHaveCount(0);
  const add = () =>
    compare.evaluate((element) => {
      const viewer = Object.assign(document.createElement('phong-viewer'), {
        geometry: 'box',
        alt: 'A box',
      });
      element.append('text', viewer, document.createElement('p'));
      return viewer.ready;
    });
  await add();
  await expect(dividers(compare)).toHaveCount(0);
  await add();
  await add();
  await expect(dividers(compare)).toHaveCount(2);
  await compare.evaluate((element) => {
    element.firstElementChild?.remove();
    document.querySelector('main')?.append(element);
  });
  await expect(dividers(compare)).toHaveCount(1);
  await allReady(page);
  await drag(page, [120, 100], [40, 0]);
  expect(await at(compare)).toEqual([40]);
});

test('toHTML gives the comparison as it is now', async ({ page, mount }) => {
  const compare = await compared(page, mount, comparison('id="pair" labels="A &quot;, B"'));
  await drag(page, [200, 100], [40, 0]);
  await drag(page, [60, 100], [20, 10]);
  const html = await compare.evaluate((element: PhongCompare) => element.toHTML());
  expect(html).toMatch(
    /^<phong-compare id="pair" at="60" labels="A &#34;, B">\n {2}<phong-viewer /,
  );
  await page.evaluate((text) => (document.body.innerHTML = text), html);
  await expect(page.getByRole('separator')).toHaveAttribute('aria-valuenow', '60');
  await allReady(page);
  expect(await compare.evaluate((element: PhongCompare) => element.toHTML())).toBe(html);
});

test('without its code, the viewers are shown in a row, with a warning', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/error: Failed to load resource/);
  consoleGuard.allow(
    /warning: <phong-viewer>: The code of <phong-compare> could not be fetched/,
    1,
  );
  await page.route(/\/comparison\./, (route) => route.abort());
  const failed = page.waitForEvent('console', (message) =>
    message.text().includes('<phong-compare>'),
  );
  await mount(comparison(), { width: 150, height: 100, css, waitForReady: false });
  await failed;
  const second = page.locator('phong-viewer').nth(1);
  expect(await second.boundingBox()).toMatchObject({ width: 150, height: 100 });
  await page.unroute(/\/comparison\./);
  await page.evaluate(() => document.body.append(document.querySelector('phong-compare')!));
  await expect(page.getByRole('separator')).toBeAttached();
});

test("works where the page allows only Lit's Trusted Types policy, and in a shadow tree", async ({
  page,
  mount,
}) => {
  const csp = `${strictPolicy}; require-trusted-types-for 'script'; trusted-types lit-html`;
  await mount('<main></main>', { csp });
  await page.evaluate(() => {
    const compare = Object.assign(document.createElement('phong-compare'), { at: 25 });
    for (const alt of ['A', 'B']) {
      compare.append(
        Object.assign(document.createElement('phong-viewer'), { geometry: 'box', alt }),
      );
    }
    document.querySelector('main')?.attachShadow({ mode: 'open' }).append(compare);
  });
  const divider = page.getByRole('separator');
  await expect(divider).toHaveAccessibleName('Divider between A and B');
  const box = (await divider.boundingBox())!;
  await drag(page, [box.x + 12, box.y + 20], [75, 0]);
  expect(await placeOf(divider)).toBe(50);
});

test('a viewer takes the camera of the comparison that it joins, however it is moved', async ({
  page,
  mount,
}) => {
  await compared(
    page,
    mount,
    comparison('', sphere('alt="A" theta="10"') + sphere('alt="B"')) +
      comparison('', sphere('alt="C" theta="50"')) +
      `<main>${sphere('alt="D" theta="90"')}</main>`,
  );
  const thetas = () =>
    page.evaluate(() =>
      Array.from(document.querySelectorAll('phong-viewer'), ({ camera }) => camera.theta),
    );
  expect(await thetas()).toEqual([10, 10, 50, 90]);
  await page.evaluate(() => {
    const [first, second] = document.querySelectorAll('phong-compare');
    second!.append(first!.lastElementChild!);
    second!.moveBefore(document.querySelector('main > phong-viewer')!, null);
  });
  await allReady(page);
  await expect(dividers(page.locator('phong-compare').last())).toHaveCount(2);
  await expect.poll(thetas).toEqual([10, 50, 50, 50]);
});

test('open panels of a split comparison stand beside all pictures, below on a phone', async ({
  page,
  mount,
}) => {
  const wide = 'phong-compare { width: 900px; height: 500px }';
  const markup = comparison('at="60" labels="A, B"', sphere('alt="A" gui') + sphere('alt="B"'));
  const compare = await compared(page, mount, markup, wide);
  const [first, second] = [
    page.locator('phong-viewer').first(),
    page.locator('phong-viewer').last(),
  ];
  const boxOf = async (target: Locator) => (await target.boundingBox())!;
  const surfaceOf = (viewer: ViewerLocator) => boxOf(viewer.locator('[part=surface]'));
  /** What the user would press in the middle of a part belongs to it. */
  const isOnTop = (viewer: ViewerLocator) =>
    panelOf(viewer).evaluate((panel) => {
      const { x, y, width, height } = panel.getBoundingClientRect();
      const root = panel.getRootNode() as ShadowRoot;
      return panel.contains(root.elementFromPoint(x + width / 2, y + height / 2));
    });
  await opened(first, 'Camera');
  await assign(second, { gui: true });
  await expect(titleOf(second, 'Controls')).toHaveAttribute('aria-expanded', 'false');
  expect(await surfaceOf(first)).toEqual(await surfaceOf(second));
  const { width } = await surfaceOf(first);
  expect(width).toBeGreaterThan(450);
  expect((await boxOf(panelOf(first))).x).toBeGreaterThanOrEqual(width);
  expect(await isOnTop(first)).toBe(true);
  expect((await boxOf(dividers(compare).first())).x + 12).toBeCloseTo(0.6 * width, 0);
  await assign(compare, { at: 20 });
  expect(await isOnTop(first), 'wherever the divider is').toBe(true);

  await titleOf(second, 'Controls').click();
  await expect.poll(async () => (await boxOf(panelOf(second))).x).toBeGreaterThanOrEqual(width);
  const [above, below] = [await boxOf(panelOf(first)), await boxOf(panelOf(second))];
  expect(above.y + above.height).toBeLessThanOrEqual(below.y);
  expect(below.y + below.height).toBeLessThanOrEqual(500);
  expect([await isOnTop(first), await isOnTop(second)]).toEqual([true, true]);
  const nameOf = (viewer: ViewerLocator) =>
    titleOf(viewer, 'Controls').evaluate((title) => getComputedStyle(title, '::after').content);
  expect(await nameOf(first), 'says whose it is').toContain('"A"');
  expect(await nameOf(second)).toContain('"B"');
  expect(await surfaceOf(first)).toEqual(await surfaceOf(second));

  await page.emulateMedia({ media: 'print' });
  expect((await surfaceOf(first)).width, 'on paper').toBeCloseTo(width, 0);
  expect((await surfaceOf(second)).x).toBeCloseTo((900 - width) / 2, 0);
  await page.emulateMedia({ media: null });

  await titleOf(second, 'Controls').click();
  await page.evaluate(() => (document.documentElement.dir = 'rtl'));
  await nextFrame(page);
  await page.mouse.move(1, 1);
  await page.locator('phong-compare').hover(); // it reads the direction when a pointer enters
  await expect
    .poll(async () => (await surfaceOf(first)).x - (await boxOf(compare)).x)
    .toBeGreaterThan(250);
  await expect.poll(() => isOnTop(first)).toBe(true);
  await page.evaluate(() => (document.documentElement.dir = 'ltr'));
  await page.locator('phong-compare').evaluate((element) => (element.style.width = '390px'));
  await nextFrame(page);
  expect((await surfaceOf(second)).height).toBeCloseTo(250, 0);
  const sheet = await boxOf(panelOf(first));
  expect([sheet.y, sheet.width]).toEqual([250, 390]);
  expect(await isOnTop(first)).toBe(true);
});

test('comparisons that come and go leave nothing behind', async ({ page, mount }) => {
  await countEverything(page);
  await mount('<main></main>');
  for (let time = 0; time < 3; time++) {
    await page.evaluate(async () => {
      const compare = document.createElement('phong-compare');
      for (let i = 0; i < 3; i++) {
        compare.append(
          Object.assign(document.createElement('phong-viewer'), { geometry: 'box', alt: '' }),
        );
      }
      document.body.append(compare);
      await Promise.all(compare.viewers.map((viewer) => viewer.ready));
      await new Promise((resolve) => setTimeout(resolve, 50));
      compare.remove();
      await new Promise((resolve) => setTimeout(resolve, 50));
    });
    const { listeners, observers } = await countsOf(page);
    expect({ listeners, observers }).toEqual({ listeners: 0, observers: 0 });
  }
});
