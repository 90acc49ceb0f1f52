// What is announced to a screen reader? Only what the user did, once the motion has ended.

import type { Locator } from '@playwright/test';
import { expect, test } from '../support/test.js';
import { opened } from '../extras/panel/panel-rows.js';
import { assign, drag, type PhongViewer } from '../element/support/viewer.js';

const scene = (attributes = ''): string =>
  `<phong-viewer alt="A box" geometry="box" theta="30" phi="70" radius="4" ${attributes}>
    <phong-light name="sun" position="1 2 3 0"></phong-light><phong-light name="lamp" position="1 2 3 1"></phong-light>
  </phong-viewer>`;

/** Longer than the pause before an announcement. */
const A_WHILE = 1500;

const region = (viewer: Locator): Locator => viewer.locator('.reader > [aria-live]');

test('a key, the wheel and a drag are announced politely, with the resulting camera', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene());
  await expect(region(viewer)).toHaveCount(0);
  await page.keyboard.press('Tab');
  await page.keyboard.press('ArrowLeft');
  await expect(region(viewer)).toHaveAttribute('aria-live', 'polite');
  await expect(region(viewer)).toHaveText('Camera: azimuth 35°, polar angle 70°, distance 4.');
  await page.mouse.move(300, 200);
  await page.mouse.wheel(0, 100);
  await expect(region(viewer)).toHaveText('Camera: azimuth 35°, polar angle 70°, distance 4.42.');
  await drag(page, [300, 200], [50, 0]);
  await expect(region(viewer)).toHaveText('Camera: azimuth 5°, polar angle 70°, distance 4.42.');
  await page.keyboard.press('Home');
  await expect(region(viewer)).toHaveText('Camera: azimuth 30°, polar angle 70°, distance 4.');
  await expect(region(viewer)).toHaveCount(1);
});

test('a motion of many steps is announced once, when it has ended', async ({ mount }) => {
  const viewer = await mount(scene());
  const texts = await viewer.evaluateHandle(async (element: PhongViewer) => {
    const list: string[] = [];
    const reader = element.shadowRoot!.querySelector('.reader')!;
    new MutationObserver(() => {
      const text = reader.querySelector('[aria-live]')?.textContent ?? '';
      if (text !== '' && text !== list.at(-1)) {
        list.push(text);
      }
    }).observe(reader, { subtree: true, childList: true, characterData: true });
    const surface = element.shadowRoot!.querySelector('.surface')!;
    for (let i = 0; i < 30; i++) {
      surface.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft' }));
      await new Promise(requestAnimationFrame);
    }
    return list;
  });
  const once = ['Camera: azimuth −180°, polar angle 70°, distance 4.'];
  await expect.poll(() => texts.evaluate((list) => [...list])).toEqual(once);
});

test('scripts and auto-rotate announce nothing, not even together with user input', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene());
  await viewer.evaluate(async (element: PhongViewer) => {
    element.theta = 10;
    element.lights[0]!.active = false;
    element.append(document.createElement('phong-light'));
    element.resetCamera();
    element.autoRotate = 20;
    const end = element.stats.frames + 5;
    while (element.stats.frames < end) {
      await new Promise(requestAnimationFrame);
    }
    element.autoRotate = 0;
  });
  await page.waitForTimeout(A_WHILE);
  await expect(region(viewer)).toHaveCount(0);
  await viewer.evaluate((element: PhongViewer) => {
    element.theta = 30;
    element.lights[1]!.diffuse = '#f00';
    element
      .shadowRoot!.querySelector('.surface')!
      .dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft' }));
  });
  await expect(region(viewer)).toHaveText('Camera: azimuth 35°, polar angle 70°, distance 4.');
});

test('changes by the panel are announced; changes by a script meanwhile are not', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene('gui'));
  await viewer.getByRole('checkbox', { name: 'lamp active' }).uncheck();
  await assign(page.locator('phong-light').first(), { diffuse: '#f00' });
  await expect(region(viewer)).toHaveText(
    'lamp (off): point light, position 1 2 3, diffuse 255 255 255.',
  );
  await viewer.getByRole('button', { name: 'add light' }).click();
  await expect(region(viewer)).toHaveText('Lights: 3.');
  const folder = await opened(viewer, 'Camera');
  await folder.getByRole('textbox', { name: 'θ azimuth' }).fill('90');
  await expect(region(viewer)).toHaveText('Camera: azimuth 90°, polar angle 70°, distance 4.');
});
