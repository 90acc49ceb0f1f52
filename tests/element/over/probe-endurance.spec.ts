// Does the probe survive removals and lost contexts, work at most once a frame, and rest while nothing happens? Places
// are CSS pixels of the viewer.

import type { Locator } from '@playwright/test';
import { expect, test } from '../../support/test.js';
import { countEverything, NOTHING, spentIn } from '../support/counting.js';
import { assign, loseContext, nextFrame, type PhongViewer, settled } from '../support/viewer.js';

const LIGHTS = `<phong-light name="sun" position="-1 1.4 1.2 0"></phong-light><phong-light name="lamp" position="1 1 1 1"></phong-light>`;

const scene = (attributes = 'probe'): string =>
  `<phong-viewer geometry="sphere" segments="64" theta="0" phi="90" radius="1.6" target="0 0 0" ${attributes}>${LIGHTS}</phong-viewer>`;

const box = (viewer: Locator): Locator => viewer.locator('[part=probe]');

test('explains at most once a frame, for any number of events, finally the last place, and draws no picture', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene());
  await page.mouse.move(280, 130);
  await expect(box(viewer)).toBeVisible();
  const { shown, expected, times, frames } = await viewer.evaluate(async (element: PhongViewer) => {
    const { shadeAt, stats } = element;
    const times: number[] = [];
    element.shadeAt = (x, y) => {
      times.push(Number(document.timeline.currentTime));
      return shadeAt.call(element, x, y);
    };
    const surface = element.shadowRoot!.querySelector('.surface')!;
    for (let i = 0; i < 60; i++) {
      const place = { clientX: 250 + i, clientY: 150, bubbles: true };
      surface.dispatchEvent(new PointerEvent('pointermove', { ...place, pointerType: 'mouse' }));
      if (i % 10 === 9) await new Promise(requestAnimationFrame);
    }
    await new Promise(requestAnimationFrame);
    await new Promise(requestAnimationFrame);
    const shown = element.shadowRoot!.querySelector('[part=probe] .codes')!.textContent;
    const { color } = (await shadeAt.call(element, 309, 150))!;
    const expected = color.map((c) => (255 * c).toFixed(1)).join(' ');
    return { shown, expected, times, frames: element.stats.frames - stats.frames };
  });
  expect(shown).toBe(expected);
  expect(times.length).toBeGreaterThan(0);
  expect(times.length).toBeLessThan(14);
  expect(new Set(times).size, 'no two in one frame').toBe(times.length);
  expect(frames).toBe(0);
});

test('rests: no frame and no timer while nothing happens', async ({ page, mount }) => {
  await countEverything(page);
  const viewer = await mount(scene('probe probe-at="0 0 0.5"'));
  await page.mouse.move(280, 130);
  await page.mouse.click(280, 130);
  await expect(box(viewer)).toHaveClass(/pinned/);
  await page.waitForTimeout(1500); // the pause after an announcement
  expect(await spentIn(page, 500)).toEqual(NOTHING);
});

test('never throws when lights, meshes and the viewer are removed under the mouse', async ({ page, mount }) => {
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
  const restore = await loseContext(viewer);
  await page.waitForTimeout(100);
  await assign(viewer.locator('phong-light').first(), { diffuse: [0, 0, 200] });
  await restore();
  await settled(viewer);
  await page.mouse.move(290, 130);
  const color = await viewer.evaluate(async (element: PhongViewer) => (await element.shadeAt(290, 130))!.color);
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
