// Is the probe accessible by keyboard and screen reader, in forced colours, and in languages
// written from right to left?

import { type ViewerLocator, expect, test } from '../support/test.js';
import { assign, nextFrame, pointerAway } from '../element/support/viewer.js';

const scene = (attributes = 'probe') =>
  `<main><phong-viewer alt="A sphere" geometry="sphere" theta="0" phi="90" radius="1.6" target="0 0 0" ${attributes}>
    <phong-light name="sun" position="-1 1.4 1.2 0" ambient="26 28 36"></phong-light>
    <phong-light name="lamp" position="0.9 0.5 0.6 1" diffuse="#d98c46"></phong-light>
  </phong-viewer></main>`;

const region = (viewer: ViewerLocator) => viewer.locator('.probe [aria-live]');
const box = (viewer: ViewerLocator) => viewer.getByRole('group', { name: 'Probe' });
const cursor = (viewer: ViewerLocator) => viewer.getByRole('application', { name: 'Probe' });

test('the cross-hair has a name, a role and described keys, and its values are announced', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene());
  await pointerAway(page);
  await expect(cursor(viewer)).toHaveAttribute('aria-roledescription', 'cross-hair');
  await expect(cursor(viewer)).toHaveAttribute('aria-description', /Arrow keys move it by a pixel/);
  await expect(region(viewer)).toBeEmpty();
  await cursor(viewer).focus();
  await expect(region(viewer)).toHaveText(
    /^Point [−\d. ]+\. Colour: red \d+, green \d+, blue \d+\. (sun|lamp): ambient/,
  );
  await expect(region(viewer)).toHaveAttribute('aria-live', 'polite');
});

test('announcements are at least a second apart, and the last one is of the last point', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene());
  await pointerAway(page);
  const times = await region(viewer).evaluateHandle((live) => {
    const list: number[] = [];
    new MutationObserver(() => list.push(performance.now())).observe(live, {
      childList: true,
      characterData: true,
      subtree: true,
    });
    return list;
  });
  await cursor(viewer).focus();
  for (let i = 0; i < 12; i++) {
    await page.keyboard.press('ArrowUp');
    await page.waitForTimeout(120);
  }
  const point = await viewer.evaluate(async (element) => (await element.shadeAt(300, 188))!.p);
  const last = `Point ${point.map((x) => String(Number(x.toPrecision(3))).replace('-', '−')).join(' ')}.`;
  await expect(region(viewer)).toContainText(last);
  const gaps = await times.evaluate((all) => all.slice(1).map((time, i) => time - all[i]!));
  expect(gaps.length).toBeGreaterThan(0);
  // A timer of one second; the report of its start can come late.
  for (const gap of gaps) {
    expect(gap).toBeGreaterThan(800);
  }
});

test('the table has a caption, headers and one Tab stop; changes by scripts are silent', async ({
  page,
  mount,
}) => {
  // A headless shell may move the pointer to the page's corner: beside the picture, or a leave
  // would announce the point.
  const viewer = await mount(scene('probe probe-at="0 0 0.5"'), { css: 'main { padding: 20px }' });
  await expect(box(viewer)).toBeVisible();
  await assign(viewer.locator('phong-light').first(), { diffuse: [9, 99, 9] });
  await nextFrame(page);
  await expect(region(viewer)).toBeEmpty();
  const table = viewer.getByRole('table', {
    name: 'Red, green and blue of each term; 255 is full',
  });
  await expect(table.getByRole('columnheader')).toHaveCount(7);
  await expect(table.getByRole('rowheader')).toHaveText(['sun', 'lamp', 'sum']);
  await expect(table.getByRole('button')).toHaveText(['sun', 'lamp']);
  const button = table.locator('button[tabindex="0"]');
  await expect(button).toHaveCount(1);
  await expect(table.locator('button[tabindex="-1"]')).toHaveCount(1);
  await button.focus();
  await expect(button).toHaveAccessibleDescription(/: N·L = cos [\d.]+° = /);
  await expect(button).toHaveAttribute('aria-pressed', 'false');
  await page.keyboard.press('Enter');
  await expect(button).toHaveAttribute('aria-pressed', 'true');
});

test('the focus moves to the cross-hair when the focused row or button disappears', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene());
  await page.mouse.click(300, 150);
  const button = viewer.getByRole('table').getByRole('button', { name: 'lamp' });
  await button.focus();
  await viewer
    .locator('phong-light')
    .last()
    .evaluate((light) => light.remove());
  await expect(cursor(viewer)).toBeFocused();
  await viewer.getByRole('button', { name: 'Unpin' }).focus();
  await page.keyboard.press('Enter');
  await expect(cursor(viewer)).toBeFocused();
  await expect(box(viewer)).not.toHaveClass(/pinned/);
});

test('from right to left all begins at the right edge, each sum under its column, and red comes first', async ({
  page,
  mount,
}) => {
  const viewer = await mount(
    `<div dir="rtl">${scene('id="a" probe probe-at="0 0.2 0.458" view="n-dot-l"')}<phong-probe for="a" as="ask" at="0 0 0.5"></phong-probe></div>`,
  );
  await expect(box(viewer)).toBeVisible();
  await assign(page.locator('phong-light').last(), { position: [0, 0, -1, 0] });
  await expect(page.locator('phong-probe .facts')).toHaveCount(4);
  const { x, width } = (await page.locator('[part=probe]').boundingBox())!;
  expect(x + width).toBeGreaterThan(980);
  await expect(viewer.getByRole('table').locator('bdi').first()).toHaveCSS('direction', 'ltr');
  /** How far these texts are from the edge of the elements around them, at most. */
  const gap = (texts: string, side: 'left' | 'right') =>
    page.locator(texts).evaluateAll((all, edge) => {
      const text = document.createRange();
      const gaps = all.map((one) => {
        text.selectNodeContents(one);
        return Math.abs(one.getBoundingClientRect()[edge] - text.getBoundingClientRect()[edge]);
      });
      return Math.max(...gaps);
    }, side);
  expect(await gap('.legend-lights, .steps, .title, .facts, th small:not(:empty)', 'right')).toBeLessThan(3); // oxfmt-ignore
  expect(await gap('[data-column=sum], tfoot td', 'left')).toBeLessThan(3);
});

test('the swatch keeps the colour of the point in forced colours', async ({ page, mount }) => {
  await page.emulateMedia({ forcedColors: 'active' });
  const viewer = await mount(scene('probe probe-at="0 0 0.5"'));
  await expect(box(viewer)).toBeVisible();
  const [shown, color] = await viewer.evaluate(async (element) => {
    const swatch = element.shadowRoot!.querySelector('[part=probe] .swatch')!;
    return [
      getComputedStyle(swatch).backgroundColor,
      (await element.shadeAt(300, 200))!.color,
    ] as const;
  });
  const numbers = (shown.match(/[\d.]+/g) ?? []).map(Number);
  color.forEach((c, i) => expect(Math.abs(numbers[i]! - 255 * c)).toBeLessThan(1));
});
