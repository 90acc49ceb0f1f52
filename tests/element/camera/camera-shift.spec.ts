// Does the target follow the secondary button, Shift and a drag, and two fingers? Viewers are 600 × 400 CSS pixels;
// fingers are Chromium's own touch input.

import { expect, test } from '../../support/test.js';
import { cameraOf, drag, Fingers } from '../support/viewer.js';

test.describe('shifting the target', () => {
  // At the target's distance one CSS pixel is 2 r tan(fov/2) / height scene units; at θ = φ = 90° right is −z, up is
  // +y.
  const side = '<phong-viewer geometry="box" theta="90" phi="90" radius="5"></phong-viewer>';
  const perPixel = (2 * 5 * Math.tan(Math.PI / 8)) / 400;

  for (const [what, button, keys] of [
    ['the secondary button', 'right', []],
    ['Shift and a drag', 'left', ['Shift']],
  ] as const) {
    test(`${what} makes the scene follow the pointer`, async ({ page, mount }) => {
      const viewer = await mount(side);
      for (const key of keys) await page.keyboard.down(key);
      await drag(page, [300, 200], [50, 20], { button });
      for (const key of keys) await page.keyboard.up(key);
      const { target, theta, phi, radius } = await cameraOf(viewer);
      expect({ theta, phi, radius }).toEqual({ theta: 90, phi: 90, radius: 5 });
      expect(target[0]).toBeCloseTo(0, 14);
      expect(target[1]).toBeCloseTo(20 * perPixel, 14);
      expect(target[2]).toBeCloseTo(50 * perPixel, 14);
    });
  }
});

test.describe('fingers', () => {
  test.use({ hasTouch: true });
  const near = '<phong-viewer geometry="box" theta="30" phi="70" radius="5"></phong-viewer>';

  test('one finger turns as the mouse does', async ({ page, mount }) => {
    const viewer = await mount(near);
    const fingers = await Fingers.on(page);
    await fingers.down([300, 200]);
    await fingers.move([330, 200]);
    await fingers.move([360, 240]);
    await fingers.up();
    expect(await cameraOf(viewer)).toMatchObject({ theta: -6, phi: 52 });
  });

  test('a stroke down the picture scrolls the page and does not tilt it', async ({ page, mount }) => {
    const viewer = await mount(`${near}<div class="tall"></div>`, { css: '.tall { height: 3000px }' });
    const fingers = await Fingers.on(page);
    await fingers.down([300, 350]);
    for (let y = 345; y >= 150; y -= 5) await fingers.move([300, y]);
    await fingers.up();
    await expect.poll(() => page.evaluate(() => scrollY)).toBeGreaterThan(100);
    expect(await cameraOf(viewer)).toMatchObject({ theta: 30, phi: 70 });
  });
});
