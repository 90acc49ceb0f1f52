// Where are compressed models and KTX2 textures unpacked? In one worker for any number of models,
// by WebAssembly, or on the main thread if it cannot start or may not compile, with the same bits.
// The worker ends after an abort or an idle time. The tests' server allows its files no
// WebAssembly; `shown` mounts from one that does.

import type { Page } from '@playwright/test';
import type { BufferGeometry } from 'three';
import {
  type ViewerLocator,
  compare,
  expect,
  pixels,
  strictPolicy,
  same,
  test,
} from '../../support/test.js';
import { startSite, testMounts, wasmPolicy } from '../../support/site.js';
import { dracoGlb } from '../../fuzz/models.js';
import { settled } from '../../element/support/viewer.js';
import { requestsOf } from '../../support/requests.js';

const engine = '/assets/models/real/engine/2CylinderEngine.gltf';
const bunny = '/assets/models/bunny.glb';
const scene = `<phong-viewer src="${bunny}"></phong-viewer>`;
const size = { width: 90, height: 60 };
const workerFile = /\/draco-worker[^/]*\.js$/;

const allowing = await startSite(testMounts, wasmPolicy);
test.afterAll(() => allowing.close());

/** Mounts where WebAssembly is allowed, in workers too. */
async function shown(page: Page, markup: string) {
  const head = '<script type="module" src="/dist/phong-viewer.standalone.js"></script>';
  await page.goto(allowing.page(markup, { csp: wasmPolicy, head }));
  await page.evaluate(() => customElements.whenDefined('phong-viewer').then(() => undefined));
  return page.locator('phong-viewer');
}

/** `load`, or the code and message of the error. */
const outcomeOf = (viewer: ViewerLocator, src: string) =>
  viewer.evaluate(
    (element, address) =>
      new Promise<string>((resolve) => {
        element.addEventListener('error', ({ detail }) =>
          resolve(`${detail.code}: ${detail.message}`),
        );
        element.addEventListener('load', () => resolve('load'));
        element.src = address;
      }),
    src,
  );

/** A hash of each array of each geometry. */
const fingerprint = (viewer: ViewerLocator): Promise<readonly string[]> =>
  viewer.evaluate((element) => {
    const found: string[] = [];
    element.scene.traverse((object) => {
      const { geometry } = object as { geometry?: BufferGeometry };
      if (geometry === undefined) return;
      for (const [name, { array }] of Object.entries({
        ...geometry.attributes,
        index: geometry.index!,
      })) {
        let hash = 0;
        for (const byte of new Uint8Array(array.buffer)) {
          hash = (Math.imul(hash, 31) + byte) | 0;
        }
        found.push(`${name} ${array.constructor.name} ${array.length} ${hash}`);
      }
    });
    return found;
  });

const loaded = (viewer: ViewerLocator) => viewer.evaluate((element) => element.loaded);

/** Every worker that has started on the page. */
function workersOf(page: Page): readonly string[] {
  const started: string[] = [];
  page.on('worker', (worker) => started.push(worker.url()));
  return started;
}

test('a model is the same from WebAssembly in a worker and without it on the main thread', async ({
  page,
  mount,
}) => {
  const started = workersOf(page);
  const meshes = `<phong-viewer src="${bunny}"><phong-mesh src="${engine}"></phong-mesh></phong-viewer>`;
  const first = await shown(page, meshes);
  await settled(first);
  const compiled = await fingerprint(first);
  expect(compiled.length).toBeGreaterThan(34);
  expect(started).toEqual([expect.stringMatching(workerFile)]);

  const requested = requestsOf(page);
  expect(await fingerprint(await mount(meshes, size))).toEqual(compiled);
  // Asked for with the worker, which ends that where it is refused. Not by the worker.
  expect(requested.filter((url) => /draco[a-z_-]*decoder/.test(url))).toHaveLength(1);

  await page.route(workerFile, (route) => route.abort());
  const alone = await fingerprint(await mount(scene, size));
  expect(alone.length).toBeGreaterThan(2);
  expect(compiled.slice(0, alone.length)).toEqual(alone);
});

test('the main thread stands in for missing WebAssembly and refused workers', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/worker-src/);
  consoleGuard.allow(/404/);
  await page.route(/draco_decoder\.wasm$/, (route) => route.fulfill({ status: 404 }));
  const viewer = await shown(page, scene);
  await settled(viewer);
  expect(await loaded(viewer)).toBe(true);
  const workerless = await mount(scene, { ...size, csp: `${strictPolicy}; worker-src 'none'` });
  expect(await loaded(workerless)).toBe(true);
});

test('damaged data give the same error from both', async ({ page, site, mount }) => {
  const damaged = dracoGlb(1, 3, { faces: 1, points: 3 });
  const worked = await shown(page, '<phong-viewer></phong-viewer>');
  const threaded = await outcomeOf(worked, allowing.file(damaged));
  expect(threaded).toMatch(/^bad-model: .*Draco data/);
  const empty = await mount('<phong-viewer></phong-viewer>', size);
  // Each address is named in the message.
  const name = /\([^()]*\)\.?$/;
  expect((await outcomeOf(empty, site.file(damaged))).replace(name, '')).toBe(
    threaded.replace(name, ''),
  );
});

test('the worker starts while the meshes are still being downloaded', async ({ page }) => {
  const starting = page.waitForEvent('worker');
  await page.route('**/*.bin', async (route) => {
    await starting;
    await route.continue();
  });
  const viewer = await shown(page, `<phong-viewer src="${engine}"></phong-viewer>`);
  await settled(viewer);
  expect(await loaded(viewer)).toBe(true);
});

test('removing the viewer terminates a busy worker, and the next model gets a new one', async ({
  page,
}) => {
  const started = workersOf(page);
  const starting = page.waitForEvent('worker', (worker) => workerFile.test(worker.url()));
  await shown(page, scene);
  const worker = await starting;
  const ended = worker.waitForEvent('close');
  await page.evaluate(() => document.querySelector('phong-viewer')?.remove());
  await ended;
  await page.evaluate((src) => {
    const viewer = document.createElement('phong-viewer');
    viewer.alt = 'A bunny';
    viewer.src = src;
    document.body.append(viewer);
  }, bunny);
  const viewer = page.locator('phong-viewer');
  await settled(viewer);
  expect(await loaded(viewer)).toBe(true);
  expect(started.filter((url) => workerFile.test(url))).toHaveLength(2);
});

test('an idle worker ends', async ({ page }) => {
  await page.clock.install();
  const starting = page.waitForEvent('worker', (worker) => workerFile.test(worker.url()));
  const viewer = await shown(page, scene);
  const worker = await starting;
  const ended = worker.waitForEvent('close');
  await settled(viewer);
  expect(page.workers()).toHaveLength(1);
  await page.clock.fastForward(6000);
  await ended;
});

test.describe('a KTX2 texture', () => {
  // textured.glb has the same texels in a PNG.
  const ktx2 = { width: 120, height: 90, csp: wasmPolicy };
  const model = (name: string) => `/fixtures/models/${name}`;
  const sceneOf = (name: string) =>
    `<phong-viewer src="${model(name)}" theta="0" phi="90" ka="255" kd="0" ks="0">
      <phong-light ambient="255 255 255"></phong-light></phong-viewer>`;

  test('from the worker has exactly the texels of its file', async ({ page }) => {
    const pictureOf = async (name: string) => {
      const viewer = await shown(page, sceneOf(name));
      await settled(viewer);
      return pixels(viewer, { width: 120, height: 90 });
    };
    const [started, requested] = [workersOf(page), requestsOf(page)];
    const png = await pictureOf('textured.glb');
    expect(started).toHaveLength(0);
    expect(requested.filter((url) => /ktx2|basis/.test(url))).toEqual([]);
    same(await pictureOf('ktx2.glb'), png);
    expect(started).toEqual([expect.stringMatching(/ktx2-worker/)]);
    // ETC1S is lossy: five bits per channel.
    expect(compare(await pictureOf('ktx2-etc1s.glb'), png).max).toBeLessThan(12);
  });

  test('is the same from the main thread if workers lack WebAssembly; shadeAt reads it', async ({
    page,
    mount,
  }) => {
    const png = await pixels(await mount(sceneOf('textured.glb'), ktx2));
    const requested = requestsOf(page);
    const viewer = await mount(sceneOf('ktx2.glb'), ktx2);
    // One file is both: the worker asks for it first, then the page.
    const ofDecoder = () => requested.filter((url) => /ktx2-worker/.test(url)).length;
    await expect.poll(ofDecoder).toBe(2);
    same(await pixels(viewer), png);
    const color = await viewer.evaluate(async (element) => (await element.shadeAt(50, 40))?.color);
    expect(color?.map((channel) => Math.round(channel * 1e9) / 1e9)).toEqual([1, 0, 0]);
  });

  test('under a policy without WebAssembly gives an error that says what to allow', async ({
    mount,
    consoleGuard,
  }) => {
    consoleGuard.allow(/wasm|WebAssembly/);
    const viewer = await mount('<phong-viewer></phong-viewer>', size);
    expect(await outcomeOf(viewer, model('ktx2.glb'))).toMatch(/^csp: .*KTX2.*'wasm-unsafe-eval'/);
  });

  test('that is damaged is left out; a missing transcoder is fetched again', async ({
    page,
    mount,
    consoleGuard,
  }) => {
    consoleGuard.allow(
      /ktx2-damaged\.glb is shown without 1 .* images\[0\] is a damaged KTX2 file/,
      1,
    );
    consoleGuard.allow(/error: Failed to load resource/);
    const viewer = await mount('<phong-viewer></phong-viewer>', ktx2);
    await page.route(/\.wasm$/, (route) => route.abort());
    expect(await outcomeOf(viewer, model('ktx2.glb'))).toMatch(
      /^load-failed: The decoder of KTX2 textures/,
    );
    await page.unroute(/\.wasm$/);
    expect(await outcomeOf(viewer, model('ktx2-damaged.glb'))).toBe('load');
    expect(await outcomeOf(viewer, model('ktx2.glb'))).toBe('load');
  });
});
