// What is announced to a screen reader, where it takes layout? Only what the user did, once the
// motion has ended; unit/elements/announcements.test.ts has keys, the wheel and scripts.

import { type ViewerLocator, expect, test } from '../support/test.js';
import { opened } from '../extras/panel/panel-rows.js';
import { assign, drag } from '../element/support/viewer.js';

const scene = (attributes = '') =>
  `<phong-viewer alt="A box" geometry="box" theta="30" phi="70" radius="4" ${attributes}>
    <phong-light name="sun" position="1 2 3 0"></phong-light><phong-light name="lamp" position="1 2 3 1"></phong-light>
  </phong-viewer>`;

/** Longer than the pause before an announcement. */
const A_WHILE = 1500;

const region = (viewer: ViewerLocator) => viewer.locator('.reader > [aria-live]');

test('a drag is announced politely, with the resulting camera; auto-rotate is not', async ({
  page,
  mount,
}) => {
  const viewer = await mount(scene('auto-rotate="20"'));
  await viewer.evaluate(async (element) => {
    const end = element.stats.frames + 5;
    while (element.stats.frames < end) {
      await new Promise(requestAnimationFrame);
    }
    element.autoRotate = 0;
    element.resetCamera();
  });
  await page.waitForTimeout(A_WHILE);
  await expect(region(viewer)).toHaveCount(0);
  await drag(page, [300, 200], [50, 0]);
  await expect(region(viewer)).toHaveAttribute('aria-live', 'polite');
  await expect(region(viewer)).toHaveText('Camera: azimuth 0°, polar angle 70°, distance 4.');
  await expect(region(viewer)).toHaveCount(1);
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
