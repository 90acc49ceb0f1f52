// Where are compressed models unpacked? In one worker for any number of models, by WebAssembly or without, or on the
// main thread if none can start, with the same bits. The worker ends after an abort or an idle time. The tests' server
// allows its files no WebAssembly.

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
const wasmWorkerFile = /\/draco-wasm-worker[^/]*\.js$/;
const anyWorkerFile = /\/draco(-wasm)?-worker[^/]*\.js$/;

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

test('a model is the same from WebAssembly and without it, from the worker and from the main thread', async ({
  page,
  mount,
}) => {
  const started = workersOf(page);
  const allowing = await startSite(testMounts, wasmPolicy);
  const head = '<script type="module" src="/dist/phong-viewer.standalone.js"></script>';
  const meshes = `<phong-viewer src="${bunny}"><phong-mesh src="${engine}"></phong-mesh></phong-viewer>`;
  await page.goto(allowing.page(meshes, { csp: wasmPolicy, head }));
  const first = page.locator('phong-viewer');
  await page.evaluate(() => customElements.whenDefined('phong-viewer').then(() => undefined));
  await settled(first);
  const compiled = await fingerprint(first);
  expect(compiled.length).toBeGreaterThan(34);
  expect(started).toEqual([expect.stringMatching(wasmWorkerFile)]);
  await allowing.close();

  const requested = requestsOf(page);
  const threaded = await fingerprint(await mount(meshes, size));
  expect(threaded).toEqual(compiled);
  expect(started.slice(1)).toEqual([
    expect.stringMatching(wasmWorkerFile),
    expect.stringMatching(workerFile),
  ]);
  // Refused before the file is fetched.
  expect(Object.keys(requested).filter((name) => name.includes('decoder'))).toEqual([]);

  await page.route(anyWorkerFile, (route) => route.abort());
  expect(await fingerprint(await mount(meshes, size))).toEqual(compiled);
  expect(started).toHaveLength(3);
});

test('the worker without WebAssembly stands in where the file of the other is missing', async ({ page }) => {
  const started = workersOf(page);
  await page.route(/draco_decoder\.wasm$/, (route) => route.fulfill({ status: 404 }));
  const allowing = await startSite(testMounts, wasmPolicy);
  const head = '<script type="module" src="/dist/phong-viewer.standalone.js"></script>';
  await page.goto(allowing.page(scene, { csp: wasmPolicy, head }));
  const viewer = page.locator('phong-viewer');
  await page.evaluate(() => customElements.whenDefined('phong-viewer').then(() => undefined));
  await settled(viewer);
  expect(await loaded(viewer)).toBe(true);
  expect(started).toEqual([expect.stringMatching(wasmWorkerFile), expect.stringMatching(workerFile)]);
  await allowing.close();
});

test('damaged data give the same error from both', async ({ page, site, mount }) => {
  const outcome = async (): Promise<string> => {
    const viewer = await mount('<phong-viewer></phong-viewer>', size);
    return viewer.evaluate(
      (element: PhongViewer, src) =>
        new Promise<string>((resolve) => {
          element.addEventListener('error', ({ detail }) => resolve(`${detail.code}: ${detail.message}`));
          element.src = src;
        }),
      site.file(dracoGlb(1, 3, { faces: 1, points: 3 })),
    );
  };
  const threaded = await outcome();
  expect(threaded).toMatch(/^bad-model: .*Draco data/);
  await page.route(anyWorkerFile, (route) => route.abort());
  expect(await outcome()).toBe(threaded);
});

test('a model is shown under a policy that allows no worker', async ({ mount, consoleGuard }) => {
  consoleGuard.allow(/worker-src/);
  const viewer = await mount(scene, { ...size, csp: `${strictPolicy}; worker-src 'none'` });
  expect(await loaded(viewer)).toBe(true);
});

test('twenty models at once use one worker', async ({ page, mount }) => {
  const started = workersOf(page);
  // Different addresses, so that nothing is shared.
  const many = Array.from({ length: 20 }, (_, i) => `<phong-mesh src="${bunny}?${i}"></phong-mesh>`).join('');
  const viewer = await mount(`<phong-viewer>${many}</phong-viewer>`, size);
  expect(await loaded(viewer)).toBe(true);
  // One more was refused its WebAssembly.
  expect(started).toHaveLength(2);
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

test('removing the viewer terminates a busy worker, and the next model gets a new one', async ({
  page,
  mount,
}) => {
  const started = workersOf(page);
  const starting = page.waitForEvent('worker', (worker) => workerFile.test(worker.url()));
  await mount(scene, { ...size, waitForReady: false });
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

test('an idle worker ends', async ({ page, mount }) => {
  await page.clock.install();
  const starting = page.waitForEvent('worker', (worker) => workerFile.test(worker.url()));
  const mounting = mount(scene, size);
  const worker = await starting;
  const ended = worker.waitForEvent('close');
  await mounting;
  expect(page.workers()).toHaveLength(1);
  await page.clock.fastForward(6000);
  await ended;
});
