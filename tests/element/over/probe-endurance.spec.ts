// Does the probe survive removals and lost contexts, work at most once a frame, and rest while nothing happens? Places
// are CSS pixels of the viewer.

import type { Locator } from '@playwright/test';
import { expect, test } from '../../support/test.js';
import { assign, nextFrame, type PhongViewer } from '../support/viewer.js';

const LIGHTS = `<phong-light name="sun" position="-1 1.4 1.2 0"></phong-light><phong-light name="lamp" position="1 1 1 1"></phong-light>`;

const scene = (attributes = 'probe', lights = LIGHTS): string =>
  `<phong-viewer geometry="sphere" segments="64" theta="0" phi="90" radius="1.6" target="0 0 0" ${attributes}>${lights}</phong-viewer>`;

const box = (viewer: Locator): Locator => viewer.locator('[part=probe]');

/** Counts explanations, animation frames and timers from now on. */
const counted = (viewer: Locator) =>
  viewer.evaluateHandle((element: PhongViewer) => {
    const counts = { explained: 0, frames: 0, timers: 0, frameTimes: [] as number[] };
    const { shadeAt } = element;
    element.shadeAt = (x, y) => {
      counts.explained += 1;
      counts.frameTimes.push(Number(document.timeline.currentTime));
      return shadeAt.call(element, x, y);
    };
    const { requestAnimationFrame: request, setTimeout: wait } = window;
    window.requestAnimationFrame = (callback) => {
      counts.frames += 1;
      return request.call(window, callback);
    };
    window.setTimeout = ((...given: Parameters<typeof setTimeout>) => {
      counts.timers += 1;
      return wait.apply(window, given);
    }) as typeof setTimeout;
    return counts;
  });

test('explains at most once a frame, for any number of events, and finally the last place', async ({
  mount,
}) => {
  const viewer = await mount(scene());
  await expect(box(viewer)).toHaveCount(1);
  const counts = await counted(viewer);
  const last = await viewer.evaluate(async (element: PhongViewer) => {
    const surface = element.shadowRoot!.querySelector('.surface')!;
    for (let i = 0; i < 60; i++) {
      const place = { clientX: 250 + i, clientY: 150, bubbles: true };
      surface.dispatchEvent(new PointerEvent('pointermove', { ...place, pointerType: 'mouse' }));
      if (i % 10 === 9) await new Promise(requestAnimationFrame);
    }
    await new Promise(requestAnimationFrame);
    await new Promise(requestAnimationFrame);
    const shown = element.shadowRoot!.querySelector('[part=probe] .codes')!.textContent;
    const { color } = (await element.shadeAt(309, 150))!;
    return [shown, color.map((c) => (255 * c).toFixed(1)).join(' ')];
  });
  expect(last[0]).toBe(last[1]);
  const { explained, frameTimes } = await counts.jsonValue();
  expect(explained).toBeLessThan(15);
  const own = frameTimes.slice(0, -1);
  expect(new Set(own).size, 'no two in one frame').toBe(own.length);
});

test('rests: no explanation, no frame and no timer while nothing happens', async ({ page, mount }) => {
  const viewer = await mount(scene('probe probe-at="0 0 0.5"'));
  await page.mouse.move(280, 130);
  await page.mouse.click(280, 130);
  await expect(box(viewer)).toHaveClass(/pinned/);
  await page.waitForTimeout(1500); // the pause after an announcement
  const counts = await counted(viewer);
  await page.waitForTimeout(500);
  expect(await counts.jsonValue()).toMatchObject({ explained: 0, frames: 0, timers: 0 });
});

test('draws no frame of the viewer when the mouse moves', async ({ page, mount }) => {
  const viewer = await mount(scene());
  await page.mouse.move(280, 130);
  await expect(box(viewer)).toBeVisible();
  const frames = (): Promise<number> => viewer.evaluate((element: PhongViewer) => element.stats.frames);
  const before = await frames();
  for (let i = 0; i < 5; i++) await page.mouse.move(281 + i, 130);
  await nextFrame(page);
  expect(await frames()).toBe(before);
});

test('never throws when lights, meshes and the viewer are removed under the mouse', async ({
  page,
  mount,
}) => {
  const viewer = await mount(`${scene()}${scene('probe probe-at="0 0 0.5"')}`);
  await page.mouse.move(280, 130);
  await expect(box(viewer)).toBeVisible();
  await viewer.evaluate((element: PhongViewer) => element.replaceChildren());
  await page.mouse.move(281, 130);
  await expect(box(viewer).locator('tbody th')).toHaveText(['head-light']);
  await assign(viewer, { geometry: null });
  await expect(box(viewer)).toBeHidden();
  await page.mouse.move(282, 130);
  await assign(viewer, { geometry: 'box', radius: 0.1 });
  await page.mouse.move(283, 130);
  await viewer.evaluate((element: PhongViewer) => {
    element.probeAt = [0, 0, 0];
    element.remove();
  });
  await nextFrame(page);
  await expect(page.locator('[part=probe]'), 'the other viewer has its own').toHaveCount(1);
});

test('continues after a lost context', async ({ page, mount }) => {
  const viewer = await mount(scene());
  await page.mouse.move(280, 130);
  await expect(box(viewer)).toBeVisible();
  await viewer.evaluate(async (element: PhongViewer) => {
    const canvas = element.shadowRoot!.querySelector('canvas')!;
    const lose = canvas.getContext('webgl2')!.getExtension('WEBGL_lose_context')!;
    lose.loseContext();
    await new Promise((resolve) => setTimeout(resolve, 100));
    element.lights[0]!.diffuse = [0, 0, 200];
    lose.restoreContext();
    await new Promise((resolve) => element.addEventListener('render', resolve, { once: true }));
  });
  await page.mouse.move(290, 130);
  const color = await viewer.evaluate(
    async (element: PhongViewer) => (await element.shadeAt(290, 130))!.color,
  );
  await expect(box(viewer).locator('.codes')).toHaveText(color.map((c) => (255 * c).toFixed(1)).join(' '));
});

test('follows the mouse on a mesh of 100,000 triangles without copying or sorting it again', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene('probe').replace('segments="64"', 'segments="320"'));
  await page.mouse.move(280, 130);
  await expect(box(viewer)).toBeVisible();
  const read = await viewer.evaluate(async (element: PhongViewer) => {
    const mesh = element.scene.getObjectByProperty('isMesh', true) as unknown as {
      geometry: { index: { count: number; getX(i: number): number } };
    };
    const { index } = mesh.geometry;
    const { getX } = index;
    let corners = 0;
    index.getX = (i) => {
      corners += 1;
      return getX.call(index, i);
    };
    await element.shadeAt(300, 150);
    return [index.count / 3, corners] as const;
  });
  expect(read[0]).toBeGreaterThan(100_000);
  // Of the runs of triangles that the ray meets.
  expect(read[1]).toBeLessThan(5000);
});
