// Does a picture stay until the next one can be shown? Failed allocations, drawing that throws,
// downloads of removed viewers. Also: when does `loaded` become true?

import type { Page } from '@playwright/test';
import { type ViewerLocator, compare, expect, pixels, same, test } from '../../support/test.js';
import {
  assign,
  nextFrame,
  type PhongMesh,
  type PhongViewer,
  record,
  set,
  settled,
} from '../../element/support/viewer.js';
import { requestsOf } from '../../support/requests.js';

const SIZE = { width: 120, height: 90 };
const BUNNY = '/assets/models/bunny.glb';
const QUAD = '/fixtures/models/no-normals.glb';

declare global {
  interface Window {
    /** Ends the failures, and returns how many arrays there were. */
    giveMemoryBack: () => number;
  }
}

const giveMemoryBack = (page: Page) => page.evaluate(() => window.giveMemoryBack());

const shows = (viewer: ViewerLocator) => viewer.evaluate((element) => element.loaded);

/**
 * Makes the typed array with this number fail, counted from now on over all types, or those of
 * 10,000 floats or more.
 */
const failArrays = (page: Page, failing: number | 'large') =>
  page.evaluate((which) => {
    const scope = window as unknown as Record<string, unknown>;
    const types = [
      'Int8Array',
      'Uint8Array',
      'Int16Array',
      'Uint16Array',
      'Int32Array',
      'Uint32Array',
    ];
    const names = [...types, 'Float32Array', 'Float64Array', 'ArrayBuffer'];
    const originals = new Map(names.map((name) => [name, scope[name]]));
    let count = 0;
    /** Arrays find their type in their prototype too, to copy themselves. */
    const replace = (name: string, type: unknown) => {
      scope[name] = type;
      Object.assign((originals.get(name) as typeof Float32Array).prototype, { constructor: type });
    };
    for (const [name, original] of originals) {
      const counted = new Proxy(original as typeof Float32Array, {
        construct(target, args: [unknown], newTarget) {
          const [first] = args;
          // A view of a buffer takes no memory.
          const allocates = !(
            first instanceof (originals.get('ArrayBuffer') as typeof ArrayBuffer)
          );
          if (allocates) {
            count += 1;
          }
          const size = Array.isArray(first)
            ? first.length
            : Number(typeof first === 'number' && first);
          const isLarge = name === 'Float32Array' && size >= 10_000;
          if (which === 'large' ? isLarge : allocates && count === which) {
            throw new RangeError('Array buffer allocation failed');
          }
          return Reflect.construct(target, args, newTarget) as object;
        },
      });
      replace(name, counted);
    }
    window.giveMemoryBack = () => {
      for (const [name, original] of originals) {
        replace(name, original);
      }
      return count;
    };
  }, failing);

test('a model is shown flat or ends in too-large, whichever of its typed arrays fails', async ({
  page,
  mount,
}) => {
  test.slow();
  const viewer = await mount('<phong-viewer geometry="box" shading="flat"></phong-viewer>', SIZE);
  await set(viewer, { src: QUAD });
  const loaded = await pixels(viewer);
  const events = await record(viewer, 'error', 'load');
  let failures = 0;
  for (let failing = 1; ; failing += 1) {
    await set(viewer, { src: '' });
    const before = await pixels(viewer);
    await events.take();
    await failArrays(page, failing);
    // A colour of its own: the material of the load before is not there to be shared.
    await set(viewer, { src: `${QUAD}?${failing}`, ka: [failing, 0, 0] });
    const count = await giveMemoryBack(page);
    const ends = await events.take();
    if (count < failing) {
      expect(ends).toMatchObject([{ type: 'load' }]);
      break;
    }
    if (ends.length === 1 && ends[0]!.type === 'load') continue; // what failed was not needed
    expect(ends, `array ${failing}`).toMatchObject([
      { type: 'error', detail: { code: 'too-large' } },
    ]);
    same(await pixels(viewer), before);
    failures += 1;
  }
  expect(failures).toBeGreaterThan(5);
  await set(viewer, { src: QUAD, ka: [200, 200, 200] });
  same(await pixels(viewer), loaded);
});
/** Makes buffers of more than 10,000 bytes fail when they are sent to WebGL. */
const limitBuffers = (page: Page, message: string) =>
  page.evaluate((text) => {
    const { prototype } = WebGL2RenderingContext;
    const { bufferData } = prototype;
    prototype.bufferData = function (this: WebGL2RenderingContext, ...args: unknown[]) {
      const [, data] = args;
      if (ArrayBuffer.isView(data) && data.byteLength > 10_000) throw new RangeError(text);
      Reflect.apply(bufferData, this, args);
    };
    Object.assign(window, { giveMemoryBack: () => (prototype.bufferData = bufferData) });
  }, message);

test('a model that cannot be drawn is an error, and the previous picture stays', async ({
  page,
  mount,
}) => {
  for (const [message, code] of [
    ['Array buffer allocation failed', 'too-large'],
    ['Invalid offset', 'bad-model'],
  ] as const) {
    const viewer = await mount(`<phong-viewer src="${QUAD}"></phong-viewer>`, SIZE);
    const before = await pixels(viewer);
    const events = await record(viewer, 'error', 'load');
    await limitBuffers(page, message);
    await set(viewer, { src: BUNNY });
    await nextFrame(page);
    const heard = (await events.take()) as { type: string; detail: { code?: string } }[];
    expect(heard.map(({ type, detail }) => detail.code ?? type)).toEqual(['load', code]);
    expect(await shows(viewer)).toBe(false);
    same(await pixels(viewer), before);
    await set(viewer, { src: QUAD });
    expect(await shows(viewer)).toBe(true);
    same(await pixels(viewer), before);
    await giveMemoryBack(page);
    await events.take();
    await set(viewer, { src: BUNNY });
    expect(await events.take()).toMatchObject([{ type: 'load' }]);
    expect(await shows(viewer)).toBe(true);
    await expect(viewer.locator('[part=notice]')).toHaveCount(0);
  }
});
test('a shape without memory is too-large, and the previous picture stays', async ({
  page,
  mount,
}) => {
  const viewer = await mount('<phong-viewer geometry="box"></phong-viewer>', SIZE);
  const before = await pixels(viewer);
  const events = await record(viewer, 'error');
  await failArrays(page, 'large');
  for (const shape of [{ geometry: 'torus', segments: 512 }, { geometry: 'sphere' }]) {
    await set(viewer, shape);
    expect(await events.take()).toMatchObject([{ detail: { code: 'too-large' } }]);
  }
  same(await pixels(viewer), before);
  await set(viewer, { segments: 1, geometry: 'box' });
  same(await pixels(viewer), before);
  await expect(viewer.locator('[part=notice]')).toHaveCount(0);
});

test('a model that cannot be flattened keeps its shading, with one error', async ({
  page,
  mount,
}) => {
  const viewer = await mount(
    `<phong-viewer shading="gouraud"><phong-mesh src="${BUNNY}"></phong-mesh></phong-viewer>`,
    SIZE,
  );
  const before = await pixels(viewer);
  const events = await record(viewer, 'error');
  const ofMesh = await record(page.locator('phong-mesh'), 'error');
  await failArrays(page, 'large');
  await set(viewer, { shading: 'flat' });
  await page.locator('phong-mesh').evaluate((mesh: PhongMesh) => (mesh.name = 'still the bunny'));
  await settled(viewer);
  expect(await events.take()).toMatchObject([{ detail: { code: 'too-large' } }]);
  expect(await ofMesh.take()).toHaveLength(1);
  same(await pixels(viewer), before);
  await giveMemoryBack(page);
  await set(viewer, { shading: 'gouraud' });
  await expect(viewer.locator('[part=notice]')).toHaveCount(0);
  same(await pixels(viewer), before);
  await set(viewer, { shading: 'flat' });
  expect(await events.take()).toEqual([]);
  expect(compare(await pixels(viewer), before).max).toBeGreaterThan(0);
});
test('a broken own object of the page is not blamed on a mesh added with it', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/uncaught: .*broken/);
  const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
  const events = await record(viewer, 'error');
  await viewer.evaluate((element) => {
    element.geometry = 'box';
    element.scene.onBeforeRender = () => {
      throw new Error('broken');
    };
    return element.ready;
  });
  await nextFrame(page);
  expect(await events.take()).toEqual([]);
  await viewer.evaluate((element) => {
    element.scene.onBeforeRender = () => undefined;
    element.requestRender();
    return element.ready;
  });
  expect(await shows(viewer)).toBe(true);
});

test('a removed viewer aborts its downloads, and requests them or a new src once back', async ({
  page,
  mount,
}) => {
  let answered = false;
  await page.route(/bunny|quad\.bin/, (route) => (answered ? route.continue() : undefined));
  const aborted: string[] = [];
  page.on('requestfailed', (request) => aborted.push(new URL(request.url()).pathname));
  const requested = page.waitForRequest(/quad\.bin/);
  const viewer = await mount(
    `<phong-viewer src="${BUNNY}"><phong-mesh src="/fixtures/models/beside/quad.gltf"></phong-mesh></phong-viewer>`,
    { ...SIZE, waitForReady: false },
  );
  await requested;
  const events = await record(viewer, 'error', 'load');
  const removed = await viewer.evaluateHandle((element: PhongViewer) => {
    element.remove();
    return element;
  });
  await expect.poll(() => aborted).toContain(BUNNY);
  await expect.poll(() => aborted).toContain('/fixtures/models/beside/quad.bin');
  await removed.evaluate((element) => element.ready);
  answered = true;
  await removed.evaluate(async (element) => {
    document.body.append(element);
    await element.ready;
  });
  const heard = await events.take();
  expect(heard.map(({ type }) => type)).toEqual(['load', 'load']);
  expect(await shows(viewer)).toBe(true);

  const asked = requestsOf(page);
  await removed.evaluate((element) => element.remove());
  await nextFrame(page);
  await removed.evaluate(async (element, src) => {
    element.src = src;
    await element.ready;
  }, QUAD);
  await nextFrame(page);
  expect(asked).toEqual([]);
  await removed.evaluate(async (element) => {
    document.body.append(element);
    await element.ready;
  });
  expect(asked.filter((url) => url.endsWith(QUAD))).toHaveLength(1);
});

test('a viewer that moves within a task goes on with its download', async ({ page, mount }) => {
  let answer = (): void => undefined;
  const free = new Promise<void>((resolve) => (answer = resolve));
  const asked: string[] = [];
  await page.route(/bunny/, async (route) => {
    asked.push(route.request().url());
    await free;
    await route.continue();
  });
  const viewer = await mount(`<phong-viewer src="${BUNNY}"></phong-viewer><aside></aside>`, {
    ...SIZE,
    waitForReady: false,
  });
  await expect.poll(() => asked.length).toBe(1);
  await viewer.evaluate(async (element) => {
    element.remove();
    await Promise.resolve();
    document.querySelector('aside')?.append(element);
  });
  await nextFrame(page);
  answer();
  await settled(viewer);
  expect(await shows(viewer)).toBe(true);
  expect(asked).toHaveLength(1);
});

test('a failed mesh is not requested again by moves, but by naming its file', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/404/);
  const viewer = await mount(
    '<phong-viewer geometry="box"><phong-mesh src="/nowhere.glb"></phong-mesh></phong-viewer>',
    SIZE,
  );
  expect(await shows(viewer), 'a mesh is missing').toBe(false);
  const asked = requestsOf(page);
  const mesh = page.locator('phong-mesh');
  for (let turn = 1; turn <= 3; turn++) {
    await assign(mesh, { rotation: [0, turn, 0] });
    await settled(viewer);
  }
  expect(asked).toEqual([]);
  await assign(mesh, { src: '/nowhere.glb' });
  await expect.poll(() => asked.length).toBe(1);
});

test('loaded becomes true once shapes are drawn, without a load event', async ({ page, mount }) => {
  const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
  const events = await record(viewer, 'load');
  expect(await shows(viewer)).toBe(false);
  const steps = await viewer.evaluate(async (element) => {
    element.geometry = 'box';
    const atOnce = element.loaded;
    await element.ready;
    const drawn = element.loaded;
    element.theta = 50;
    const moved = element.loaded;
    const mesh = document.createElement('phong-mesh');
    mesh.geometry = 'torus';
    element.append(mesh);
    const another = element.loaded;
    await element.ready;
    return { atOnce, drawn, moved, another, both: element.loaded };
  });
  expect(steps).toEqual({ atOnce: false, drawn: true, moved: true, another: false, both: true });
  await nextFrame(page);
  expect(await events.take()).toEqual([]);
});
