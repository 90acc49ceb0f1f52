// Does a page with many viewers cost no more than its visible part? One context, one frame, copies
// of changed pictures, bounded pixels.

import { allReady, expect, test } from '../../support/test.js';
import { countEverything, countsOf, spentBetween, expectIdle } from '../support/counting.js';
import { redsShown, reddening, scrollThrough } from './many-viewers.js';
import { nextFrame, type PhongViewer, statsOf } from '../support/viewer.js';

const small = { width: 90, height: 60, css: 'phong-viewer { float: left }' };

test.beforeEach(({ page }) => countEverything(page));

test('viewers share one context and one frame; only those that changed draw', async ({
  page,
  mount,
}) => {
  const count = 64;
  const viewer = await mount(reddening(count), small);
  const drawn = async () => (await statsOf(viewer)).viewersDrawn;
  const taken = await countsOf(page);
  expect(taken).toMatchObject({ contexts: 1, copies: count, observers: 3 }); // of place, of surroundings and of size
  expect(taken.listeners).toBeGreaterThan(0);
  expect(await drawn()).toBe(count);
  const reds = await redsShown(page);
  expect(reds.every((red, i) => red > (reds[i - 1] ?? -1))).toBe(true);
  await nextFrame(page);
  const before = await countsOf(page);
  const changed = Math.ceil(count / 16);
  await page.evaluate((many) => {
    for (const element of [...document.querySelectorAll('phong-viewer')].slice(-many)) {
      element.theta = 77;
      element.lights[0]!.diffuse = [9, 9, 9];
    }
  }, changed);
  await allReady(page);
  expect(spentBetween(before, await countsOf(page))).toMatchObject({ frames: 1, copies: changed });
  expect(await drawn()).toBe(changed);
  expect((await redsShown(page)).slice(0, -changed)).toEqual(reds.slice(0, -changed));
  await page.evaluate(() => {
    for (const element of document.querySelectorAll('phong-viewer')) {
      element.remove();
    }
  });
  await nextFrame(page);
  await expectIdle(page, 300);
  expect(await countsOf(page)).toMatchObject({ contexts: 1, listeners: 0, observers: 0 });
});

test('render comes once a frame, when a listener can read the new picture from the canvas', async ({
  page,
  mount,
}) => {
  const viewer = await mount(reddening(2), small);
  const turn = (theta: number) =>
    page.evaluate(async (angle) => {
      const read = (image: CanvasImageSource) => {
        const context = new OffscreenCanvas(90, 60).getContext('2d')!;
        context.drawImage(image, 0, 0);
        return context.getImageData(0, 0, 90, 60).data.join();
      };
      const viewers = [...document.querySelectorAll('phong-viewer')];
      const seen = viewers.map((element) => {
        const pictures: string[] = [];
        element.addEventListener('render', () =>
          pictures.push(read(element.shadowRoot!.querySelector('canvas')!)),
        );
        return pictures;
      });
      for (const element of viewers) {
        element.theta = angle;
      }
      await Promise.all(viewers.map(({ ready }) => ready));
      // The picture of toBlob is drawn apart from what the page shows.
      const shown = viewers.map(async (element) =>
        read(await createImageBitmap(await element.toBlob())),
      );
      return (await Promise.all(shown)).map(
        (own, i) => seen[i]!.length === 1 && seen[i]![0] === own,
      );
    }, theta);
  expect(await turn(60)).toEqual([true, true]);
  await viewer.evaluate((element) => element.remove());
  await nextFrame(page);
  // A lone viewer shows the shared canvas itself, whose pixels last until the end of the task.
  expect(await turn(90)).toEqual([true]);
});

test('the context opens with the first visible picture, at its size', async ({ page, mount }) => {
  // Resizing a canvas with a context reallocates all buffers, once for each side.
  await page.addInitScript(() => {
    const opened = new Set<HTMLCanvasElement>();
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (
      this: HTMLCanvasElement,
      ...call: unknown[]
    ) {
      if (call[0] === 'webgl2') {
        opened.add(this);
      }
      return Reflect.apply(getContext, this, call) as null;
    } as typeof getContext;
    Object.assign(window, { resized: 0 });
    for (const side of ['width', 'height'] as const) {
      const { get, set } = Object.getOwnPropertyDescriptor(HTMLCanvasElement.prototype, side)!;
      const counted = function (this: HTMLCanvasElement, value: number) {
        if (opened.has(this)) {
          window.resized += 1;
        }
        set!.call(this, value);
      };
      Object.defineProperty(HTMLCanvasElement.prototype, side, { get: get!, set: counted });
    }
  });
  await mount(`<p></p>${reddening(16)}`, { ...small, css: `${small.css} p { height: 3000px }` });
  await nextFrame(page);
  expect(await countsOf(page)).toMatchObject({ contexts: 0, gl: 0 });
  await page.evaluate(() => scrollTo(0, 3000));
  await expect.poll(async () => (await redsShown(page)).every((red) => red >= 0)).toBe(true);
  expect(await countsOf(page)).toMatchObject({ contexts: 1, copies: 16 });
  expect(await page.evaluate(() => window.resized)).toBe(0);
});

test('viewers scrolled past free their pixels, and get them back; all are printed', async ({
  page,
  mount,
}) => {
  test.slow();
  const count = 56;
  await scrollThrough(page, mount, count);
  const shown = (await countsOf(page)).canvasPixels;
  await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
  const reds = await redsShown(page);
  expect(reds).toHaveLength(count);
  expect(reds.every((red, i) => red > (reds[i - 1] ?? -1))).toBe(true);
  const printed = (await countsOf(page)).canvasPixels;
  expect(printed).toBeGreaterThan(shown);
  // The next frame of any viewer frees the pixels for print.
  await page.evaluate(() => {
    const viewer = document.querySelector('phong-viewer')!;
    viewer.theta = 77;
    return viewer.ready;
  });
  await nextFrame(page);
  expect((await countsOf(page)).canvasPixels).toBeLessThan(printed / 1.2);
});

test('the shared canvas shrinks when a large viewer is removed or out of view', async ({
  page,
  mount,
}) => {
  const css = '#large { width: 900px; height: 600px } #low { margin-top: 2000px }';
  const viewer = await mount(
    `<phong-viewer id="large" geometry="box"></phong-viewer>${reddening(2)}`,
    { ...small, css },
  );
  const ofOne = small.width * small.height;
  const sheet = async () => (await countsOf(page)).sheetPixels;
  expect(await sheet()).toBeGreaterThanOrEqual(900 * 600);
  await page.locator('phong-viewer').last().scrollIntoViewIfNeeded();
  await viewer.evaluate((element) => (element.style.display = 'none'));
  await nextFrame(page);
  const turned = page.locator('phong-viewer').last();
  await turned.evaluate(async (element: PhongViewer) => {
    for (let i = 0; i < 31; i++) {
      element.theta = i;
      await element.ready;
    }
  });
  expect(await sheet()).toBe(ofOne);
  await viewer.evaluate((element) => (element.style.display = ''));
  await expect.poll(sheet).toBeGreaterThanOrEqual(900 * 600);
  await viewer.evaluate((element) => element.remove());
  expect(await sheet()).toBeLessThanOrEqual(ofOne);
});

declare global {
  interface Window {
    resized: number;
  }
}
