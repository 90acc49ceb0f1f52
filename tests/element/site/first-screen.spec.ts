// Does the first screen prove what it says? The sum under the picture is that of the pixel, its
// digits add up, and picture and markup move each other.
import { countJumps, jumpsOf } from '../../support/jumps.js';
import type { Page } from '@playwright/test';
import { type ViewerLocator, allReady, expect, pixelAt, test } from '../../support/test.js';
import { decodePng } from '../../support/picture.js';
import type { PhongViewer } from '../support/viewer.js';
import { assign } from '../support/viewer.js';

async function open(page: Page) {
  await page.setViewportSize({ width: 1280, height: 800 });
  await page.goto('/demo/');
  await allReady(page);
  await expect(page.locator('#sum .cell')).toHaveCount(7);
  return page.locator('phong-viewer');
}

/** The numbers of each cell of the line. */
const cells = async (page: Page): Promise<readonly (readonly number[])[]> =>
  (await page.locator('#sum .digits').allTextContents()).map((text) => text.split(' ').map(Number));

const lamp = (viewer: ViewerLocator): Promise<readonly number[]> =>
  viewer.evaluate((element) => element.lights[1]!.position);

test('the line adds up to the pixel under the mouse, as the picture shows it', async ({ page }) => {
  const viewer = await open(page);
  const { x: left, y: top, width, height } = (await viewer.boundingBox())!;
  const before = await cells(page);
  // The teapot, the ball, its highlight, the floor, and the floor's edge.
  for (const [across, down] of [
    [0.38, 0.55],
    [0.7, 0.62],
    [0.652, 0.583],
    [0.45, 0.85],
  ] as const) {
    const [x, y] = [Math.round(left + across * width) + 0.5, Math.round(top + down * height) + 0.5];
    await page.mouse.move(x, y);
    await expect(page.locator('#pixel')).toHaveCSS('left', `${String(x - left)}px`);
    const shown = await cells(page);
    expect(shown).not.toEqual(before);
    // Between them, where the sum is above 255, is the sum before it is cut.
    const terms = shown.slice(1, 6);
    const sum = [0, 1, 2].map((i) =>
      Math.min(255, Math.round(Number(terms.reduce((all, term) => all + term[i]!, 0).toFixed(8)))),
    );
    expect(shown.at(-1)).toEqual(sum);
    expect(shown[0]).toEqual(sum);
    // The ring is drawn over it.
    await page.locator('#pixel').evaluate((ring) => (ring.style.visibility = 'hidden'));
    const picture = decodePng(await page.screenshot());
    await page.locator('#pixel').evaluate((ring) => (ring.style.visibility = ''));
    const drawn = pixelAt(picture, Math.floor(x), Math.floor(y)).slice(0, 3);
    for (const [i, code] of drawn.entries()) {
      expect(Math.abs(code - sum[i]!), `${String(across)} ${String(down)}`).toBeLessThanOrEqual(1);
    }
  }
  // Beside the shapes the pixel stays.
  const last = await cells(page);
  await page.mouse.move(left + 5, top + 5);
  await page.waitForTimeout(200);
  expect(await cells(page)).toEqual(last);
});

test('a dragged lamp runs in the markup, and the sum follows it', async ({ page }) => {
  const viewer = await open(page);
  const field = page.getByRole('spinbutton', { name: 'lamp position x' });
  await expect(field).toHaveValue('0.2');
  const before = await cells(page);
  const mark = page.locator('phong-viewer').getByText('lamp', { exact: true });
  const { x, y, height } = (await mark.boundingBox())!;
  await page.mouse.move(x - 12, y + height / 2);
  await page.mouse.down();
  await page.mouse.move(x + 60, y + 30, { steps: 4 });
  await page.mouse.up();
  const [moved = NaN] = await lamp(viewer);
  expect(moved).toBeGreaterThan(0.25);
  await expect(field).toHaveValue(moved.toFixed(2));
  await expect.poll(() => cells(page)).not.toEqual(before);
});

test('a number in the markup moves the lamp: typed, by arrow keys, and dragged', async ({
  page,
}) => {
  const viewer = await open(page);
  const field = page.getByRole('spinbutton', { name: 'lamp position x' });
  await field.focus();
  await field.fill('0.4');
  expect(await lamp(viewer)).toEqual([0.4, 0.5, 0.7, 1]);
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('Shift+ArrowDown');
  expect((await lamp(viewer))[0]).toBeCloseTo(-0.05, 6);
  await field.fill('far');
  await expect(field).toHaveAttribute('aria-invalid', 'true');
  expect((await lamp(viewer))[0]).toBeCloseTo(-0.05, 6);
  await page.keyboard.press('Tab');
  await expect(field).toHaveValue('-0.05');
  const { x, y } = (await field.boundingBox())!;
  await page.mouse.move(x + 5, y + 5);
  await page.mouse.down();
  await page.mouse.move(x + 45, y + 5, { steps: 4 });
  await page.mouse.up();
  expect((await lamp(viewer))[0]).toBeCloseTo(0.35, 6);
  const grey = page.getByRole('spinbutton', { name: 'sun ambient' });
  await grey.fill('50');
  expect(await viewer.evaluate((element: PhongViewer) => element.lights[0]!.ambient)).toEqual([
    50, 50, 50,
  ]);
});

test('arrow keys move the pixel, and a screen reader hears the sum then', async ({ page }) => {
  await open(page);
  const before = await cells(page);
  const ring = page.getByRole('application', { name: 'The pixel that is explained' });
  await ring.focus();
  await expect(page.locator('#sum')).toHaveAttribute('aria-live', 'polite');
  await page.keyboard.press('Shift+ArrowDown');
  await page.keyboard.press('ArrowLeft');
  await expect.poll(() => cells(page)).not.toEqual(before);
  await page.keyboard.press('Tab');
  await expect(page.locator('#sum')).not.toHaveAttribute('aria-live');
});

test('a pixel that shows no surface any more is said to show none', async ({ page }) => {
  const viewer = await open(page);
  await assign(viewer, { target: [5, 0, 0] });
  await expect(page.locator('#sum')).toHaveText('This pixel shows no surface now. Point at one.');
  await expect(page.locator('#pixel')).toBeHidden();
  await assign(viewer, { target: [0, -0.04, 0] });
  await expect(page.locator('#sum .cell')).toHaveCount(7);
});

test('the panel opens by its button, and a light that it adds is in line and markup', async ({
  page,
}) => {
  const viewer = await open(page);
  const button = page.getByRole('button', { name: 'Panel' });
  await expect(viewer.getByText('add light')).toHaveCount(0);
  await button.click();
  await expect(button).toHaveAttribute('aria-pressed', 'true');
  await viewer.getByText('add light').click();
  await expect(page.locator('#sum .diffuse')).toHaveCount(3);
  await expect(page.locator('#sum .specular')).toHaveCount(3);
  await expect(page.locator('#code .tag', { hasText: 'phong-light' })).toHaveCount(6);
  await button.click();
  await expect(viewer.getByText('add light')).toHaveCount(0);
});

test('the first screen fits: picture, markup and sum are within 720 pixels, and nothing jumps', async ({
  page,
}) => {
  await countJumps(page);
  for (const [width, height] of [
    [1280, 720],
    [390, 844],
  ] as const) {
    await page.setViewportSize({ width, height });
    await page.goto('/demo/');
    await allReady(page);
    await expect(page.locator('#sum .cell').first()).toBeVisible();
    const { y, height: tall } = (await page.locator('#sum').boundingBox())!;
    expect(y + tall).toBeLessThan(height);
    expect(await jumpsOf(page)).toBeLessThan(0.01);
  }
});

test('the squares keep their colours where the user forces others', async ({ page }) => {
  await page.emulateMedia({ forcedColors: 'active' });
  await open(page);
  const swatch = page.locator('#sum .swatch').first();
  await expect(swatch).not.toHaveCSS('background-color', 'rgb(255, 255, 255)');
  const line = page.getByRole('link', { name: 'Guide' }).first();
  await expect(line).toHaveCSS('border-bottom-color', 'rgb(255, 255, 255)');
});
