// Do toBlob and toHTML give the picture and the scene as they are now? Sizes in pixels; pictures are decoded PNGs or,
// for JPEG, what the browser reads back.

import type { Locator } from '@playwright/test';
import { compare, expect, pixels, test, type Picture } from '../../support/test.js';
import { assign, cameraOf, drag, nextFrame, type PhongViewer, record, settled } from '../support/viewer.js';

const size = { width: 120, height: 80 };
const light = '<phong-light position="1 2 3 0" ambient="60"></phong-light>';
const box = `<phong-viewer geometry="box" kd="200 40 40">${light}</phong-viewer>`;

interface Facts {
  readonly type: string;
  readonly width: number;
  readonly height: number;
}

/** Type and decoded size of what toBlob gives for these options. */
const blobFacts = (viewer: Locator, options: object): Promise<Facts> =>
  viewer.evaluate(async (element: PhongViewer, given) => {
    const blob = await element.toBlob(given);
    const { width, height } = await createImageBitmap(blob);
    return { type: blob.type, width, height };
  }, options);

const rejection = (viewer: Locator, options: object): Promise<string> =>
  viewer.evaluate(
    (element: PhongViewer, given) =>
      element.toBlob(given).then(
        () => 'no error',
        (error: unknown) => (error as Error).name,
      ),
    options,
  );

test.describe('toBlob', () => {
  test('gives exactly the requested pixels on any screen; by default those of the canvas', async ({
    mount,
  }) => {
    const viewer = await mount(box, { ...size, deviceScaleFactor: 2 });
    expect(await blobFacts(viewer, {})).toEqual({ type: 'image/png', width: 240, height: 160 });
    expect(await blobFacts(viewer, { width: 37, height: 91 })).toMatchObject({ width: 37, height: 91 });
    expect(await blobFacts(viewer, { width: 50 })).toMatchObject({ width: 50, height: 160 });
    expect(await blobFacts(viewer, { width: 1, height: 1 })).toMatchObject({ width: 1, height: 1 });
    expect(await blobFacts(viewer, { width: 8, height: 8, type: 'image/webp' })).toMatchObject({
      type: 'image/webp',
    });
  });

  test('keeps field of view, radius and angles, and has the aspect of its own size', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(box, size);
    await drag(page, [60, 40], [20, 9]);
    const [square, wide] = [
      await pixels(viewer, { width: 100, height: 100 }),
      await pixels(viewer, { width: 200, height: 100 }),
    ];
    // The vertical field is the same: the middle of the wide picture is the square one.
    const middle = crop(wide, 50, 0, 100, 100);
    expect(compare(middle, square, 2).share).toBeLessThan(0.002);
  });

  test('has straight alpha: an edge half covered keeps the colour of the inside', async ({ mount }) => {
    const flat = `<phong-viewer geometry="plane" ka="255" theta="20" phi="50" terms="ambient"><phong-light ambient="200 100 50"></phong-light></phong-viewer>`;
    const viewer = await mount(flat, size);
    const picture = await pixels(viewer);
    let edges = 0;
    const wrong: number[][] = [];
    for (let i = 0; i < picture.data.length; i += 4) {
      const [r, g, b, alpha] = picture.data.subarray(i, i + 4) as unknown as [number, number, number, number];
      if (alpha > 60 && alpha < 255) edges += 1;
      // Eight bits that were multiplied by alpha and divided again leave this much.
      const slack = Math.ceil(255 / alpha) + 1;
      const off = Math.max(Math.abs(r - 200), Math.abs(g - 100), Math.abs(b - 50));
      if (alpha === 0 ? r + g + b > 0 : off > slack) wrong.push([r, g, b, alpha]);
    }
    expect(wrong).toEqual([]);
    expect(edges).toBeGreaterThan(20);
  });

  test('lays JPEG over white', async ({ mount }) => {
    const viewer = await mount(box, size);
    const corner = await viewer.evaluate(async (element: PhongViewer) => {
      const blob = await element.toBlob({ type: 'image/jpeg', quality: 1 });
      const canvas = new OffscreenCanvas(1, 1);
      const context = canvas.getContext('2d')!;
      context.drawImage(await createImageBitmap(blob), 0, 0);
      return [blob.type, ...context.getImageData(0, 0, 1, 1).data];
    });
    expect(corner).toEqual(['image/jpeg', 255, 255, 255, 255]);
  });

  test('draws pictures beyond the GPU’s limit in tiles without seams', async ({ mount }) => {
    test.slow();
    const viewer = await mount(box.replace('geometry', 'radius="2" geometry'), size);
    const wide = await pixels(viewer, { width: 9000, height: 500 });
    expect([wide.width, wide.height]).toEqual([9000, 500]);
    // 4,500 is in the first tile's neighbour: the same field in one piece lies around the middle.
    const one = await pixels(viewer, { width: 2000, height: 500 });
    expect(compare(crop(wide, 3500, 0, 2000, 500), one, 2).share).toBeLessThan(0.002);
  });

  test('rejects bad sizes with RangeError and leaves the viewer as it was', async ({ mount }) => {
    const viewer = await mount(box, size);
    const before = await pixels(viewer);
    for (const bad of [0, -1, 1.5, NaN, Infinity, 1e9])
      expect(await rejection(viewer, { width: bad, height: 10 }), `width ${bad}`).toBe('RangeError');
    expect(await rejection(viewer, { width: 100_000, height: 100_000 })).toBe('RangeError');
    expect(await rejection(viewer, { width: 10, height: '10' })).toMatch(/^(Range|Type)Error$/);
    expect(await rejection(viewer, { quality: 7 })).toBe('RangeError');
    expect(compare(await pixels(viewer), before).max).toBe(0);
  });

  test('shows changes of the same task, and works off screen, hidden and outside the document', async ({
    page,
    mount,
  }) => {
    const viewer = await mount(box, size);
    const red = await pixels(viewer, size);
    const outside = [
      ['off screen', (element: HTMLElement) => (element.style.cssText = 'position: absolute; top: 9000px')],
      ['not displayed', (element: HTMLElement) => (element.style.cssText = 'display: none')],
      ['out of the document', (element: HTMLElement) => (element.remove(), '')],
    ] as const;
    const handle = await viewer.evaluateHandle((element: PhongViewer) => element);
    const onScreen = await viewer.screenshot();
    for (const [what, hide] of outside) {
      await handle.evaluate(hide);
      await nextFrame(page);
      const equal = await handle.evaluate(async (element: PhongViewer, { width, height }) => {
        const bytes = async (): Promise<string> => {
          const blob = await element.toBlob({ width, height });
          return String(new Uint8Array(await blob.arrayBuffer()));
        };
        const hidden = await bytes();
        element.kd = [1, 2, 3];
        const other = await bytes();
        element.kd = [200, 40, 40];
        element.style.cssText = '';
        document.body.prepend(element);
        await element.ready;
        return [hidden === (await bytes()), hidden === other];
      }, size);
      expect(equal, what).toEqual([true, false]);
      expect(compare(await pixels(viewer, size), red).max, what).toBe(0);
      await nextFrame(page);
      expect(Buffer.compare(await viewer.screenshot(), onScreen), what).toBe(0);
    }
  });
});

test('requestRender shows changes of an own object in scene', async ({ mount }) => {
  const viewer = await mount(box, size);
  const before = await pixels(viewer);
  const renders = await record(viewer, 'render');
  await viewer.evaluate((element: PhongViewer) => {
    const own = element.scene.getObjectByProperty('isMesh', true)!.clone();
    own.matrixAutoUpdate = true;
    own.position.set(0, 1, 0);
    element.scene.add(own);
    element.requestRender();
  });
  await settled(viewer);
  expect((await renders.take()).length).toBe(1);
  expect(compare(await pixels(viewer), before).max).toBeGreaterThan(20);
});

test('requestRender keeps target and radius, and refit fits them to the changed scene', async ({ mount }) => {
  const viewer = await mount(box, size);
  const before = await cameraOf(viewer);
  const changes = await record(viewer, 'camera-change', 'render');
  await viewer.evaluate((element: PhongViewer) => {
    const own = element.scene.getObjectByProperty('isMesh', true)!.clone();
    own.matrixAutoUpdate = true;
    own.position.set(4, 0, 0);
    element.scene.add(own);
    element.requestRender();
  });
  await settled(viewer);
  expect(await cameraOf(viewer)).toEqual(before);
  expect(await changes.take()).toEqual([{ type: 'render', detail: null }]);
  await viewer.evaluate((element: PhongViewer) => element.refit());
  await settled(viewer);
  const { target, radius } = await cameraOf(viewer);
  expect(target).toEqual([2, 0, 0]);
  expect(radius / before.radius).toBeCloseTo(Math.hypot(2.5, 0.5, 0.5) / Math.hypot(0.5, 0.5, 0.5), 5);
  expect(await changes.take()).toContainEqual({ type: 'camera-change', detail: { source: 'auto' } });
});

test('stats is a plain snapshot of what a scene costs', async ({ mount }) => {
  const off = '<phong-light active="false"></phong-light>';
  const viewer = await mount(box.replace('</phong-viewer>', `${light}${off}</phong-viewer>`), size);
  const read = (): Promise<PhongViewer['stats']> => viewer.evaluate((element: PhongViewer) => element.stats);
  const first = await read();
  expect(first).toMatchObject({ frames: 1, lightsDeclared: 3, lightsActive: 2, lightsSent: 2, drawCalls: 1 });
  expect(first.programs).toBeGreaterThan(0);
  await assign(viewer, { theta: 99 });
  await settled(viewer);
  expect(await read()).toMatchObject({ frames: 2, programs: first.programs });
});

/** A rectangle out of a picture. */
function crop(picture: Picture, x: number, y: number, width: number, height: number): Picture {
  const data = new Uint8Array(4 * width * height);
  for (let row = 0; row < height; row++) {
    const from = 4 * ((y + row) * picture.width + x);
    data.set(picture.data.subarray(from, from + 4 * width), 4 * row * width);
  }
  return { width, height, data };
}
