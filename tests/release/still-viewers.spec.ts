// The long form of element/frames/still-films.spec.ts: fifty viewers with `antialias="full"` on a page. That those out
// of view wait is in still-losses.spec.ts.

import type { Page } from '@playwright/test';
import { countEverything, countsOf, NOTHING, spentIn } from '../element/support/counting.js';
import type { PhongViewer } from '../element/support/viewer.js';
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

test('@release fifty viewers converge, each of them once, and then nothing runs', async ({ page, mount }) => {
  test.setTimeout(300_000);
  await countEverything(page);
  await countFloats(page);
  const kinds = ['box', 'sphere', 'cone', 'torus', 'teapot'];
  const markup = Array.from({ length: 50 }, (_, i) => {
    const attributes = `alt="" antialias="full" samples="16" geometry="${kinds[i % 5]!}"`;
    return `<phong-viewer ${attributes}><phong-light></phong-light></phong-viewer>`;
  });
  await mount(markup.join(''), { width: 64, height: 48, css: 'phong-viewer { float: left }' });
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
  const { textures, framebuffers, renderbuffers } = before;
  expect(await countsOf(page)).toMatchObject({ textures, framebuffers, renderbuffers, contexts: 1 });
  const floats = await page.evaluate(() => {
    const { live, ...rest } = Reflect.get(window, 'floats') as { readonly live: Set<unknown> };
    return { ...rest, live: live.size };
  });
  expect(floats, 'one sum in two buffers, freed at the end').toEqual({ live: 0, most: 2, pixels: 64 * 48 });
});
