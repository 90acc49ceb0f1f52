// The long forms of element/page/viewers.spec.ts and leaks.spec.ts: two hundred viewers on a page,
// a long scroll, a thousand that come and go. And of element/frames/still-films.spec.ts: fifty
// viewers with `antialias="full"`. That those out of view wait is in still-losses.spec.ts.

import type { Page } from '@playwright/test';
import { expect, test } from '../support/test.js';
import { countEverything, countsOf, expectIdle } from '../element/support/counting.js';
import {
  comeAndGo,
  holdContext,
  Ledger,
  loseAndRestore,
  redsShown,
  reddening,
  scrollThrough,
} from '../element/page/many-viewers.js';
import { type PhongViewer, statsOf } from '../element/support/viewer.js';

const small = { width: 60, height: 40, css: 'phong-viewer { float: left }' };

test.beforeEach(({ page }) => {
  test.setTimeout(600_000);
  return countEverything(page);
});

test('@release two hundred viewers share one context, come back when it is lost, and rest', async ({
  page,
  mount,
}) => {
  await holdContext(page);
  const viewer = await mount(reddening(200), small);
  expect(await countsOf(page)).toMatchObject({ contexts: 1, copies: 200, observers: 3 });
  expect((await statsOf(viewer)).viewersDrawn).toBe(200);
  const reds = await redsShown(page);
  // Codes 0 to 255 in two hundred steps, each of which the light shortens.
  expect(reds.every((red, i) => red >= (reds[i - 1] ?? -1))).toBe(true);
  expect(new Set(reds).size).toBeGreaterThan(100);
  await loseAndRestore(page, page.locator('phong-viewer'));
  expect(await redsShown(page)).toEqual(reds);
  await expectIdle(page, 2000);
});

test('@release four hundred viewers are scrolled through in bounded memory', async ({
  page,
  mount,
}) => {
  await scrollThrough(page, mount, 400);
});

test('@release a thousand viewers come and go and leave nothing behind', async ({
  page,
  mount,
}) => {
  await mount('<phong-viewer geometry="box"></phong-viewer>', small);
  const kinds = [
    '<phong-viewer src="/fixtures/models/textured.glb"></phong-viewer>',
    '<phong-viewer geometry="sphere" shading="flat" gui></phong-viewer>',
    '<phong-viewer color-interpolation="linear" auto-rotate="9"><phong-light></phong-light><phong-mesh geometry="torus"></phong-mesh></phong-viewer>',
    '<phong-viewer geometry="teapot" shading="gouraud" reflection="blinn-phong"></phong-viewer>',
    '<phong-viewer src="/assets/models/bunny.glb" terms="diffuse"></phong-viewer>',
  ];
  const ledger = await Ledger.of(page);
  for (let round = 0; round < 4; round++) {
    await comeAndGo(page, kinds, 50); // until the browser has compiled what is hot
  }
  // The one that stays is drawn again as others come and go, and gets a program for exactly its
  // lights: now rather than meanwhile.
  await page.evaluate(async () => {
    for (let frame = 0; frame < 60; frame++) {
      document.querySelector<PhongViewer>('phong-viewer')!.requestRender();
      await new Promise(requestAnimationFrame);
    }
  });
  const before = { ...(await ledger.read()), heap: await ledger.heap() };
  for (let round = 0; round < 16; round++) {
    await comeAndGo(page, kinds, 50);
  }
  await page.waitForTimeout(2000); // levels of round shapes stay for a second without a user
  const { counts, objects } = await ledger.read();
  const heap = await ledger.heap();
  expect(counts).toEqual(before.counts);
  expect(objects).toEqual(before.objects);
  console.log(`heap: ${before.heap} bytes after 200, ${heap} after 1000`);
  // 334 bytes each were measured, most of them what the engine learns of functions. No viewer is
  // that small.
  expect(heap - before.heap).toBeLessThan(400 * 1024);
});

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

test('@release fifty viewers converge, each of them once, and then nothing runs', async ({
  page,
  mount,
}) => {
  await countFloats(page);
  const kinds = ['box', 'sphere', 'cone', 'torus', 'teapot'];
  const markup = Array.from({ length: 50 }, (_, i) => {
    const attributes = `alt="" antialias="full" samples="16" geometry="${kinds[i % 5]!}"`;
    return `<phong-viewer ${attributes}><phong-light></phong-light></phong-viewer>`;
  });
  await mount(markup.join(''), { width: 64, height: 48, css: 'phong-viewer { float: left }' });
  await page.waitForTimeout(KEPT_MS);
  await expectIdle(page, 1000);
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
  await expectIdle(page, 1000);
  const { textures, framebuffers, renderbuffers } = before;
  expect(await countsOf(page)).toMatchObject({
    textures,
    framebuffers,
    renderbuffers,
    contexts: 1,
  });
  const floats = await page.evaluate(() => {
    const { live, ...rest } = Reflect.get(window, 'floats') as { readonly live: Set<unknown> };
    return { ...rest, live: live.size };
  });
  expect(floats, 'one sum in two buffers, freed at the end').toEqual({
    live: 0,
    most: 2,
    pixels: 64 * 48,
  });
});
