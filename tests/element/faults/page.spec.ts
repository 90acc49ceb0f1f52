// Does the page get over what happens to it: aborted loads, failures that were fixed, a second copy of the bundle, CSS
// zoom?

import { expect, pixelAt, pixels, test } from '../../support/test.js';
import { nextFrame, type PhongMesh, type PhongViewer } from '../support/viewer.js';

const size = { width: 90, height: 60 };
const box = '<phong-viewer geometry="box"><phong-light></phong-light></phong-viewer>';

test('nothing waits for an aborted load in a viewer out of view', async ({ mount, page }) => {
  await page.route('**/never.glb', () => undefined); // no answer, ever
  const viewer = await mount('<phong-viewer hidden src="/never.glb"></phong-viewer>', {
    waitForReady: false,
  });
  const outcomes = await viewer.evaluate(async (element: PhongViewer) => {
    const outcome = (): Promise<unknown> =>
      Promise.race([element.ready.then(() => 'ready'), new Promise((resolve) => setTimeout(resolve, 5000, 'late'))]);
    const asked = outcome();
    element.removeAttribute('src');
    const first = await asked;
    const mesh = document.createElement('phong-mesh');
    mesh.src = '/never.glb';
    element.append(mesh);
    await new Promise((resolve) => setTimeout(resolve));
    const again = outcome();
    mesh.remove();
    return [first, await again, await outcome()];
  });
  expect(outcomes).toEqual(['ready', 'ready', 'ready']);
});

test('the message of a failure disappears with the failed element', async ({ mount, page, consoleGuard }) => {
  consoleGuard.allow(/404/);
  const viewer = await mount('<phong-viewer><phong-mesh src="/nowhere.glb"></phong-mesh></phong-viewer>');
  const notice = viewer.locator('[part=notice]');
  await expect(notice).toBeVisible();
  await page.locator('phong-mesh').evaluate((mesh: PhongMesh) => {
    mesh.src = '';
    mesh.geometry = 'box';
  });
  await expect(notice).toHaveCount(0);
});

test('two copies of the bundle on a page do no harm', async ({ page, mount }) => {
  const viewer = await mount(box, { ...size, head: '<script type="module" src="/dist/phong-viewer.standalone.js?copy"></script>' }); // prettier-ignore
  await page.addScriptTag({ type: 'module', url: '/dist/phong-viewer.standalone.js?again' });
  await nextFrame(page);
  await viewer.evaluate((element: PhongViewer) => element.append(document.createElement('phong-light')));
  expect(await viewer.evaluate((element: PhongViewer) => element.lights.length)).toBe(2);
  expect(pixelAt(await pixels(viewer), 45, 30)[3]).toBe(255);
});

test('the picture has the pixels that it covers under CSS zoom', async ({ mount }) => {
  const viewer = await mount(box, { ...size, css: 'phong-viewer { zoom: 2 }' });
  const { width, height } = await pixels(viewer);
  expect([width, height]).toEqual([2 * size.width, 2 * size.height]);
});
