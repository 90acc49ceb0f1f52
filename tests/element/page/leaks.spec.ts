// Does a removed viewer leave anything behind: in the heap, on the GPU, among the page's listeners
// and observers?

import type { Page } from '@playwright/test';
import { findTestBrowser, softwareGl } from '../../../.ci/browser.mjs';
import { expect, test } from '../../support/test.js';
import { countEverything, countsOf } from '../support/counting.js';
import { comeAndGo, Ledger } from './many-viewers.js';
import { nextFrame, type PhongViewer } from '../support/viewer.js';

const size = { width: 90, height: 60, css: 'phong-viewer { float: left }' };
const stays =
  '<phong-viewer geometry="box"><phong-light position="1 2 3 0"></phong-light></phong-viewer>';
const kinds = [
  '<phong-viewer src="/fixtures/models/textured.glb"></phong-viewer>',
  '<phong-viewer geometry="sphere" shading="flat" gui></phong-viewer>',
  '<phong-viewer geometry="box" helpers="lights grid"><phong-light position="1 2 3 1"></phong-light></phong-viewer>',
  '<phong-viewer color-interpolation="linear" auto-rotate="9"><phong-light></phong-light><phong-mesh geometry="torus"></phong-mesh></phong-viewer>',
];

test.beforeEach(({ page }) => countEverything(page));

/** What the page holds of its GPU. */
async function held(page: Page): Promise<object> {
  const { contexts, textures, buffers, programs, vertexArrays } = await countsOf(page);
  return { contexts, textures, buffers, programs, vertexArrays };
}

// On a page composed by WebGL: composed without, a specialised program may keep waiting for its
// next frame, with its shaders.
const executablePath = await findTestBrowser();
test.use({
  launchOptions: { ...(executablePath === undefined ? {} : { executablePath }), args: softwareGl },
});

test('viewers that come and go leave nothing behind', async ({ page, mount }) => {
  test.slow();
  await mount(stays, size);
  const ledger = await Ledger.of(page);
  // The first viewers load what stays for good, such as the panel's code.
  await comeAndGo(page, kinds, kinds.length);
  const before = await ledger.read();
  await comeAndGo(page, kinds, 2 * kinds.length);
  const { counts, objects } = await ledger.read();
  expect(counts).toEqual(before.counts);
  expect(objects).toEqual(before.objects);
  expect(objects).toMatchObject({ viewers: 1, scenes: 1 });
});

test('a picture that converges again and again leaves nothing behind', async ({ page, mount }) => {
  const viewer = await mount(
    '<phong-viewer geometry="box" antialias="full" samples="16"><phong-light></phong-light></phong-viewer>',
    size,
  );
  const turn = (times: number): Promise<void> =>
    viewer.evaluate(async (element: PhongViewer, count) => {
      for (let i = 0; i < count; i++) {
        element.theta += 1;
        await element.ready;
      }
    }, times);
  const ledger = await Ledger.of(page);
  // Past the frames after which a specialised program comes.
  await turn(30);
  const before = await ledger.read();
  await turn(5);
  expect((await ledger.read()).objects).toEqual(before.objects);
});

test('moving a viewer on its page opens no context and uploads nothing', async ({
  page,
  mount,
}) => {
  const viewer = await mount(`${kinds[0]}${stays}<section></section>`, size);
  const before = await held(page);
  const shot = await viewer.screenshot();
  await viewer.evaluate(async (element: PhongViewer) => {
    const place = document.querySelector('section')!;
    for (let i = 0; i < 10; i++) {
      place.append(element);
      document.body.prepend(element);
      await element.ready;
    }
  });
  await nextFrame(page);
  expect(await held(page)).toEqual(before);
  expect(Buffer.compare(await viewer.screenshot(), shot)).toBe(0);
});
