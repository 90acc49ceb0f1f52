// `antialias="full"`: when do samples come, what interrupts them, and what is shown meanwhile and
// afterwards?

import type { Page } from '@playwright/test';
import { type ViewerLocator, allReady, expect, pixels, same, test } from '../../support/test.js';
import { countEverything, expectIdle } from '../support/counting.js';
import {
  assign,
  nextFrame,
  type PhongViewer,
  samplesOf,
  set,
  settled,
  statsOf,
  trianglesOf,
} from '../support/viewer.js';

const size = { width: 60, height: 40 };
const light = '<phong-light position="1 2 3 0"></phong-light>';
const full = 'geometry="torus" antialias="full" samples="16"';
const viewerOf = (attributes: string) =>
  `<phong-viewer alt="" ${attributes}>${light}</phong-viewer>`;

interface Shown {
  readonly samples: number;
  readonly frames: number;
}

/** What `stats` says at each `render` from now on. */
const renders = (viewer: ViewerLocator) =>
  viewer.evaluateHandle((element: PhongViewer) => {
    const list: Shown[] = [];
    element.addEventListener('render', () => {
      const { samples, frames } = element.stats;
      list.push({ samples, frames });
    });
    return list;
  });

/** Waits until it has all samples. */
async function converged(viewer: ViewerLocator) {
  await settled(viewer);
  expect(await samplesOf(viewer)).toBe(16);
}

test('a still picture gets its samples, which are no frames; then nothing runs', async ({
  page,
  mount,
}) => {
  await countEverything(page);
  const viewer = await mount(viewerOf(full), size);
  await converged(viewer);
  await nextFrame(page);
  await expectIdle(page, 200);
  const seen = await renders(viewer);
  const { frames } = await statsOf(viewer);
  await assign(viewer, { theta: 40 });
  await converged(viewer);
  await nextFrame(page);
  expect(await seen.jsonValue()).toEqual([
    { samples: 0, frames: frames + 1 },
    { samples: 16, frames: frames + 1 },
  ]);
  await expectIdle(page, 200);
  await assign(viewer, { antialias: 'edges' });
  await allReady(page);
  expect(await samplesOf(viewer)).toBe(0);
});

test('samples begin three frames sooner after a lone change than after a drag', async ({
  mount,
}) => {
  const viewer = await mount(viewerOf('geometry="box" antialias="full" pixel-ratio="1"'), size);
  /**
   * Frames from the last of so many changes, two frames apart, to its first batch of samples, which
   * ends with a fence.
   */
  const waited = (changes: number) =>
    viewer.evaluate(async (element, count) => {
      await new Promise((resolve) => setTimeout(resolve, 300));
      const { prototype } = WebGL2RenderingContext;
      const { fenceSync } = prototype;
      let [batches, frames] = [0, 0];
      prototype.fenceSync = function (...args) {
        batches += 1;
        return fenceSync.apply(this, args);
      };
      for (let i = 0; i < count; i++) {
        for (let frame = 0; frame < 2; frame++) {
          await new Promise(requestAnimationFrame);
        }
        element.theta += 1;
        batches = 0;
      }
      for (; batches === 0; frames++) {
        await new Promise(requestAnimationFrame);
      }
      prototype.fenceSync = fenceSync;
      await element.ready;
      return frames;
    }, changes);
  expect((await waited(5)) - (await waited(1))).toBe(3);
});

test('several viewers converge in turn, and keep their pictures when others come or go', async ({
  page,
  mount,
}) => {
  const viewer = await mount(viewerOf(full), size);
  await converged(viewer);
  const before = await pixels(viewer);
  const seen = await renders(viewer);
  await page.evaluate(
    (markup) => {
      document.body.insertAdjacentHTML('beforeend', markup);
    },
    viewerOf(full) + viewerOf(full),
  );
  await allReady(page);
  for (const one of await page.locator('phong-viewer').all()) {
    expect(await samplesOf(one)).toBe(16);
  }
  await page.evaluate(() => {
    for (const one of [...document.querySelectorAll('phong-viewer')].slice(1)) {
      one.remove();
    }
  });
  await nextFrame(page);
  await allReady(page);
  expect(await seen.jsonValue(), 'the first picture has not changed').toEqual([]);
  same(await pixels(viewer), before);
});

test('a turning camera has no samples, and `ready` in the task that stops it has all', async ({
  mount,
}) => {
  const viewer = await mount(viewerOf(full), size);
  await converged(viewer);
  await set(viewer, { autoRotate: 90 });
  await expect.poll(() => samplesOf(viewer)).toBe(0);
  const stopped = await viewer.evaluate(async (element) => {
    element.autoRotate = 0;
    await element.ready;
    return element.stats.samples;
  });
  expect(stopped).toBe(16);
});

/** Contexts of the page lack these extensions. */
const without = (page: Page, ...names: string[]) =>
  page.addInitScript((lacking) => {
    const { prototype } = WebGL2RenderingContext;

    const original = prototype.getExtension as (this: unknown, name: string) => unknown;
    prototype.getExtension = function (this: unknown, name: string) {
      return lacking.includes(name) ? null : original.call(this, name);
    } as typeof prototype.getExtension;
  }, names);

test('without float targets `full` is like `edges`, and `stats` says so', async ({
  page,
  mount,
}) => {
  await without(page, 'EXT_color_buffer_float');
  await countEverything(page);
  const viewer = await mount(
    viewerOf(`${full} segments="24"`) + viewerOf(full.replace('torus', 'box')),
    size,
  );
  const seen = await renders(viewer);
  await assign(viewer, { theta: 40 });
  await allReady(page);
  await nextFrame(page);
  await expectIdle(page, 200);
  expect((await seen.jsonValue()).map(({ samples }) => samples)).toEqual([0]);
  const shown = await pixels(viewer);
  const sampled = await pixels(viewer, { samples: 64 });
  same(sampled, shown, 'toBlob');
  await assign(viewer, { antialias: 'edges' });
  await allReady(page);
  same(await pixels(viewer), shown, '`edges`');
  await assign(viewer, { antialias: 'full', autoRotate: 90 });
  await allReady(page); // while it turns
  expect(await samplesOf(viewer)).toBe(0);
  await assign(viewer, { autoRotate: 0 });
  for (let i = 0; i < 3; i++) {
    await nextFrame(page); // it finds out once it has stood still for a few
  }
  await expectIdle(page, 200);
});

test('toBlob({ samples }) is the picture that a viewer of that size converges to', async ({
  mount,
}) => {
  const viewer = await mount(viewerOf(full), { width: 90, height: 70 });
  await converged(viewer);
  const wanted = await pixels(viewer);
  await assign(viewer, { antialias: 'edges' });
  const options = { width: 90, height: 70, samples: 16 };
  same(await pixels(viewer, options), wanted);
  for (const samples of [0, 1.5, 1025, 'many']) {
    await expect(pixels(viewer, { samples: samples as number })).rejects.toThrow(
      /RangeError.*samples/,
    );
  }
});

test('samples of a round shape have more triangles than the plain picture, which comes back', async ({
  mount,
}) => {
  const viewer = await mount(viewerOf('geometry="sphere" samples="16"'), size);
  const plain = await trianglesOf(viewer);
  await assign(viewer, { antialias: 'full' });
  await converged(viewer);
  expect((await trianglesOf(viewer)) / plain).toBeGreaterThan(2);
  await set(viewer, { antialias: 'edges' });
  expect(await trianglesOf(viewer)).toBe(plain);
});
