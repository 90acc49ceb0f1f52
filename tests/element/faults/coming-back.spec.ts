// Does everything work again after an interruption: viewers that return, loads that were aborted, failures that were
// fixed?
import { compare, expect, pixelAt, pixels, test } from '../../support/test.js';
import { nextFrame, type PhongMesh, type PhongViewer } from '../support/viewer.js';

const SMALL = { width: 120, height: 90 };

test('a viewer returns complete while another one is on the page', async ({ mount, page }) => {
  const viewer = await mount(
    '<phong-viewer geometry="sphere"></phong-viewer><phong-viewer geometry="box"></phong-viewer>',
    SMALL,
  );
  const before = await pixels(viewer);
  const away = await viewer.evaluateHandle((element) => {
    element.remove();
    return element;
  });
  await nextFrame(page);
  await away.evaluate((element) => {
    document.body.prepend(element);
    return (element as PhongViewer).ready;
  });
  expect(compare(await pixels(page.locator('phong-viewer').first()), before).max).toBe(0);
});

test('nothing waits for an aborted load in a viewer out of view', async ({ mount, page }) => {
  await page.route('**/never.glb', () => undefined); // no answer, ever
  const viewer = await mount('<phong-viewer hidden src="/never.glb"></phong-viewer>', {
    waitForReady: false,
  });
  const outcome = await viewer.evaluate(async (element: PhongViewer) => {
    const late = new Promise<string>((resolve) => setTimeout(() => resolve('late'), 5000));
    const asked = element.ready.then(() => 'ready');
    element.removeAttribute('src');
    const first = await Promise.race([asked, late]);
    const mesh = document.createElement('phong-mesh');
    mesh.src = '/never.glb';
    element.append(mesh);
    await new Promise((resolve) => setTimeout(resolve));
    const again = element.ready.then(() => 'ready');
    mesh.remove();
    return [
      first,
      await Promise.race([again, late]),
      await Promise.race([element.ready.then(() => 'ready'), late]),
    ];
  });
  expect(outcome).toEqual(['ready', 'ready', 'ready']);
});

test('a mesh that moved to another viewer reports to that one, in view or not', async ({ mount, page }) => {
  const viewer = await mount(
    '<phong-viewer><phong-mesh geometry="box" ks="0"></phong-mesh></phong-viewer><phong-viewer></phong-viewer>',
    SMALL,
  );
  await viewer.evaluate((element) => {
    const mesh = element.firstElementChild as PhongMesh;
    const other = element.nextElementSibling as PhongViewer;
    other.append(mesh);
    return other.meshes.length;
  });
  await nextFrame(page);
  await page.locator('phong-mesh').evaluate((mesh: PhongMesh) => {
    mesh.kd = [255, 0, 0];
    mesh.ka = [0, 0, 0];
  });
  const [, g, b] = pixelAt(await pixels(page.locator('phong-viewer').nth(1)), 60, 45);
  expect([g, b]).toEqual([0, 0]);
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

test('the picture has the pixels that it covers under CSS zoom', async ({ mount }) => {
  const viewer = await mount('<phong-viewer geometry="box"></phong-viewer>', {
    ...SMALL,
    css: 'phong-viewer { zoom: 2 }',
  });
  const size = await viewer.evaluate((element) => {
    const canvas = element.shadowRoot?.querySelector('canvas');
    return [canvas?.width, canvas?.height];
  });
  expect(size).toEqual([2 * SMALL.width, 2 * SMALL.height]);
});
