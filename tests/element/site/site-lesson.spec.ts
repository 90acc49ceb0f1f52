// Do the figures of the guide's pages about light, and about helpers, views, probe and comparisons,
// behave as their captions say?

import type { Page } from '@playwright/test';
import { accessibleNodes } from '../../a11y/tree.js';
import { allReady, expect, test } from '../../support/test.js';
import { takeNoSamples } from '../../support/site-pages.js';
import type { PhongViewer } from '../support/viewer.js';

test.beforeEach(({ page }) => takeNoSamples(page));

async function open(page: Page, path: string) {
  await page.goto(`/demo/${path}`);
  await allReady(page);
}

async function figure(page: Page, id: string) {
  const found = page.locator(`#${id}`);
  await found.scrollIntoViewIfNeeded();
  return found;
}

/** Every figure of the open page is on paper, within its width. */
async function expectPrinted(page: Page) {
  await page.emulateMedia({ media: 'print' });
  const wide = await page.evaluate(() =>
    Array.from(document.querySelectorAll('phong-compare, figure > phong-viewer'), (picture) => {
      const { width, height } = picture.getBoundingClientRect();
      return width > 0 && height > 0 && width <= document.documentElement.clientWidth;
    }),
  );
  expect(wide).not.toContain(false);
  await expect(page.getByRole('heading', { level: 1 })).toBeVisible();
  await expect(page.getByRole('navigation', { name: 'Pages', exact: true })).toBeHidden();
  await page.emulateMedia({ media: 'screen' });
}

// The page has two dozen pictures: all tests of its figures share one load.
test('the figures of the page about light behave as their captions say', async ({ page }) => {
  test.setTimeout(120_000);
  await open(page, 'guide/light/');
  await test.step('a screen reader finds every picture, divider and light by name', async () => {
    for (const id of ['fig-near-far', 'fig-blinn', 'fig-point']) {
      await figure(page, id);
    }
    await expect(page.getByRole('option', { name: /^lamp/ }).first()).toBeAttached();
    const nodes = await accessibleNodes(page);
    const named = (role: RegExp): readonly string[] =>
      nodes.filter((node) => role.test(node.role)).map(({ name }) => name);
    const pictures = named(/^application$/i).filter((name) => name !== 'Probe');
    const viewers = await page.locator('phong-viewer').count();
    expect(pictures).toHaveLength(viewers);
    expect(new Set(pictures).size, 'no two pictures have the same name').toBe(viewers);
    const dividers = named(/separator|splitter/i).filter((name) => name !== '');
    expect(dividers).toContain('Divider between the cosine and its power');
    expect(dividers).toContain('Divider between Gouraud and Phong');
    expect(named(/^option$|listboxoption/i).some((name) => name.startsWith('spot'))).toBe(true);
  });
  await test.step('dragging the rim of the cone opens it, and the markup under the figure follows', async () => {
    const cone = await figure(page, 'fig-cone');
    await cone.locator('.source summary').click();
    await expect(cone.locator('pre')).toContainText('aperture="18"');
    const rim = cone.getByRole('option', { name: /edge of the cone/ });
    await rim.scrollIntoViewIfNeeded();
    const { x, y, width, height } = (await rim.boundingBox())!;
    await page.mouse.move(x + width / 2, y + height / 2);
    await page.mouse.down();
    await page.mouse.move(x - 30, y + height / 2, { steps: 4 });
    await page.mouse.up();
    await expect(cone.locator('pre')).not.toContainText('aperture="18"');
    const aperture = await cone
      .locator('phong-viewer')
      .evaluate((viewer: PhongViewer) => viewer.lights[0]!.aperture);
    expect(aperture).toBeGreaterThan(20);
    await expect(cone.locator('pre')).toContainText(`aperture="${aperture}"`);
    // The rest stays as its author wrote it.
    await expect(cone.locator('pre')).toContainText('specular="120 115 100"');
  });
  await test.step('a slider under a divider changes the light on both sides', async () => {
    const decay = await figure(page, 'fig-decay');
    await decay.getByRole('spinbutton', { name: 'cutoff' }).fill('2');
    const cutoffs = await decay
      .locator('phong-viewer')
      .evaluateAll((all: PhongViewer[]) => all.map(({ lights }) => lights[0]!.cutoff));
    expect(cutoffs).toEqual([2, 2]);
  });
  await test.step('the listing of a comparison holds all of its viewers', async () => {
    const gouraud = await figure(page, 'fig-gouraud');
    await gouraud.locator('.source summary').click();
    const text = (await gouraud.locator('pre').textContent())!;
    expect(text).toMatch(/^<phong-compare labels="Gouraud, Phong">\n {2}<phong-viewer/);
    expect(text.match(/<phong-viewer/g)).toHaveLength(2);
    expect(text.trim()).toMatch(/<\/phong-viewer>\n<\/phong-compare>$/);
  });
  await test.step('every figure is on paper', () => expectPrinted(page));
});

test('lights that are drawn can be moved by keys, and the markup below follows; all is printed', async ({
  page,
}) => {
  await open(page, 'guide/see/');
  const position = () =>
    page
      .locator('#live-1 phong-viewer')
      .evaluate((viewer: PhongViewer) => viewer.lights[0]!.position.join(' '));
  const before = await position();
  await page.getByRole('option', { name: /^spot/ }).first().focus();
  await page.keyboard.press('Enter');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  const after = await position();
  expect(after).not.toBe(before);
  await expect(page.locator('.listing[data-of] pre').first()).toContainText(`position="${after}"`);
  await expectPrinted(page);
  await page.emulateMedia({ media: 'print' });
  await expect(page.getByRole('navigation', { name: 'Guide' })).toBeHidden();
});
