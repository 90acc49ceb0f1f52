// Does the probe explain the point that mouse, finger, keyboard or markup choose, and nothing else? Held against shadeAt. Places are CSS pixels
// of the viewer, which lies at the page's top left.

import type { Locator, Page } from '@playwright/test';
import { expect, test } from '../support/test.js';
import { assign, drag, nextFrame, type PhongViewer } from './support.js';

const LIGHTS = `
  <phong-light name="sun" position="-1 1.4 1.2 0" ambient="26 28 36" diffuse="110 112 118" specular="150"></phong-light>
  <phong-light name="lamp" position="0.9 0.5 0.6 1" diffuse="#d98c46" specular="#c8aa8a" attenuation="1 0.2 0.6"></phong-light>
  <phong-light name="off" active="false"></phong-light>`;

/** A sphere that fills most of 600 × 400. */
const scene = (attributes = 'probe', lights = LIGHTS): string =>
  `<phong-viewer geometry="sphere" segments="64" theta="0" phi="90" radius="1.6" target="0 0 0" ${attributes}>${lights}</phong-viewer>`;

const box = (viewer: Locator): Locator => viewer.locator('[part=probe]');
const codes = (viewer: Locator): Locator => viewer.locator('[part=probe] .codes');
const cursor = (viewer: Locator): Locator => viewer.locator('.probe > .cursor');
const labels = (viewer: Locator): Promise<string[]> => viewer.locator('.probe > svg text').allTextContents();

/** What the box should say of this place. */
const expected = (viewer: Locator, x: number, y: number): Promise<string> =>
  viewer.evaluate(
    async (element: PhongViewer, at) => {
      const fragment = (await element.shadeAt(...at))!;
      return fragment.color.map((c) => (255 * c).toFixed(1)).join(' ');
    },
    [x, y] as const,
  );

const escape = (page: Page): Promise<void> => page.keyboard.press('Escape');

test.describe('a mouse over a viewer with a probe', () => {
  test('shows the colour and the sum of the fragment below it, and nothing beside the shape', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene());
    await expect(box(viewer)).toBeHidden();
    await page.mouse.move(250, 150);
    await expect(box(viewer)).toBeVisible();
    expect(await codes(viewer).textContent()).toBe(await expected(viewer, 250, 150));
    await page.mouse.move(330.5, 260);
    await expect(codes(viewer)).toHaveText(await expected(viewer, 330.5, 260));
    await page.mouse.move(5, 5);
    await expect(box(viewer)).toBeHidden();
    expect(await labels(viewer)).toEqual([]);
  });

  test('gets a table of the active lights whose terms add up to the sum', async ({ page, mount }) => {
    const viewer = await mount(scene());
    await page.mouse.move(280, 130);
    const table = box(viewer).getByRole('table', { name: 'Red, green and blue of each term; 255 is full' });
    await expect(table.getByRole('rowheader')).toHaveText([/^sun/, /^lamp/, 'sum']);
    await expect(table.getByRole('columnheader')).toHaveText([
      ...['light', 'ambient', 'diffuse', 'specular', 'att', 'decay', 'sum'],
    ]);
    const rows = await table
      .locator('tbody tr')
      .evaluateAll((all) =>
        all.map((row) => Array.from(row.querySelectorAll('td'), (cell) => cell.textContent)),
      );
    const shares = await viewer.evaluate(async (element: PhongViewer) => {
      const { shares } = (await element.shadeAt(280, 130))!;
      return shares.flatMap((share) => (share === null ? [] : [share]));
    });
    const triple = (color: readonly number[]): string =>
      color.every((c) => c === 0) ? '0' : color.map((c) => (255 * c).toFixed(1)).join(' ');
    shares.forEach(({ ambient, diffuse, specular, att, decay }, i) => {
      const total = ambient.map((c, k) => c + diffuse[k]! + specular[k]!);
      const factor = (x: number): string => (x === 1 ? '1' : x.toFixed(2));
      expect(rows[i]).toEqual([
        ...[ambient, diffuse, specular].map(triple),
        ...[att, decay].map(factor),
        triple(total),
      ]);
    });
  });

  test('sees N, V, an L for each active light, and R of the one that adds most', async ({ page, mount }) => {
    const viewer = await mount(scene());
    await page.mouse.move(280, 130);
    await expect
      .poll(async () => (await labels(viewer)).sort().join())
      .toMatch(/^\d+°,L lamp,L sun,N,R ∠V \d+°,V$/);
    await assign(viewer, { reflection: 'blinn-phong' });
    await expect.poll(() => labels(viewer)).toContain('H');
    expect(await labels(viewer)).not.toContainEqual(expect.stringMatching(/^R/));
  });

  test('is followed when the picture changes below it', async ({ page, mount }) => {
    const viewer = await mount(scene());
    await page.mouse.move(280, 130);
    await expect(box(viewer)).toBeVisible();
    const before = await codes(viewer).textContent();
    await assign(viewer.locator('phong-light').first(), { diffuse: [10, 200, 10] });
    await expect(codes(viewer)).not.toHaveText(before!);
    await expect(codes(viewer)).toHaveText(await expected(viewer, 280, 130));
    await viewer
      .locator('phong-light')
      .first()
      .evaluate((light) => light.remove());
    await expect(box(viewer).locator('tbody tr')).toHaveCount(1);
  });
});

test.describe('a click', () => {
  test('pins the point, which stays in its place in the scene, until Escape', async ({ page, mount }) => {
    const viewer = await mount(scene());
    await page.mouse.click(280, 130);
    await expect(box(viewer)).toHaveClass(/pinned/);
    const pinned = await codes(viewer).textContent();
    await page.mouse.move(320, 220);
    await nextFrame(page);
    await expect(codes(viewer)).toHaveText(pinned!);
    const at = await cursor(viewer).boundingBox();
    await assign(viewer, { theta: 20 });
    await expect.poll(async () => (await cursor(viewer).boundingBox())!.x).toBeLessThan(at!.x - 20);
    const { x, width, y, height } = (await cursor(viewer).boundingBox())!;
    await expect(codes(viewer)).toHaveText(await expected(viewer, x + width / 2, y + height / 2));
    await escape(page);
    await expect(box(viewer)).toBeHidden();
    await page.mouse.move(321, 220);
    await expect(codes(viewer)).toHaveText(await expected(viewer, 321, 220));
  });

  test('elsewhere moves the pin, beside the shape takes it away, and so does its button', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(scene());
    await page.mouse.click(280, 130);
    await page.mouse.click(330, 150);
    await expect(codes(viewer)).toHaveText(await expected(viewer, 330, 150));
    await page.mouse.click(5, 5);
    await expect(box(viewer)).toBeHidden();
    await page.mouse.click(280, 130);
    await box(viewer).getByRole('button', { name: 'Unpin' }).click();
    await expect(box(viewer)).not.toHaveClass(/pinned/);
  });

  test('is none where the pointer has turned the camera between', async ({ page, mount }) => {
    const viewer = await mount(scene());
    await drag(page, [280, 130], [40, 0]);
    await nextFrame(page);
    await expect(box(viewer)).not.toHaveClass(/pinned/);
    expect(await viewer.evaluate((element: PhongViewer) => element.camera.theta)).not.toBe(0);
  });
});

test('without `probe` nothing of it is fetched; with it, one file, once', async ({ page, mount }) => {
  const fetched: string[] = [];
  page.on('request', (request) => fetched.push(new URL(request.url()).pathname));
  const viewer = await mount(scene(''));
  await page.mouse.move(280, 130);
  await nextFrame(page);
  expect(fetched.filter((path) => /probe|shade-at|overlay/.test(path))).toEqual([]);
  await assign(viewer, { probe: true });
  await expect(box(viewer)).toHaveCount(1);
  await page.mouse.move(281, 130);
  await expect(box(viewer)).toBeVisible();
  await assign(viewer, { probe: false });
  await expect(box(viewer)).toHaveCount(0);
  await assign(viewer, { probe: true });
  await expect(box(viewer)).toHaveCount(1);
  await page.mouse.move(282, 130);
  await expect(box(viewer)).toBeVisible();
  expect(fetched.filter((path) => path.includes('probe'))).toHaveLength(1);
});
