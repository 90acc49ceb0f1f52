// The long form of element/frames/still-films.spec.ts: fifty viewers with `antialias="full"` on a page.

import type { Page } from '@playwright/test';
import { countEverything, countsOf, NOTHING, spentIn } from '../element/support/counting.js';
import { nextFrame, type PhongViewer } from '../element/support/viewer.js';
import { expect, test } from '../support/test.js';

/** Float buffers are kept for a second, and freed within this time. */
const KEPT_MS = 1200;

/** Live float targets are counted on pages of this context that are opened later. */
const countFloats = (page: Page): Promise<unknown> =>
  page.addInitScript(() => {
    const { prototype } = WebGL2RenderingContext;
    const floats = { live: new Set<unknown>(), most: 0, pixels: 0 };
    Object.assign(window, { floats });
    type Call = (this: WebGL2RenderingContext, ...given: never[]) => unknown;
    const allocate: Call = prototype.texImage2D;
    const remove: Call = prototype.deleteTexture;
    const count: Call = function (...given: readonly number[]) {
      const [, , format, width = 0, height = 0] = given;
      if (format === this.RGBA32F) {
        floats.live.add(this.getParameter(this.TEXTURE_BINDING_2D));
        floats.most = Math.max(floats.most, floats.live.size);
        floats.pixels = Math.max(floats.pixels, width * height);
      }
      allocate.apply(this, given as never[]);
    };
    const forget: Call = function (...given: readonly unknown[]) {
      floats.live.delete(given[0]);
      remove.apply(this, given as never[]);
    };
    Object.assign(prototype, { texImage2D: count, deleteTexture: forget });
  });

const samplesOf = (page: Page): Promise<readonly number[]> =>
  page.evaluate(() =>
    [...document.querySelectorAll<PhongViewer>('phong-viewer')].map(({ stats }) => stats.samples),
  );

test('@release fifty viewers converge, each of them once, and then nothing runs', async ({ page, mount }) => {
  test.setTimeout(300_000);
  await countEverything(page);
  await countFloats(page);
  const kinds = ['box', 'sphere', 'cone', 'torus', 'teapot'];
  const markup = Array.from(
    { length: 50 },
    (_, i) =>
      `<phong-viewer alt="" antialias="full" samples="16" geometry="${kinds[i % 5]!}"><phong-light></phong-light></phong-viewer>`,
  );
  await mount(markup.join(''), { width: 64, height: 48, css: 'phong-viewer { float: left }' });
  expect(await samplesOf(page)).toEqual(markup.map(() => 16));
  await page.waitForTimeout(KEPT_MS);
  expect(await spentIn(page, 1000)).toEqual(NOTHING);
  const before = await countsOf(page);
  const order = await page.evaluate(async () => {
    const viewers = [...document.querySelectorAll<PhongViewer>('phong-viewer')];
    const finished: number[] = [];
    viewers.forEach((viewer, i) => {
      viewer.addEventListener('render', () => viewer.stats.samples === 16 && finished.push(i));
      viewer.theta += 20;
    });
    await Promise.all(viewers.map(({ ready }) => ready));
    return finished;
  });
  expect(order, 'each one finishes once, from the top').toEqual(markup.map((_, i) => i));
  await page.waitForTimeout(KEPT_MS);
  expect(await spentIn(page, 1000)).toEqual(NOTHING);
  const { textures, framebuffers, renderbuffers, contexts } = await countsOf(page);
  expect({ textures, framebuffers, renderbuffers, contexts }).toEqual({
    textures: before.textures,
    framebuffers: before.framebuffers,
    renderbuffers: before.renderbuffers,
    contexts: 1,
  });
  const floats = await page.evaluate(() => {
    const { live, most, pixels } = Reflect.get(window, 'floats') as {
      live: Set<unknown>;
      most: number;
      pixels: number;
    };
    return { live: live.size, most, pixels };
  });
  expect(floats, 'one sum in two buffers, freed at the end').toEqual({ live: 0, most: 2, pixels: 64 * 48 });
});

test('@release of fifty viewers those that are scrolled away stop, and those that come into view converge', async ({
  page,
  mount,
}) => {
  test.setTimeout(300_000);
  await countEverything(page);
  const viewer =
    '<phong-viewer alt="" antialias="full" samples="16" geometry="torus"><phong-light></phong-light></phong-viewer>';
  const half = viewer.repeat(25);
  await mount(`${half}<div></div>${half}`, {
    width: 64,
    height: 48,
    css: 'phong-viewer { float: left } div { clear: both; height: 6000px }',
  });
  const order = await page.evaluate(async () => {
    const viewers = [...document.querySelectorAll<PhongViewer>('phong-viewer')];
    const finished: number[] = [];
    viewers.forEach((one, i) => {
      one.addEventListener('render', () => one.stats.samples === 16 && finished.push(i));
      one.theta += 20;
    });
    while (finished.length < 5) await new Promise(requestAnimationFrame);
    scrollTo(0, 6000);
    while (!finished.includes(49)) await new Promise(requestAnimationFrame);
    return finished;
  });
  const above = order.filter((i) => i < 25);
  expect(above.length, 'they stop').toBeLessThan(20);
  expect(above).toEqual(above.map((_, i) => i));
  expect(order.slice(above.length)).toEqual(Array.from({ length: 25 }, (_, i) => 25 + i));
  await nextFrame(page);
  expect(await spentIn(page, 500)).toEqual(NOTHING);
  await page.evaluate(() => scrollTo(0, 0));
  await expect.poll(() => samplesOf(page), { timeout: 60_000 }).toEqual(Array.from({ length: 50 }, () => 16));
  await nextFrame(page);
  expect(await spentIn(page, 500)).toEqual(NOTHING);
});
