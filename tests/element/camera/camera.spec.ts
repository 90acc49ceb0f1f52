// Where is the camera, and what moves it besides drags: wheel, keys, properties, `auto`, time? Numbers are compared
// with float64 formulas computed here. Viewers are 600 × 400 CSS pixels unless a test says otherwise.

import type { Locator } from '@playwright/test';
import { expect, test } from '../../support/test.js';
import { assign, cameraOf, drag, type PhongViewer, record, settled } from '../support/viewer.js';

const near = '<phong-viewer geometry="box" theta="30" phi="70" radius="5"></phong-viewer>';
const radians = (degrees: number): number => (degrees * Math.PI) / 180;

test.describe('the wheel', () => {
  test('scrolls the page until a press gives focus, and then zooms', async ({ page, mount }) => {
    const viewer = await mount(`${near}<div class="tall"></div>`, { css: '.tall { height: 3000px }' });
    await page.mouse.move(300, 200);
    await page.mouse.wheel(0, 50);
    await expect.poll(() => page.evaluate(() => scrollY)).toBe(50);
    expect((await cameraOf(viewer)).radius).toBe(5);

    await page.mouse.down();
    await page.mouse.up();
    await page.mouse.wheel(0, 100);
    await expect.poll(async () => (await cameraOf(viewer)).radius).toBeCloseTo(5 * Math.exp(0.1), 12);
    await page.mouse.wheel(0, -250);
    await expect.poll(async () => (await cameraOf(viewer)).radius).toBeCloseTo(5 * Math.exp(-0.15), 12);
    expect(await page.evaluate(() => scrollY)).toBe(50);

    await assign(viewer, { zoom: false });
    await page.mouse.wheel(0, 100);
    await expect.poll(() => page.evaluate(() => scrollY)).toBe(150);
    expect((await cameraOf(viewer)).radius).toBeCloseTo(5 * Math.exp(-0.15), 12);
  });
});

test.describe('keys', () => {

  test('zoom by 1.1, and Home goes back to the declared camera', async ({ page, mount }) => {
    const viewer = await mount(near);
    await page.keyboard.press('Tab');
    for (const [key, radius] of [
      ['+', 5 / 1.1],
      ['PageDown', 5],
      ['-', 5.5],
      ['PageUp', 5],
    ] as const) {
      await page.keyboard.press(key);
      expect((await cameraOf(viewer)).radius, key).toBeCloseTo(radius, 12);
    }
    await page.keyboard.press('PageUp');
    await drag(page, [300, 200], [60, 40]);
    await drag(page, [300, 200], [60, 40], { button: 'right' });
    await page.keyboard.press('Home');
    expect(await cameraOf(viewer)).toMatchObject({ theta: 30, phi: 70, radius: 5, target: [0, 0, 0] });
  });
});

test('keys that the viewer uses do not reach the page, where they would turn a slide; others do', async ({
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
  const reached = async (target: Locator, ...keys: readonly string[]): Promise<string[]> => {
    await target.focus();
    for (const key of keys) await page.keyboard.press(key);
    return page.evaluate(() => (window as unknown as { keys: string[] }).keys.splice(0));
  };
  expect(await reached(viewer.locator('[part~=surface]').first(), 'ArrowLeft', '+', 'Home', 'n')).toEqual([
    'n',
  ]);
  expect(await reached(page.getByRole('separator'), 'ArrowRight', 'End', 'n')).toEqual(['n']);
  expect(await reached(viewer.getByRole('button', { name: 'add light' }), ' ', 'Enter', 'Escape')).toEqual([
    'Escape',
  ]);
  expect(
    await reached(
      viewer.getByRole('listbox', { name: 'Lights in the picture' }).locator('> *').first(),
      'Enter',
      'ArrowUp',
      'Enter',
    ),
  ).toEqual([]);
});

test.describe('camera', () => {
  test('gives eye, target and up for the angles, and wraps θ into [-180, 180)', async ({ mount }) => {
    const viewer = await mount(near);
    for (const [given, theta] of [
      [180, -180],
      [190, -170],
      [-180, -180],
      [-181, 179],
      [750, 30],
      [1e20, null],
    ] as const) // prettier-ignore
    {
      await assign(viewer, { theta: given, phi: 50, target: [1, 2, 3] });
      const camera = await cameraOf(viewer);
      if (theta !== null) expect(camera.theta).toBe(theta);
      expect(camera.theta).toBeGreaterThanOrEqual(-180);
      expect(camera.theta).toBeLessThan(180);
      const t = radians(camera.theta);
      const p = radians(50);
      const back = [Math.sin(p) * Math.sin(t), Math.cos(p), Math.sin(p) * Math.cos(t)];
      const up = [-Math.cos(p) * Math.sin(t), Math.sin(p), -Math.cos(p) * Math.cos(t)];
      for (const i of [0, 1, 2] as const) {
        expect(camera.eye[i]).toBeCloseTo([1, 2, 3][i]! + 5 * back[i]!, 12);
        expect(camera.up[i]).toBeCloseTo(up[i]!, 12);
      }
      expect(camera.target).toEqual([1, 2, 3]);
    }
  });

  test('is a frozen snapshot that later moves do not affect', async ({ mount }) => {
    const viewer = await mount(near);
    const facts = await viewer.evaluate((element: PhongViewer) => {
      const { camera } = element;
      element.theta = 90;
      const parts = [camera, camera.eye, camera.target, camera.up];
      return { frozen: parts.every((part) => Object.isFrozen(part)), theta: camera.theta };
    });
    expect(facts).toEqual({ frozen: true, theta: 30 });
  });

  test('follows properties at once, in the same task', async ({ mount }) => {
    const viewer = await mount(near);
    const cameras = await viewer.evaluate((element: PhongViewer) => {
      element.theta = 10;
      element.phi = 20;
      element.radius = 7;
      element.target = [1, 0, 0];
      const moved = element.camera;
      element.setAttribute('theta', '11');
      element.removeAttribute('phi');
      return [moved, element.camera];
    });
    expect(cameras[0]).toMatchObject({ theta: 10, phi: 20, radius: 7, target: [1, 0, 0] });
    expect(cameras[1]).toMatchObject({ theta: 11, phi: 70 });
  });

  test('resetCamera returns to the last declared camera, not to the first', async ({ page, mount }) => {
    const viewer = await mount('<phong-viewer geometry="box" theta="30"></phong-viewer>');
    await assign(viewer, { theta: 45 });
    const declared = await cameraOf(viewer);
    await drag(page, [300, 200], [60, 40]);
    await page.mouse.wheel(0, 200);
    await drag(page, [300, 200], [60, 40], { button: 'right' });
    await viewer.evaluate((element: PhongViewer) => element.resetCamera());
    expect(await cameraOf(viewer)).toEqual(declared);
  });
});

test.describe('camera-change', () => {
  test('names its source, once per task', async ({ page, mount }) => {
    const viewer = await mount(near);
    const events = await record(viewer, 'camera-change');
    const sources = async (): Promise<unknown[]> =>
      (await events.take()).map(({ detail }) => (detail as { source: string }).source);
    await assign(viewer, { theta: 1, phi: 2, radius: 3, target: [4, 5, 6] });
    expect(await sources()).toEqual(['script']);
    await assign(viewer, { theta: 1 });
    expect(await sources()).toEqual([]);
    await viewer.focus();
    await page.keyboard.press('ArrowLeft');
    expect(await sources()).toEqual(['key']);
    await page.keyboard.press('Home');
    expect(await sources()).toEqual(['key']);
    await page.mouse.move(300, 200);
    await page.mouse.wheel(0, 100);
    await expect.poll(sources).toEqual(['wheel']);
    await drag(page, [300, 200], [30, 0], { steps: 3 });
    expect(await sources()).toEqual(['pointer', 'pointer', 'pointer']);
    await viewer.evaluate((element: PhongViewer) => element.resetCamera());
    expect(await sources()).toEqual(['script']);
    await assign(viewer, { radius: 'auto', target: 'auto' });
    await sources();
    await assign(viewer, { geometry: 'torus' });
    await settled(viewer);
    expect(await sources()).toEqual(['auto']);
  });

  test('does not bubble and is not dispatched for the initial camera', async ({ page, mount }) => {
    await mount('<main></main>');
    const heard = await page.evaluate(async () => {
      const sources: string[] = [];
      let bubbled = 0;
      document.addEventListener('camera-change', () => (bubbled += 1));
      const element = document.createElement('phong-viewer');
      element.addEventListener('camera-change', (event) =>
        sources.push((event as CustomEvent<{ source: string }>).detail.source),
      );
      element.setAttribute('theta', '12');
      document.querySelector('main')?.append(element);
      await element.ready;
      const first = [...sources];
      element.theta = 40;
      await element.ready;
      return { first, after: sources, bubbled };
    });
    expect(heard).toEqual({ first: [], after: ['script'], bubbled: 0 });
  });
});
