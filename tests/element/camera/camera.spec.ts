// Where is the camera, and what moves it besides drags: wheel, keys, properties, `auto`, time?
// Numbers are compared with float64 formulas computed here. Viewers are 600 × 400 CSS pixels unless
// a test says otherwise.

import type { Locator } from '@playwright/test';
import { expect, test } from '../../support/test.js';
import { assign, cameraOf, drag, nextFrame, record } from '../support/viewer.js';

const near = '<phong-viewer geometry="box" theta="30" phi="70" radius="5"></phong-viewer>';

test('the wheel scrolls the page until a press gives focus, and then zooms', async ({
  page,
  mount,
}) => {
  const viewer = await mount(`${near}<div class="tall"></div>`, {
    css: '.tall { height: 3000px }',
  });
  await page.mouse.move(300, 200);
  await page.mouse.wheel(0, 50);
  await expect.poll(() => page.evaluate(() => scrollY)).toBe(50);
  expect((await cameraOf(viewer)).radius).toBe(5);

  await page.mouse.down();
  await page.mouse.up();
  await page.mouse.wheel(0, 100);
  await expect.poll(async () => (await cameraOf(viewer)).radius).toBeCloseTo(5 * Math.exp(0.1), 6);
  await page.mouse.wheel(0, -250);
  await expect
    .poll(async () => (await cameraOf(viewer)).radius)
    .toBeCloseTo(5 * Math.exp(-0.15), 6);
  expect(await page.evaluate(() => scrollY)).toBe(50);

  await assign(viewer, { zoom: false });
  await page.mouse.wheel(0, 100);
  await expect.poll(() => page.evaluate(() => scrollY)).toBe(150);
  expect((await cameraOf(viewer)).radius).toBeCloseTo(5 * Math.exp(-0.15), 6);
});

test('keys that a viewer uses do not reach the page (they may turn slides); others do', async ({
  page,
  mount,
}) => {
  const viewer = await mount(
    '<phong-viewer geometry="box" gui helpers="lights"><phong-light></phong-light></phong-viewer>' +
      '<phong-compare><phong-viewer></phong-viewer><phong-viewer></phong-viewer></phong-compare>',
    { width: 900, height: 300 },
  );
  await viewer.getByText('add light').waitFor();
  await page.evaluate(() => {
    const keys: string[] = [];
    document.addEventListener('keydown', ({ key }) => keys.push(key));
    Object.assign(window, { keys });
  });
  const list = viewer.getByRole('listbox', { name: 'Lights in the picture' });
  const rows: readonly (readonly [
    target: Locator,
    keys: readonly string[],
    reach: readonly string[],
  ])[] = [
    [viewer.locator('[part~=surface]').first(), ['ArrowLeft', '+', 'Home', 'n'], ['n']],
    [page.getByRole('separator'), ['ArrowRight', 'End', 'n'], ['n']],
    [viewer.getByRole('button', { name: 'add light' }), [' ', 'Enter', 'Escape'], ['Escape']],
    [list.locator('> *').first(), ['Enter', 'ArrowUp', 'Enter'], []],
  ];
  for (const [target, keys, reach] of rows) {
    await target.focus();
    for (const key of keys) {
      await page.keyboard.press(key);
    }
    const reached = await page.evaluate(() =>
      (window as unknown as { keys: string[] }).keys.splice(0),
    );
    expect(reached).toEqual(reach);
  }
});

test('`camera` is a frozen snapshot that follows properties at once, with θ in [-180, 180)', async ({
  mount,
}) => {
  const viewer = await mount(near);
  const [frozen, first, moved, last] = await viewer.evaluate((element) => {
    const { camera } = element;
    const parts = [camera, camera.eye, camera.target, camera.up];
    Object.assign(element, { theta: 180, phi: 90, radius: 7, target: [1, 0, 0] });
    const moved = element.camera;
    element.setAttribute('theta', '551');
    element.removeAttribute('phi');
    return [parts.every((part) => Object.isFrozen(part)), camera, moved, element.camera] as const;
  });
  expect(frozen).toBe(true);
  expect(first).toMatchObject({ theta: 30, phi: 70, radius: 5 });
  expect(moved).toEqual({
    theta: -180,
    phi: 90,
    radius: 7,
    target: [1, 0, 0],
    eye: [1, 0, -7],
    up: [0, 1, 0],
  });
  expect(last).toMatchObject({ theta: -169, phi: 70, radius: 7 });
});

test('Home and resetCamera return to the last declared camera, not to the first', async ({
  page,
  mount,
}) => {
  const viewer = await mount('<phong-viewer geometry="box" theta="30"></phong-viewer>');
  await assign(viewer, { theta: 45 });
  const declared = await cameraOf(viewer);
  for (const reset of [
    () => page.keyboard.press('Home'),
    () => viewer.evaluate((element) => element.resetCamera()),
  ]) {
    await drag(page, [300, 200], [60, 40]);
    await page.keyboard.press('PageUp');
    await drag(page, [300, 200], [60, 40], { button: 'right' });
    const { theta, radius, target } = await cameraOf(viewer);
    expect(theta).toBe(9);
    expect(radius).toBeCloseTo(declared.radius / 1.1, 6);
    expect(target).not.toEqual(declared.target);
    await reset();
    expect(await cameraOf(viewer)).toEqual(declared);
  }
});

test('camera-change comes once a task, only for another camera, never at the start, and does not bubble', async ({
  page,
  mount,
}) => {
  await mount('<main></main>');
  const early = await page.evaluate(async (html) => {
    let heard = 0;
    document.addEventListener('camera-change', () => (heard += 1), { capture: true });
    document.addEventListener('camera-change', () => console.error('it bubbles'));
    const main = document.querySelector('main')!;
    main.innerHTML = html;
    await main.querySelector('phong-viewer')!.ready;
    return heard;
  }, near);
  expect(early).toBe(0);
  const viewer = page.locator('phong-viewer');
  const events = await record(viewer, 'camera-change');
  await assign(viewer, { theta: 1, phi: 2, radius: 3, target: [4, 5, 6] });
  expect(await events.take()).toEqual([{ type: 'camera-change', detail: { source: 'script' } }]);
  await assign(viewer, { theta: 1 });
  expect(await events.take()).toEqual([]);
});

/** 1.05 R / sin(half the smaller field). */
const fitted = (reach: number, width: number, height: number, fov = 45) => {
  const vertical = (fov * Math.PI) / 360;
  const horizontal = Math.atan((Math.tan(vertical) * width) / height);
  return (1.05 * reach) / Math.sin(Math.min(vertical, horizontal));
};

test('auto refits to new meshes, size and field of view until the user moves the camera', async ({
  page,
  mount,
}) => {
  const viewer = await mount('<phong-viewer geometry="box"></phong-viewer>');
  const reach = Math.sqrt(0.75);
  const radius = async () => (await cameraOf(viewer)).radius;
  await assign(viewer, { theta: 90, fov: 60 });
  expect(await radius()).toBeCloseTo(fitted(reach, 600, 400, 60), 6);
  await viewer.evaluate((element) => Object.assign(element.style, { width: '200px' }));
  await expect.poll(radius).toBeCloseTo(fitted(reach, 200, 400, 60), 6);
  await viewer.evaluate((element) => {
    const mesh = document.createElement('phong-mesh');
    element.append(Object.assign(mesh, { geometry: 'box', position: [2, 0, 0] }));
  });
  expect((await cameraOf(viewer)).target).toEqual([1, 0, 0]);
  expect(await radius()).toBeCloseTo(fitted(Math.hypot(1.5, 0.5, 0.5), 200, 400, 60), 6);

  await drag(page, [100, 200], [10, 0]);
  const kept = await cameraOf(viewer);
  await assign(viewer, { fov: 30, geometry: null });
  await viewer.evaluate((element) => Object.assign(element.style, { width: '600px' }));
  await nextFrame(page);
  expect(await cameraOf(viewer)).toMatchObject({ radius: kept.radius, target: kept.target });
  await assign(viewer, { radius: 'auto' });
  expect(await radius()).not.toBe(kept.radius);
  // A declared radius stays.
  await assign(viewer, { radius: 5 });
  await assign(viewer, { geometry: 'torus', fov: 20 });
  expect(await radius()).toBe(5);
});
