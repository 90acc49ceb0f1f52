// Does the camera's folder follow every move of the camera, and move the camera itself?

import { expect, test } from '../../support/test.js';
import { assign, cameraOf, type PhongViewer, record } from '../../element/support/viewer.js';
import { button, field, opened, row, slider, titleOf } from './panel-rows.js';

const scene = '<phong-viewer gui geometry="box" theta="30" phi="70"></phong-viewer>';

test('shows a drag of the picture live, moves the camera as "panel", and resets it', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene);
  const folder = await opened(viewer, 'Camera');
  const start = await cameraOf(viewer);
  const theta = field(folder, 'θ azimuth °');
  await expect(theta).toHaveValue('30');
  await page.mouse.move(100, 100);
  await page.mouse.down();
  await page.mouse.move(160, 120);
  await expect(theta).toHaveValue('-6');
  await expect(field(folder, 'φ polar °')).toHaveValue('61');
  await expect(slider(folder, 'θ azimuth °')).toHaveValue('-6');
  await expect(slider(folder, 'θ azimuth °')).not.toHaveAttribute('style'); // the page restyles each
  await page.mouse.move(220, 120);
  await expect(theta).toHaveValue('-42');
  const { eye } = await cameraOf(viewer);
  const shown = (await row(folder, 'eye').locator('.lil-widget').textContent())!.split(', ');
  shown.forEach((n, i) => expect(Number(n)).toBeCloseTo(eye[i]!, 2));
  await page.mouse.up();
  await page.mouse.wheel(0, 200);
  const { radius } = await cameraOf(viewer);
  await expect
    .poll(async () => Number(await field(folder, 'radius').inputValue()))
    .toBeCloseTo(radius, 3);

  const moves = await record(viewer, 'camera-change');
  await slider(folder, 'θ azimuth °').fill('75');
  await field(folder, 'φ polar °').fill('45.5');
  await field(folder, 'radius').fill('6');
  await field(folder, 'target y').fill('0.25');
  const set = { theta: 75, phi: 45.5, radius: 6, target: [0, 0.25, 0] };
  expect(await cameraOf(viewer)).toMatchObject(set);
  const heard = await moves.take();
  expect(heard.length).toBeGreaterThanOrEqual(4);
  for (const { detail } of heard) {
    expect(detail).toEqual({ source: 'panel' });
  }
  await button(folder, 'reset camera').click();
  expect(await cameraOf(viewer)).toEqual(start);
  const declared = ({ theta, radius, target }: PhongViewer): object => ({ theta, radius, target });
  expect(await viewer.evaluate(declared)).toEqual({ theta: 30, radius: 'auto', target: 'auto' });
});

test('sets field of view and auto-rotate, and shows the present camera after a move', async ({
  mount,
}) => {
  const viewer = await mount(scene);
  const folder = await opened(viewer, 'Camera');
  const theta = field(folder, 'θ azimuth °');
  await field(folder, 'fov °').fill('60');
  await field(folder, 'auto-rotate').fill('10');
  expect(await viewer.evaluate(({ fov, autoRotate }) => [fov, autoRotate])).toEqual([60, 10]);
  const first = await theta.inputValue();
  await expect.poll(() => theta.inputValue()).not.toBe(first);
  await assign(viewer, { autoRotate: 0, fov: 30 });
  await expect(field(folder, 'fov °')).toHaveValue('30');
  for (const [title, angle] of [
    ['Camera', 12],
    ['Controls', 13],
  ] as const) {
    await titleOf(viewer, title).click();
    await assign(viewer, { theta: angle });
    await titleOf(viewer, title).click();
    await expect(theta).toHaveValue(String(angle));
  }
});
