// What does an open panel cost while nothing changes, and for changes that it does not show?

import { expect, test } from '../../support/test.js';
import { countEverything, spentIn } from '../support/counting.js';
import { assign, type PhongViewer } from '../support/viewer.js';
import { field, folderOf, opened } from './panel-rows.js';

const scene = `<phong-viewer gui geometry="box">
  <phong-light name="sun" position="1 2 1 0"></phong-light>
  <phong-light name="spot" position="0 3 3 1" axis="0 -1 -1" aperture="20"></phong-light>
</phong-viewer>`;

const RESTING = { frames: 0, timers: 0, idleCallbacks: 0 };

test('requests no frame and no timer while nothing changes, folders open', async ({ page, mount }) => {
  await countEverything(page);
  const viewer = await mount(scene);
  for (const title of ['sun', 'spot', 'Camera', 'Shading', 'Show', 'Material']) await opened(viewer, title);
  await page.mouse.move(10, 390);
  await spentIn(page, 300);
  expect(await spentIn(page, 1000)).toMatchObject(RESTING);
});

test('refreshes once for many writes in one task', async ({ mount }) => {
  const viewer = await mount(scene);
  const folder = await opened(viewer, 'sun');
  const reads = await viewer.evaluate(async (element: PhongViewer) => {
    const light = element.lights[0]!;
    const place = element.shadowRoot!.querySelector('.lil-root')!;
    let changes = 0;
    const observer = new MutationObserver((records) => (changes += records.length));
    observer.observe(place, { subtree: true, attributes: true, attributeFilter: ['aria-valuetext'] });
    for (let i = 0; i < 100; i++) light.diffuse = light.specular = light.ambient = [i, 0, 0];
    await Promise.resolve();
    await Promise.resolve();
    await element.ready;
    return changes;
  });
  expect(reads).toBe(3);
  await expect(field(folder, 'diffuse')).toHaveValue('99 0 0');
});

test('keeps up with a light that moves in every frame', async ({ mount }) => {
  const viewer = await mount(scene);
  const folder = await opened(viewer, 'sun');
  await viewer.evaluate(
    (element: PhongViewer) =>
      new Promise<void>((resolve) => {
        let frame = 0;
        const step = (): void => {
          element.lights[0]!.position = [++frame, 0, 0, 0];
          if (frame < 30) requestAnimationFrame(step);
          else resolve();
        };
        step();
      }),
  );
  await expect(field(folder, 'position x')).toHaveValue('30');
  await assign(viewer.locator('phong-light').first(), { name: 'moon' });
  await expect(folderOf(viewer, 'moon')).toBeVisible();
});
