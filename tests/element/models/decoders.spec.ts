// Where are compressed models unpacked? In one worker for any number of models, by WebAssembly, or on the main thread if
// it cannot start or may not compile, with the same bits. The worker ends after an abort or an idle time. The tests'
// server allows its files no WebAssembly; `shown` mounts from one that does.

import type { Locator, Page } from '@playwright/test';
import type { BufferGeometry } from 'three';
import { expect, strictPolicy, test } from '../../support/test.js';
import { startSite, testMounts, wasmPolicy } from '../../support/site.js';
import { dracoGlb } from '../../fuzz/models.js';
import { type PhongViewer, settled } from '../support/viewer.js';

const engine = '/assets/models/real/engine/2CylinderEngine.gltf';
const bunny = '/assets/models/bunny.glb';
const scene = `<phong-viewer src="${bunny}"></phong-viewer>`;
const size = { width: 90, height: 60 };
const workerFile = /\/draco-worker[^/]*\.js$/;

const allowing = await startSite(testMounts, wasmPolicy);
test.afterAll(() => allowing.close());

/** Mounts where WebAssembly is allowed. */
async function shown(page: Page, markup: string): Promise<Locator> {
  const head = '<script type="module" src="/dist/phong-viewer.standalone.js"></script>';
  await page.goto(allowing.page(markup, { csp: wasmPolicy, head }));
  await page.evaluate(() => customElements.whenDefined('phong-viewer').then(() => undefined));
  return page.locator('phong-viewer');
}

/** A hash of each array of each geometry. */
const fingerprint = (viewer: Locator): Promise<readonly string[]> =>
  viewer.evaluate((element: PhongViewer) => {
    const found: string[] = [];
    element.scene.traverse((object) => {
      const { geometry } = object as { geometry?: BufferGeometry };
      if (geometry === undefined) return;
      for (const [name, { array }] of Object.entries({ ...geometry.attributes, index: geometry.index! })) {
        let hash = 0;
        for (const byte of new Uint8Array(array.buffer)) hash = (Math.imul(hash, 31) + byte) | 0;
        found.push(`${name} ${array.constructor.name} ${array.length} ${hash}`);
      }
    });
    return found;
  });

const loaded = (viewer: Locator): Promise<boolean> =>
  viewer.evaluate((element: PhongViewer) => element.loaded);

/** Every worker that has started on the page. */
function workersOf(page: Page): readonly string[] {
  const started: string[] = [];
  page.on('worker', (worker) => started.push(worker.url()));
  return started;
}

/** Counts of files of the Draco decoder that the page has requested, by name. */
function requestsOf(page: Page): Readonly<Record<string, number>> {
  const counts: Record<string, number> = {};
  page.on('request', (request) => {
    const [name] = /draco[a-z_-]*(?=[-.])|draco_decoder(?=\.wasm)/.exec(request.url()) ?? [];
    if (name !== undefined) counts[name] = (counts[name] ?? 0) + 1;
  });
  return counts;
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
  // Refused before the file is fetched.
  expect(Object.keys(requested).filter((name) => name.includes('decoder'))).toEqual([]);

  await page.route(workerFile, (route) => route.abort());
  expect(await fingerprint(await mount(meshes, size))).toEqual(compiled);
});

test('the main thread stands in where the WebAssembly is missing', async ({ page }) => {
  await page.route(/draco_decoder\.wasm$/, (route) => route.fulfill({ status: 404 }));
  const viewer = await shown(page, scene);
  await settled(viewer);
  expect(await loaded(viewer)).toBe(true);
});

test('damaged data give the same error from both', async ({ page, site, mount }) => {
  const damaged = dracoGlb(1, 3, { faces: 1, points: 3 });
  const outcome = (viewer: Locator, address: string): Promise<string> =>
    viewer.evaluate(
      (element: PhongViewer, src) =>
        new Promise<string>((resolve) => {
          element.addEventListener('error', ({ detail }) => resolve(`${detail.code}: ${detail.message}`));
          element.src = src;
        }),
      address,
    );
  const threaded = await outcome(await shown(page, '<phong-viewer></phong-viewer>'), allowing.file(damaged));
  expect(threaded).toMatch(/^bad-model: .*Draco data/);
  const empty = await mount('<phong-viewer></phong-viewer>', size);
  // Each address is named in the message.
  const name = /\([^()]*\)\.?$/;
  expect((await outcome(empty, site.file(damaged))).replace(name, '')).toBe(threaded.replace(name, ''));
});

test('a model is shown under a policy that allows no worker', async ({ mount, consoleGuard }) => {
  consoleGuard.allow(/worker-src/);
  const viewer = await mount(scene, { ...size, csp: `${strictPolicy}; worker-src 'none'` });
  expect(await loaded(viewer)).toBe(true);
});

test('twenty models at once use one worker', async ({ page }) => {
  const started = workersOf(page);
  // Different addresses, so that nothing is shared.
  const many = Array.from({ length: 20 }, (_, i) => `<phong-mesh src="${bunny}?${i}"></phong-mesh>`).join('');
  const viewer = await shown(page, `<phong-viewer>${many}</phong-viewer>`);
  await settled(viewer);
  expect(await loaded(viewer)).toBe(true);
  expect(started).toHaveLength(1);
  expect(page.workers()).toHaveLength(1);
});

test('the worker starts while the meshes are still being downloaded', async ({ page, mount }) => {
  const starting = page.waitForEvent('worker');
  await page.route('**/*.bin', async (route) => {
    await starting;
    await route.continue();
  });
  const viewer = await mount(`<phong-viewer src="${engine}"></phong-viewer>`, size);
  expect(await loaded(viewer)).toBe(true);
});

test('removing the viewer terminates a busy worker, and the next model gets a new one', async ({ page }) => {
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
