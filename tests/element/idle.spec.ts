// Does nothing happen while nothing changes? The page's frames, timers and WebGL calls are counted by wrapping them before
// any script runs; Playwright's own waiting happens outside the page.

import type { Page } from '@playwright/test';
import { allReady, expect, test } from '../support/test.js';
import { assign, drag, nextFrame, type PhongViewer, record } from './support.js';

const size = { width: 90, height: 60 };
const light = '<phong-light position="1 2 3 0"></phong-light>';
const box = `<phong-viewer geometry="box">${light}</phong-viewer>`;

test.beforeEach(async ({ page }) => {
  await page.addInitScript(() => {
    const counts = { frames: 0, timers: 0, gl: 0, contexts: 0 };
    Object.assign(window, { counts });
    const counted = <F extends (...given: never[]) => unknown>(real: F, key: keyof typeof counts): F =>
      function (this: unknown, ...given: never[]) {
        counts[key] += 1;
        return Reflect.apply(real, this, given) as unknown;
      } as unknown as F;
    window.requestAnimationFrame = counted(window.requestAnimationFrame, 'frames');
    for (const name of ['setTimeout', 'setInterval'] as const)
      Reflect.set(window, name, counted(window[name] as (...given: never[]) => unknown, 'timers'));
    if ('requestIdleCallback' in window)
      window.requestIdleCallback = counted(window.requestIdleCallback, 'timers');
    const gl = WebGL2RenderingContext.prototype;
    for (const name of Object.getOwnPropertyNames(gl)) {
      const real = Object.getOwnPropertyDescriptor(gl, name)?.value as unknown;
      if (typeof real === 'function') Reflect.set(gl, name, counted(real as () => unknown, 'gl'));
    }
    const canvas = HTMLCanvasElement.prototype;
    const contextOf = canvas.getContext;
    const seen = new Set<unknown>();
    canvas.getContext = function (this: HTMLCanvasElement, ...given: never[]) {
      const context: unknown = Reflect.apply(contextOf, this, given);
      if (context instanceof WebGL2RenderingContext && !seen.has(context))
        counts.contexts = seen.add(context).size;
      return context;
    } as typeof contextOf;
  });
});

interface Counts {
  readonly frames: number;
  readonly timers: number;
  readonly gl: number;
  readonly contexts: number;
}

const countsOf = (page: Page): Promise<Counts> => page.evaluate('({ ...window.counts })');

/** What the page does in a second, which is waited for outside of it. */
async function inASecond(page: Page): Promise<Omit<Counts, 'contexts'>> {
  const before = await countsOf(page);
  await new Promise((resolve) => setTimeout(resolve, 1000));
  const after = await countsOf(page);
  return {
    frames: after.frames - before.frames,
    timers: after.timers - before.timers,
    gl: after.gl - before.gl,
  };
}

const nothing = { frames: 0, timers: 0, gl: 0 };

test('nothing at all happens while nothing changes, after a drag too', async ({ page, mount }) => {
  const viewer = await mount(`${box}${box}`, size);
  await nextFrame(page);
  expect(await inASecond(page)).toEqual(nothing);
  await drag(page, [45, 30], [20, 10]);
  await page.mouse.move(500, 500);
  await page.keyboard.press('ArrowLeft');
  await allReady(page);
  await nextFrame(page);
  expect(await inASecond(page)).toEqual(nothing);
  await viewer.evaluate((element: PhongViewer) => element.lights[0]?.remove());
  await allReady(page);
  await nextFrame(page);
  expect(await inASecond(page)).toEqual(nothing);
});

test('nothing happens off screen, not displayed or out of the document, with auto-rotate too', async ({
  page,
  mount,
}) => {
  const viewer = await mount(box, size);
  await assign(viewer, { autoRotate: 45 });
  expect((await inASecond(page)).frames).toBeGreaterThan(1);
  for (const css of ['position: absolute; top: 9000px', 'display: none', 'width: 0; height: 0']) {
    await viewer.evaluate((element, text) => (element.style.cssText = text), css);
    await nextFrame(page);
    await nextFrame(page);
    await viewer.evaluate((element: PhongViewer) => (element.lights[0]!.diffuse = [1, 2, 3]));
    expect(await inASecond(page), css).toEqual(nothing);
  }
  await viewer.evaluate((element) => (element.style.cssText = ''));
  expect((await inASecond(page)).frames).toBeGreaterThan(1);
  await viewer.evaluate((element) => element.remove());
  await nextFrame(page);
  expect(await inASecond(page)).toEqual(nothing);
});

test('many changes in one task make one frame', async ({ page, mount }) => {
  const viewer = await mount(`${box}${box}`, size);
  const renders = await record(viewer, 'render');
  await nextFrame(page);
  const before = await countsOf(page);
  await viewer.evaluate((element: PhongViewer) => {
    for (let i = 0; i < 50; i++) {
      element.theta = i;
      element.kd = [i, i, i];
      element.lights[0]!.diffuse = [i, i, i];
      element.lights[0]!.setAttribute('cutoff', String(i));
      element.append(document.createElement('phong-light'));
    }
    const other = element.nextElementSibling as PhongViewer;
    other.theta = 3;
  });
  await allReady(page);
  expect((await countsOf(page)).frames - before.frames).toBe(1);
  expect((await renders.take()).length).toBe(1);
});

test('a change that changes nothing draws nothing', async ({ page, mount }) => {
  const viewer = await mount(box, size);
  await nextFrame(page);
  const before = await countsOf(page);
  await viewer.evaluate((element: PhongViewer) => {
    element.theta = 30;
    element.lights[0]!.position = [1, 2, 3, 0];
    element.setAttribute('alt', 'A box');
  });
  await new Promise((resolve) => setTimeout(resolve, 200));
  expect((await countsOf(page)).gl - before.gl).toBe(0);
});

for (const count of [2, 20]) {
  test(`${count} viewers share one WebGL context, and each shows its own picture`, async ({
    page,
    mount,
  }) => {
    const viewers = Array.from({ length: count }, (_, i) => box.replace('<phong-viewer', `<phong-viewer ka="0" kd="${i * 10} 0 0" terms="diffuse"`)); // prettier-ignore
    await mount(viewers.join(''), { ...size, css: 'phong-viewer { float: left }' });
    expect((await countsOf(page)).contexts).toBe(1);
    const reds = await page.evaluate(() =>
      [...document.querySelectorAll('phong-viewer')].map(({ shadowRoot }) => {
        const canvas = shadowRoot?.querySelector('canvas');
        return canvas?.getContext('2d')?.getImageData(45, 35, 1, 1).data[0] ?? -1;
      }),
    );
    expect(reds.every((red, i) => i === 0 || red > reds[i - 1]!)).toBe(true);
    await page.evaluate(() => {
      for (const viewer of document.querySelectorAll('phong-viewer')) viewer.remove();
    });
    await nextFrame(page);
    expect(await inASecond(page)).toEqual(nothing);
  });
}

test('a viewer alone on its page shows the WebGL canvas itself, and again when it is left alone', async ({
  page,
  mount,
}) => {
  const viewer = await mount(box, size);
  const direct = (): Promise<boolean> =>
    viewer.evaluate((element: PhongViewer) => element.shadowRoot?.querySelector('canvas')?.getContext('webgl2') instanceof WebGL2RenderingContext); // prettier-ignore
  expect(await direct()).toBe(true);
  const alone = await viewer.screenshot();
  await page.evaluate(
    (html) => document.body.insertAdjacentHTML('beforeend', html),
    box.replace('box', 'torus'),
  );
  await allReady(page);
  await nextFrame(page);
  expect(await direct()).toBe(false);
  expect(Buffer.compare(await viewer.screenshot(), alone)).toBe(0);
  await page.evaluate(() => document.querySelector('phong-viewer:last-of-type')?.remove());
  await allReady(page);
  await nextFrame(page);
  expect(await direct()).toBe(true);
  expect(Buffer.compare(await viewer.screenshot(), alone)).toBe(0);
});
