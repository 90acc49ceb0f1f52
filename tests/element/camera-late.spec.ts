// The code that follows pointers, wheel and keys is fetched with the first sign of them. However late it comes, nothing of
// what the hands did is lost, and the page does not scroll by it.

import type { Page } from '@playwright/test';
import { expect, test } from '../support/test.js';
import { assign, cameraOf, drag as readyDrag, nextFrame, record } from './support.js';

const box = '<phong-viewer geometry="box" theta="30" phi="70" radius="5"></phong-viewer>';
const tall = { css: 'body { height: 3000px }' };

/** At once, whether or not the code is there. */
const drag = (
  page: Page,
  from: readonly [number, number],
  by: readonly [number, number],
  options: { readonly release?: boolean } = {},
): Promise<void> => readyDrag(page, from, by, { ...options, ready: false });

/** Holds the code back until the returned function is called; that waits until it is at work. */
async function heldBack(page: Page): Promise<() => Promise<void>> {
  let letGo = (): void => undefined;
  const free = new Promise<void>((resolve) => {
    letGo = resolve;
  });
  await page.route(/orbit-input/, async (route) => {
    await free;
    await route.continue();
  });
  return async () => {
    const came = page.waitForResponse(/orbit-input/);
    letGo();
    await (await came).finished();
    await nextFrame(page);
  };
}

test.describe('while its code is on the way', () => {
  test('a whole drag, outside the viewer too, turns as far as it travelled', async ({ page, mount }) => {
    const letGo = await heldBack(page);
    const viewer = await mount(box);
    const changes = await record(viewer, 'camera-change');
    await drag(page, [300, 200], [400, 100]);
    await page.mouse.move(10, 10);
    expect(await cameraOf(viewer)).toMatchObject({ theta: 30, phi: 70 });
    await letGo();
    expect(await cameraOf(viewer)).toMatchObject({ theta: 150, phi: 25 });
    expect(await changes.take()).toEqual([{ type: 'camera-change', detail: { source: 'pointer' } }]);
  });

  test('a drag that is still held goes on, and is exactly at the start when it is back there', async ({
    page,
    mount,
  }) => {
    const letGo = await heldBack(page);
    const viewer = await mount(box);
    await drag(page, [300, 200], [70, 30], { release: false });
    await letGo();
    expect(await cameraOf(viewer)).toMatchObject({ theta: -12, phi: 56.5 });
    await page.mouse.move(300, 200);
    expect(await cameraOf(viewer)).toMatchObject({ theta: 30, phi: 70 });
    await page.mouse.up();
    await page.mouse.move(350, 250);
    expect(await cameraOf(viewer)).toMatchObject({ theta: 30, phi: 70 });
  });

  test('keys and the wheel count, and leave the page where it is', async ({ page, mount }) => {
    const letGo = await heldBack(page);
    const viewer = await mount(box, tall);
    await viewer.focus();
    await page.keyboard.press('ArrowLeft');
    await page.keyboard.press('ArrowUp');
    await page.keyboard.press('PageDown');
    await page.mouse.move(300, 200);
    await page.mouse.wheel(0, 100);
    await letGo();
    const { theta, phi, radius } = await cameraOf(viewer);
    expect([theta, phi]).toEqual([35, 75]);
    expect(radius).toBeCloseTo(5 * 1.1 * Math.exp(0.1), 12);
    expect(await page.evaluate('scrollY')).toBe(0);
  });

  test('what a script prevents, and keys that are none of the camera’s, do nothing', async ({
    page,
    mount,
  }) => {
    const letGo = await heldBack(page);
    const viewer = await mount(box, tall);
    await viewer.focus();
    await page.keyboard.press('Space');
    await viewer.evaluate((element) => {
      element.addEventListener('keydown', (event) => event.preventDefault(), { capture: true });
    });
    await page.keyboard.press('ArrowLeft');
    await letGo();
    expect(await cameraOf(viewer)).toMatchObject({ theta: 30, phi: 70, radius: 5 });
    await expect.poll(() => page.evaluate('scrollY')).toBeGreaterThan(0);
  });

  test('taken out and put back it keeps nothing of before', async ({ page, mount }) => {
    const letGo = await heldBack(page);
    const viewer = await mount(box);
    await drag(page, [300, 200], [70, 30], { release: false });
    await viewer.evaluate((element) => {
      const { parentElement } = element;
      element.remove();
      parentElement!.append(element);
    });
    await letGo();
    expect(await cameraOf(viewer)).toMatchObject({ theta: 30, phi: 70 });
    await page.mouse.up();
    await drag(page, [300, 200], [60, 0]);
    expect(await cameraOf(viewer)).toMatchObject({ theta: -6, phi: 70 });
  });
});

test('where its code cannot be fetched the picture and the page go on, with one warning', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/drags, wheel and keys could not be fetched/, 1);
  consoleGuard.allow(/Failed to load resource/, 1);
  await page.route(/orbit-input/, (route) => route.abort());
  const viewer = await mount(box, tall);
  await drag(page, [300, 200], [60, 0]);
  await page.mouse.move(900, 600);
  await drag(page, [300, 200], [60, 0]);
  await page.keyboard.press('PageDown');
  await expect.poll(() => page.evaluate('scrollY')).toBeGreaterThan(0);
  expect(await cameraOf(viewer)).toMatchObject({ theta: 30, phi: 70 });
  await assign(viewer, { theta: 40 });
  expect(await cameraOf(viewer)).toMatchObject({ theta: 40, phi: 70 });
});
