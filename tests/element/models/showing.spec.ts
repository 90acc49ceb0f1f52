// Does a picture stay until the next one can be shown? Failed allocations, drawing that throws, downloads of removed
// viewers, silent servers. Also: when does `loaded` become true?
import type { Locator, Page } from '@playwright/test';
import { compare, expect, pixels, test, type Picture } from '../../support/test.js';
import { assign, nextFrame, type PhongMesh, type PhongViewer, record, settled } from '../support/viewer.js';

const SIZE = { width: 120, height: 90 };
const BUNNY = '/assets/models/bunny.glb';
const QUAD = '/fixtures/models/no-normals.glb';
const same = (a: Picture, b: Picture): void => expect(compare(a, b).max).toBe(0);

/** Makes allocations of typed arrays with at least this many elements fail. */
const limitMemory = (page: Page, type: 'Float32Array' | 'Uint8Array', most: number) =>
  page.evaluate(
    ([name, limit]) => {
      const original = window[name];
      const limited = new Proxy(original, {
        construct(target, [first, ...more]: unknown[], newTarget) {
          const count = Array.isArray(first) ? first.length : Number(typeof first === 'number' && first);
          if (count >= limit) throw new RangeError('Array buffer allocation failed');
          return Reflect.construct(target, [first, ...more], newTarget) as object;
        },
      });
      Object.assign(window, {
        [name]: limited,
        giveMemoryBack: () => Object.assign(window, { [name]: original }),
      });
    },
    [type, most] as const,
  );

const giveMemoryBack = (page: Page): Promise<void> =>
  page.evaluate(() => (window as unknown as { giveMemoryBack: () => void }).giveMemoryBack());

const shows = (viewer: Locator): Promise<boolean> =>
  viewer.evaluate((element: PhongViewer) => element.loaded);

/**
 * Makes the typed array with this number fail, counted from now on over all types. `countArrays` tells how many there
 * were.
 */
const failArray = (page: Page, failing: number): Promise<void> =>
  page.evaluate((nth) => {
    const scope = window as unknown as Record<string, unknown> & { countArrays?: () => number };
    const types = ['Int8Array', 'Uint8Array', 'Int16Array', 'Uint16Array', 'Int32Array', 'Uint32Array'];
    const names = [...types, 'Float32Array', 'Float64Array', 'ArrayBuffer'];
    const originals = new Map(names.map((name) => [name, scope[name]]));
    let count = 0;
    /** Arrays find their type in their prototype too, to copy themselves. */
    const replace = (name: string, type: unknown): void => {
      scope[name] = type;
      Object.assign((originals.get(name) as typeof Float32Array).prototype, { constructor: type });
    };
    for (const [name, original] of originals) {
      const counted = new Proxy(original as typeof Float32Array, {
        construct(target, args: [unknown], newTarget) {
          // A view of a buffer takes no memory.
          const allocates = !(args[0] instanceof (originals.get('ArrayBuffer') as typeof ArrayBuffer));
          if (allocates) count += 1;
          if (allocates && count === nth) throw new RangeError('Array buffer allocation failed');
          return Reflect.construct(target, args, newTarget) as object;
        },
      });
      replace(name, counted);
    }
    scope.countArrays = () => {
      for (const [name, original] of originals) replace(name, original);
      return count;
    };
  }, failing);

for (const [what, address, attributes] of [
  ['a model', QUAD, ''],
  ['a model with flat shading', QUAD, 'shading="flat"'],
] as const) {
  test(`${what} is shown or ends in too-large, whichever of its typed arrays fails`, async ({
    page,
    mount,
  }) => {
    test.slow();
    const viewer = await mount(`<phong-viewer geometry="box" ${attributes}></phong-viewer>`, SIZE);
    await assign(viewer, { src: address });
    await settled(viewer);
    const loaded = await pixels(viewer);
    const events = await record(viewer, 'error', 'load');
    let failures = 0;
    for (let failing = 1; ; failing += 1) {
      await assign(viewer, { src: '' });
      await settled(viewer);
      const before = await pixels(viewer);
      await events.take();
      await failArray(page, failing);
      // A colour of its own: the material of the load before is not there to be shared.
      await assign(viewer, { src: `${address}?${String(failing)}`, ka: [failing, 0, 0] });
      await settled(viewer);
      const count = await page.evaluate(() =>
        (window as unknown as { countArrays: () => number }).countArrays(),
      );
      const ends = await events.take();
      if (count < failing) {
        expect(ends).toMatchObject([{ type: 'load' }]);
        break;
      }
      if (ends.length === 1 && ends[0]!.type === 'load') continue; // what failed was not needed
      expect(ends, `array ${String(failing)}`).toMatchObject([
        { type: 'error', detail: { code: 'too-large' } },
      ]);
      same(await pixels(viewer), before);
      failures += 1;
    }
    expect(failures).toBeGreaterThan(5);
    await assign(viewer, { src: address, ka: [200, 200, 200] });
    await settled(viewer);
    same(await pixels(viewer), loaded);
  });
}

for (const [what, type, shading] of [
  ['reading it', 'Uint8Array', 'phong'],
  ['its flat normals', 'Float32Array', 'flat'],
] as const) {
  test(`a model without memory for ${what} is too-large, and the previous picture stays`, async ({
    page,
    mount,
  }) => {
    const viewer = await mount(`<phong-viewer src="${QUAD}" shading="${shading}"></phong-viewer>`, SIZE);
    const before = await pixels(viewer);
    const events = await record(viewer, 'error', 'load');
    await limitMemory(page, type, 1_000);
    await assign(viewer, { src: BUNNY });
    await settled(viewer);
    expect(await events.take()).toMatchObject([{ type: 'error', detail: { code: 'too-large' } }]);
    expect(await shows(viewer)).toBe(false);
    same(await pixels(viewer), before);
    await giveMemoryBack(page);
    await assign(viewer, { src: BUNNY });
    await settled(viewer);
    expect(await events.take()).toMatchObject([{ type: 'load' }]);
    expect(await shows(viewer)).toBe(true);
    await expect(viewer.locator('[part=notice]')).toHaveCount(0);
  });
}

test('a shape without memory is too-large, and the previous picture stays', async ({ page, mount }) => {
  const viewer = await mount('<phong-viewer geometry="box"></phong-viewer>', SIZE);
  const before = await pixels(viewer);
  const events = await record(viewer, 'error');
  await limitMemory(page, 'Float32Array', 10_000);
  await assign(viewer, { geometry: 'torus', segments: 512 });
  await settled(viewer);
  expect(await events.take()).toMatchObject([{ detail: { code: 'too-large' } }]);
  await assign(viewer, { geometry: 'sphere' });
  await settled(viewer);
  expect(await events.take()).toMatchObject([{ detail: { code: 'too-large' } }]);
  same(await pixels(viewer), before);
  await assign(viewer, { segments: 1, geometry: 'box' });
  await settled(viewer);
  same(await pixels(viewer), before);
  await expect(viewer.locator('[part=notice]')).toHaveCount(0);
});

for (const earlier of ['phong', 'gouraud'] as const) {
  test(`a model that cannot be flattened keeps its ${earlier} shading, with one error`, async ({
    page,
    mount,
  }) => {
    const viewer = await mount(
      `<phong-viewer shading="${earlier}"><phong-mesh src="${BUNNY}"></phong-mesh></phong-viewer>`,
      SIZE,
    );
    const before = await pixels(viewer);
    const events = await record(viewer, 'error');
    const ofMesh = await record(page.locator('phong-mesh'), 'error');
    await limitMemory(page, 'Float32Array', 10_000);
    await assign(viewer, { shading: 'flat' });
    await settled(viewer);
    await page.locator('phong-mesh').evaluate((mesh: PhongMesh) => (mesh.name = 'still the bunny'));
    await settled(viewer);
    expect(await events.take()).toMatchObject([{ detail: { code: 'too-large' } }]);
    expect(await ofMesh.take()).toHaveLength(1);
    same(await pixels(viewer), before);
    await giveMemoryBack(page);
    await assign(viewer, { shading: earlier });
    await settled(viewer);
    await expect(viewer.locator('[part=notice]')).toHaveCount(0);
    same(await pixels(viewer), before);
    await assign(viewer, { shading: 'flat' });
    await settled(viewer);
    expect(await events.take()).toEqual([]);
    expect(compare(await pixels(viewer), before).max).toBeGreaterThan(0);
  });
}

for (const [what, message, code] of [
  ['for want of memory', 'Array buffer allocation failed', 'too-large'],
  ['for another reason', 'Invalid offset', 'bad-model'],
] as const) {
  test(`a model that cannot be drawn ${what} leaves the previous picture, without a gap`, async ({
    page,
    mount,
  }) => {
    const viewer = await mount(`<phong-viewer src="${QUAD}"></phong-viewer>`, SIZE);
    const before = await pixels(viewer);
    const events = await record(viewer, 'error');
    await page.evaluate((text) => {
      const { prototype } = WebGL2RenderingContext;
      const { bufferData } = prototype;
      prototype.bufferData = function (this: WebGL2RenderingContext, ...args: unknown[]) {
        const [, data] = args;
        if (ArrayBuffer.isView(data) && data.byteLength > 10_000) throw new RangeError(text);
        Reflect.apply(bufferData, this, args);
      };
    }, message);
    await assign(viewer, { src: BUNNY });
    await settled(viewer);
    await nextFrame(page);
    expect(await events.take()).toMatchObject([{ detail: { code } }]);
    same(await pixels(viewer), before);
    expect(await shows(viewer)).toBe(false);
    await assign(viewer, { src: QUAD });
    await settled(viewer);
    expect(await events.take()).toEqual([]);
    expect(await shows(viewer)).toBe(true);
    same(await pixels(viewer), before);
  });
}

test('a broken own object of the page is not blamed on a mesh added with it', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/uncaught: .*broken/);
  const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
  const events = await record(viewer, 'error');
  await viewer.evaluate((element: PhongViewer) => {
    element.geometry = 'box';
    element.scene.onBeforeRender = () => {
      throw new Error('broken');
    };
    return element.ready;
  });
  await nextFrame(page);
  expect(await events.take()).toEqual([]);
  await viewer.evaluate((element: PhongViewer) => {
    element.scene.onBeforeRender = () => undefined;
    element.requestRender();
    return element.ready;
  });
  expect(await shows(viewer)).toBe(true);
});

test('a viewer that was removed aborts its downloads and requests them again when it is back', async ({
  page,
  mount,
}) => {
  let answered = false;
  await page.route(/bunny|quad\.bin/, (route) => (answered ? route.continue() : undefined));
  const aborted: string[] = [];
  page.on('requestfailed', (request) => aborted.push(new URL(request.url()).pathname));
  const asked = page.waitForRequest(/quad\.bin/);
  const viewer = await mount(
    `<phong-viewer src="${BUNNY}"><phong-mesh src="/fixtures/models/beside/quad.gltf"></phong-mesh></phong-viewer>`,
    { ...SIZE, waitForReady: false },
  );
  await asked;
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
  await viewer.evaluate(async (element: PhongViewer) => {
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

test('a removed viewer fetches a newly set src only when it is back', async ({ page, mount }) => {
  const viewer = await mount(`<phong-viewer src="${QUAD}"></phong-viewer>`, SIZE);
  const asked: string[] = [];
  page.on('request', (request) => asked.push(new URL(request.url()).pathname));
  const removed = await viewer.evaluateHandle((element: PhongViewer) => {
    element.remove();
    return element;
  });
  await nextFrame(page);
  await removed.evaluate(async (element, src) => {
    element.src = src;
    await element.ready;
  }, BUNNY);
  await nextFrame(page);
  expect(asked).toEqual([]);
  await removed.evaluate(async (element) => {
    document.body.append(element);
    await element.ready;
  });
  expect(asked.filter((path) => path === BUNNY)).toHaveLength(1);
});

test('a load fails after a minute without data', async ({ page, mount }) => {
  const viewer = await mount(`<phong-viewer src="${QUAD}"></phong-viewer>`, SIZE);
  await page.clock.install();
  await page.route(/bunny/, () => undefined);
  const events = await record(viewer, 'error', 'load');
  const asked = page.waitForRequest(/bunny/);
  await assign(viewer, { src: BUNNY });
  await asked;
  await page.clock.runFor(59_000);
  expect(await events.take()).toEqual([]);
  await page.clock.runFor(2_000);
  await expect
    .poll(async () => (await events.take()).map(({ detail }) => detail))
    .toMatchObject([{ code: 'load-failed' }]);
  await expect(viewer.locator('[part=notice]')).toContainText('No data came for 60 seconds');
});

test('a failed mesh that keeps moving is not requested again; naming the same file again does', async ({
  page,
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/404/);
  const viewer = await mount(
    '<phong-viewer><phong-mesh src="/nowhere.glb"></phong-mesh></phong-viewer>',
    SIZE,
  );
  const asked: string[] = [];
  page.on('request', (request) => asked.push(request.url()));
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
  const steps = await viewer.evaluate(async (element: PhongViewer) => {
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

test('loaded is false while one of several meshes has failed', async ({ mount, consoleGuard }) => {
  consoleGuard.allow(/404/);
  const viewer = await mount(
    '<phong-viewer geometry="box"><phong-mesh src="/nowhere.glb"></phong-mesh></phong-viewer>',
    SIZE,
  );
  expect(await shows(viewer)).toBe(false);
});
