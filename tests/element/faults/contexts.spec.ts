import type { Page } from '@playwright/test';
// What happens when the graphics context fails: refused, lost while it is created, lost again, lost under toBlob, too
// large?

import { compare, expect, pixels, test } from '../../support/test.js';
import { fullOr } from '../../support/repeats.js';
import { installFaults } from './faults.js';
import { nextFrame, type PhongViewer, record } from '../support/viewer.js';

const SIZE = { width: 120, height: 90 };
const box = '<phong-viewer geometry="box"><phong-light position="1 2 3 0"></phong-light></phong-viewer>';

test.beforeEach(({ page }) => installFaults(page));

for (const count of [1, 2]) {
  test(`a refused context is requested again, and then drawn with, with ${count} on the page`, async ({
    mount,
    page,
  }) => {
    const expected = await pixels(await mount(box.repeat(count), SIZE));
    await page.addInitScript(() => (window.faults.opening = 'throws'));
    const viewer = await mount(box.repeat(count), SIZE);
    const notices = page.locator('phong-viewer [part=notice]');
    const events = await record(viewer, 'error', 'render');
    await expect(notices).toHaveCount(count);
    expect(await page.evaluate(() => window.faults.asked)).toBe(1);

    // Changes request no context: a script may make one in each frame.
    await viewer.evaluate((element: PhongViewer) => (element.theta = 31));
    await viewer.evaluate((element: PhongViewer) => (element.theta = 30));
    await nextFrame(page);
    expect(await page.evaluate(() => window.faults.asked)).toBe(1);

    // The page becomes visible again.
    const show = (): Promise<unknown> =>
      page.evaluate(() => document.dispatchEvent(new Event('visibilitychange')));
    await page.evaluate(() => (window.faults.opening = 'null'));
    await show();
    await nextFrame(page);
    expect(await page.evaluate(() => window.faults.asked)).toBe(2);
    expect(await events.take()).toEqual([]);
    await page.evaluate(() => (window.faults.opening = 'works'));
    await show();
    await expect(notices).toHaveCount(0);
    await nextFrame(page);
    expect(await events.take()).toEqual([{ type: 'render', detail: null }]);
    expect(compare(await pixels(viewer), expected).max).toBe(0);
  });
}

test('a context lost at any call before the end of the first picture is reported once and restored', async ({
  mount,
  page,
}) => {
  test.slow();
  const expected = await pixels(await mount(box, SIZE));
  const calls = await page.evaluate(async (html) => {
    document.body.replaceChildren();
    await new Promise((resolve) => setTimeout(resolve));
    window.faults.callsLeft = 1e6;
    document.body.innerHTML = html;
    await document.querySelector('phong-viewer')!.ready;
    return 1e6 - window.faults.callsLeft;
  }, box);
  expect(calls).toBeGreaterThan(60);
  for (let call = 0; call < calls; call += call < 40 ? fullOr(1, 3) : fullOr(7, 21)) {
    await page.evaluate(
      async ({ html, call }) => {
        document.body.replaceChildren();
        await new Promise((resolve) => setTimeout(resolve));
        window.faults.callsLeft = call;
        document.body.innerHTML = html;
        const viewer = document.querySelector('phong-viewer')!;
        viewer.addEventListener('error', ({ detail }) => (viewer.title += detail.code));
      },
      { html: box, call },
    );
    const viewer = page.locator('phong-viewer');
    await expect(viewer.locator('[part=notice]')).toContainText('context was lost');
    await expect(viewer, `call ${call}`).toHaveAttribute('title', 'context-lost');
    await page.evaluate(() => window.faults.restore());
    await expect(viewer.locator('[part=notice]')).toHaveCount(0);
    await viewer.evaluate((element: PhongViewer) => element.ready);
    expect(compare(await pixels(viewer), expected).max, `call ${call}`).toBe(0);
  }
});

test('a context lost again while it is restored comes back with the next restoration', async ({
  mount,
  page,
}) => {
  const viewer = await mount(box.repeat(2), SIZE);
  const expected = await pixels(viewer);
  const notices = page.locator('phong-viewer [part=notice]');
  const events = await record(viewer, 'error');
  await page.evaluate(() => window.faults.lose());
  await expect(notices).toHaveCount(2);
  for (const calls of [0, 1, 10, 100]) {
    await page.evaluate((count) => {
      window.faults.restore();
      window.faults.callsLeft = count;
    }, calls);
    await nextFrame(page);
    await nextFrame(page);
    if (calls < 100) await expect(notices).toHaveCount(2);
  }
  await page.evaluate(() => {
    window.faults.callsLeft = Infinity;
    window.faults.restore();
  });
  await expect(notices).toHaveCount(0);
  await viewer.evaluate((element: PhongViewer) => element.ready);
  expect(compare(await pixels(viewer), expected).max).toBe(0);
  expect((await events.take()).length).toBeLessThanOrEqual(2);
});

test('a viewer that connects while the context is lost reports it', async ({ mount, page }) => {
  await mount(box, SIZE);
  await page.evaluate(() => window.faults.lose());
  await expect(page.locator('[part=notice]')).toHaveCount(1);
  await page.evaluate((html) => document.body.insertAdjacentHTML('beforeend', html), box);
  await expect(page.locator('[part=notice]')).toHaveCount(2);
  await page.evaluate(() => window.faults.restore());
  await expect(page.locator('[part=notice]')).toHaveCount(0);
});

for (const [when, calls] of [
  ['before its event arrives', 0],
  ['between two tiles', -1],
] as const) {
  test(`toBlob rejects if the context is lost ${when}`, async ({ mount }) => {
    const viewer = await mount(box, SIZE);
    const outcomes = await viewer.evaluate(async (element: PhongViewer, given) => {
      const size = given < 0 ? { width: 5000, height: 60 } : { width: 50, height: 60 };
      let calls: number = given;
      if (given < 0) {
        window.faults.callsLeft = 1e6;
        await element.toBlob(size);
        calls = Math.floor((1e6 - window.faults.callsLeft) * 0.6);
      }
      if (calls === 0) window.faults.lose();
      else window.faults.callsLeft = calls;
      const outcome = (promise: Promise<unknown>): Promise<string> => promise.then(() => 'a picture', String);
      const first = await outcome(element.toBlob(size));
      await new Promise((resolve) => setTimeout(resolve, 50));
      const second = await outcome(element.toBlob(size));
      window.faults.restore();
      await new Promise((resolve) => setTimeout(resolve, 50));
      return [first, second, await outcome(element.toBlob(size))];
    }, calls);
    const message = 'Error: the graphics context is lost: there is no picture until the browser restores it';
    expect(outcomes).toEqual([message, message, 'a picture']);
  });
}

/** Most pixels of a canvas on the page. */
const fourScreens = (page: Page): Promise<number> => page.evaluate(() => 4 * screen.width * screen.height);

test('a first viewer of 8192 × 8192 device pixels is drawn with the pixels of four screens', async ({
  mount,
  page,
}) => {
  test.slow();
  const viewer = await mount(box, { width: 8192, height: 8192 });
  await expect(viewer.locator('[part=notice]')).toHaveCount(0);
  const [width, height, frames] = await viewer.evaluate((element: PhongViewer) => {
    const canvas = element.shadowRoot!.querySelector('canvas')!;
    return [canvas.width, canvas.height, element.stats.frames] as const;
  });
  expect(frames).toBe(1);
  expect((width * height) / (await fourScreens(page))).toBeCloseTo(1, 2);
  expect(width).toBe(height);
  const small = await pixels(viewer, SIZE);
  await viewer.evaluate((element) => element.remove());
  await page.evaluate((html) => {
    document.body.innerHTML = html.replace('<phong-viewer', '<phong-viewer class="small"');
    document.querySelector<HTMLElement>('phong-viewer')!.style.cssText = 'width: 120px; height: 90px';
  }, box);
  await nextFrame(page);
  expect(compare(await pixels(page.locator('phong-viewer')), small).max).toBe(0);
});

test('a picture that gets far larger than the GPU allows keeps its shape', async ({ mount, page }) => {
  test.slow();
  const viewer = await mount(box.repeat(2), SIZE);
  for (const [width, height] of [
    [20000, 100],
    [9000, 9000],
  ] as const) {
    await viewer.evaluate((element, [w, h]) => (element.style.cssText = `width: ${w}px; height: ${h}px`), [
      width,
      height,
    ] as const);
    await nextFrame(page);
    const [w, h] = await viewer.evaluate((element: PhongViewer) => {
      const canvas = element.shadowRoot!.querySelector('canvas')!;
      return [canvas.width, canvas.height] as const;
    });
    const most = Math.sqrt(((await fourScreens(page)) * width) / height);
    expect(w).toBeGreaterThanOrEqual(Math.min(4096, 0.99 * most));
    expect(w).toBeLessThan(width);
    expect(Math.abs(w / h / (width / height) - 1)).toBeLessThan(0.03); // whole pixels
  }
});
