// Does everything work again after an interruption: viewers that return, loads that were aborted, failures that were
// fixed?
import { compare, expect, pixelAt, pixels, test } from '../../support/test.js';
import { cameraOf, nextFrame, record, type PhongMesh, type PhongViewer } from '../support/viewer.js';

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

test('a viewer knows its size right after it was appended', async ({ mount, page }) => {
  await mount('<phong-viewer></phong-viewer>', {
    ...SMALL,
    css: '.tall { width: 60px !important; height: 120px !important }',
  });
  const { width, height, first, then } = await page.evaluate(async () => {
    const viewer = document.createElement('phong-viewer');
    viewer.className = 'tall';
    viewer.geometry = 'box';
    document.body.prepend(viewer);
    const first = viewer.camera.radius;
    const bitmap = await createImageBitmap(await viewer.toBlob());
    await viewer.ready;
    return { width: bitmap.width, height: bitmap.height, first, then: viewer.camera.radius };
  });
  expect({ width, height }).toEqual({ width: 60, height: 120 });
  expect(first).toBe(then);
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

test('the same address is fetched again after a failure, and every failure is reported', async ({
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/404/);
  const viewer = await mount('<phong-viewer></phong-viewer>');
  const events = await record(viewer, 'error');
  for (let time = 1; time <= 2; time++) {
    await viewer.evaluate((element: PhongViewer) => {
      element.src = '/nowhere.glb';
      return element.ready;
    });
    await expect.poll(() => events.take()).toHaveLength(1);
  }
  expect(await viewer.evaluate((element: PhongViewer) => element.loaded)).toBe(false);
});

test('a drag uses the width on screen, also on a scaled page', async ({ mount, page }) => {
  const viewer = await mount('<phong-viewer geometry="box" theta="0"></phong-viewer>', {
    width: 300,
    height: 200,
    css: 'phong-viewer { transform: scale(2); transform-origin: 0 0 }',
  });
  await page.mouse.move(300, 200);
  await page.mouse.down();
  await page.mouse.move(360, 200);
  await page.mouse.up();
  expect((await cameraOf(viewer)).theta).toBeCloseTo(-36, 9);
});

test('changes and removals of several lights in one task make one event, which lists each light once', async ({
  mount,
  page,
}) => {
  const viewer = await mount(
    '<phong-viewer><phong-light name="a"></phong-light><phong-light name="b"></phong-light><phong-light name="c"></phong-light></phong-viewer>',
  );
  const changes = await viewer.evaluate(async (element: PhongViewer) => {
    const events: string[][] = [];
    element.addEventListener('light-change', ({ detail }) => {
      events.push([String(Object.isFrozen(detail.lights)), ...detail.lights.map(({ name }) => name)]);
    });
    const [a, b, c] = element.lights;
    if (a === undefined || b === undefined || c === undefined) return [];
    b.cutoff = 1;
    a.cutoff = 2;
    b.cutoff = 3;
    await new Promise((resolve) => setTimeout(resolve));
    a.cutoff = 4;
    c.cutoff = 5;
    c.remove();
    await new Promise((resolve) => setTimeout(resolve));
    return events;
  });
  expect(changes).toEqual([
    ['true', 'b', 'a'],
    ['true', 'a', 'c'],
  ]);
  await nextFrame(page);
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
