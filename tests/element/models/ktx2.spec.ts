// Do KTX2 textures have the right texels, from the worker and from the main thread, and is there a clear error without
// WebAssembly? textured.glb has the same texels in a PNG.

import type { Locator, Page } from '@playwright/test';
import { compare, expect, pixels, test, type Picture } from '../../support/test.js';
import { startSite, testMounts, wasmPolicy } from '../../support/site.js';
import { type PhongViewer } from '../support/viewer.js';

const model = (name: string): string => `/fixtures/models/${name}`;
const size = { width: 120, height: 90 };
const sceneOf = (name: string): string =>
  `<phong-viewer src="${model(name)}" theta="0" phi="90" ka="255" kd="0" ks="0">
    <phong-light ambient="255 255 255"></phong-light></phong-viewer>`;

const failure = (viewer: Locator, src: string): Promise<string> =>
  viewer.evaluate(
    (element: PhongViewer, address) =>
      new Promise<string>((resolve) => {
        element.addEventListener('error', ({ detail }) => resolve(`${detail.code}: ${detail.message}`));
        element.addEventListener('load', () => resolve('load'));
        element.src = address;
      }),
    src,
  );

/** The picture of a model from a server whose files, workers among them, allow WebAssembly too. */
async function pictureFrom(page: Page, name: string): Promise<Picture> {
  const site = await startSite(testMounts, wasmPolicy);
  await page.goto(
    site.page(sceneOf(name), {
      csp: wasmPolicy,
      css: `body { margin: 0 } phong-viewer { display: block; width: ${size.width}px; height: ${size.height}px }`,
      head: '<script type="module" src="/dist/phong-viewer.standalone.js"></script>',
    }),
  );
  const viewer = page.locator('phong-viewer');
  await viewer.evaluate(async (element: PhongViewer) => {
    await customElements.whenDefined('phong-viewer');
    await element.ready;
  });
  const picture = await pixels(viewer);
  await site.close();
  return picture;
}

test('a texture from the worker has exactly the texels of its file', async ({ page }) => {
  const started: string[] = [];
  page.on('worker', (worker) => started.push(worker.url()));
  const requests: string[] = [];
  page.on('request', (request) => requests.push(request.url()));
  const png = await pictureFrom(page, 'textured.glb');
  expect(started).toHaveLength(0);
  expect(requests.filter((url) => /ktx2|basis/.test(url))).toEqual([]);
  expect(compare(await pictureFrom(page, 'ktx2.glb'), png).max).toBe(0);
  expect(started).toEqual([expect.stringMatching(/ktx2-worker/)]);
  // ETC1S is lossy: five bits per channel.
  expect(compare(await pictureFrom(page, 'ktx2-etc1s.glb'), png).max).toBeLessThan(12);
});

test('a texture is the same from the main thread, if the worker may not use WebAssembly', async ({
  page,
  mount,
}) => {
  const png = await pixels(await mount(sceneOf('textured.glb'), size));
  const code = page.waitForRequest(/\/ktx2-(?!worker)[^/]*\.js$/);
  const ktx2 = await pixels(await mount(sceneOf('ktx2.glb'), { ...size, csp: wasmPolicy }));
  await code;
  expect(compare(ktx2, png).max).toBe(0);
});

test('a policy without WebAssembly gives an error that says what to allow', async ({
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/wasm|WebAssembly/);
  const viewer = await mount('<phong-viewer></phong-viewer>', size);
  expect(await failure(viewer, model('ktx2.glb'))).toMatch(/^csp: .*KTX2.*'wasm-unsafe-eval'/);
});

test('a damaged texture is left out with a warning, and the next one is shown', async ({
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/ktx2-damaged\.glb is shown without 1 .* images\[0\] is a damaged KTX2 file/, 1);
  const viewer = await mount('<phong-viewer></phong-viewer>', { ...size, csp: wasmPolicy });
  expect(await failure(viewer, model('ktx2-damaged.glb'))).toBe('load');
  expect(await failure(viewer, model('ktx2.glb'))).toBe('load');
});

test('a transcoder that could not be fetched is fetched again by the next use', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/error: Failed to load resource/);
  const viewer = await mount('<phong-viewer></phong-viewer>', { ...size, csp: wasmPolicy });
  await page.route(/\.wasm$/, (route) => route.abort());
  expect(await failure(viewer, model('ktx2.glb'))).toMatch(/^load-failed: The decoder of KTX2 textures/);
  await page.unroute(/\.wasm$/);
  expect(await failure(viewer, model('ktx2.glb'))).toBe('load');
});

test('shadeAt reads the texel', async ({ mount }) => {
  const viewer = await mount(sceneOf('ktx2.glb'), { ...size, csp: wasmPolicy });
  const color = await viewer.evaluate(async (element: PhongViewer) => (await element.shadeAt(50, 40))?.color);
  expect(color?.map((channel) => Math.round(channel * 1e9) / 1e9)).toEqual([1, 0, 0]);
});
