// The long forms of element/page/viewers.spec.ts and leaks.spec.ts: two hundred viewers on a page, a long scroll, a
// thousand that come and go.

import { expect, test } from '../support/test.js';
import { countEverything, countsOf, NOTHING, spentIn } from '../element/support/counting.js';
import { comeAndGo, holdContext, Ledger, loseAndRestore, redsShown, reddening, scrollThrough } from '../element/page/many-viewers.js'; // prettier-ignore
import { nextFrame, type PhongViewer, statsOf } from '../element/support/viewer.js';

const small = { width: 60, height: 40, css: 'phong-viewer { float: left }' };

test.beforeEach(({ page }) => {
  test.setTimeout(600_000);
  return countEverything(page);
});

test('@release two hundred viewers share one context, come back when it is lost, and rest', async ({ page, mount }) => {
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
  expect(await spentIn(page, 2000)).toEqual(NOTHING);
});

test('@release four hundred viewers are scrolled through in bounded memory', async ({ page, mount }) => {
  await scrollThrough(page, mount, 400);
});

test('@release a thousand viewers come and go and leave nothing behind', async ({ page, mount }) => {
  await mount('<phong-viewer geometry="box"></phong-viewer>', small);
  const kinds = [
    '<phong-viewer src="/fixtures/models/textured.glb"></phong-viewer>',
    '<phong-viewer geometry="sphere" shading="flat" gui></phong-viewer>',
    '<phong-viewer color-interpolation="linear" auto-rotate="9"><phong-light></phong-light><phong-mesh geometry="torus"></phong-mesh></phong-viewer>',
    '<phong-viewer geometry="teapot" shading="gouraud" reflection="blinn-phong"></phong-viewer>',
    '<phong-viewer src="/assets/models/bunny.glb" terms="diffuse"></phong-viewer>',
  ];
  const ledger = await Ledger.of(page);
  for (let round = 0; round < 4; round++) await comeAndGo(page, kinds, 50); // until the browser has compiled what is hot
  // The one that stays is drawn again as others come and go, and gets a program for exactly its lights: now rather than
  // meanwhile.
  await page.evaluate(async () => {
    for (let frame = 0; frame < 60; frame++) {
      document.querySelector<PhongViewer>('phong-viewer')!.requestRender();
      await new Promise(requestAnimationFrame);
    }
  });
  const before = await ledger.read();
  for (let round = 0; round < 16; round++) await comeAndGo(page, kinds, 50);
  await nextFrame(page);
  const { counts, objects, heap } = await ledger.read();
  expect(counts).toEqual(before.counts);
  expect(objects).toEqual(before.objects);
  console.log(`heap: ${before.heap} bytes after 200, ${heap} after 1000`);
  // Counting from outside and compiling take some: 5 to 620 bytes each were measured. No viewer is that small.
  expect(heap - before.heap).toBeLessThan(800 * 1024);
});
