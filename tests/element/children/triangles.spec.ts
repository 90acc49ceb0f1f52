// Does a viewer keep to its limit of triangles, show what fits in, and show the rest on request once there is room?

import type { Locator } from '@playwright/test';
import { expect, test } from '../../support/test.js';
import { assign, type PhongViewer, record, settled } from '../support/viewer.js';

const SIZE = { width: 120, height: 90 };

/** Names of the meshes that are in the scene. */
const shown = (viewer: Locator): Promise<string[]> =>
  viewer.evaluate((element: PhongViewer) => element.scene.children.map(({ name }) => name));

test('shows the meshes that fit in, says of each other one that it is too large, and shows it on request once there is room', async ({
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/Use fewer segments, fewer different shapes/, 1);
  const viewer = await mount('<phong-viewer radius="5" target="0 0 0" theta="10"></phong-viewer>', SIZE);
  const heard = await record(viewer, 'error');
  // 64 segments have 3,968 triangles, and 13,605 more as a flat copy.
  await viewer.evaluate(async (element: PhongViewer) => {
    element.maxTriangles = 40_000;
    for (const [name, segments] of Object.entries({ a: 64, b: 66, c: 62, d: 12 })) {
      const mesh = document.createElement('phong-mesh');
      Object.assign(mesh, { name, geometry: 'sphere', segments, shading: 'flat' });
      element.append(mesh);
    }
    await element.ready;
  });
  expect(await shown(viewer)).toEqual(['a', 'b', 'd']);
  const message: unknown = expect.stringContaining('at most 40,000 can be shown');
  expect(await heard.take()).toMatchObject([{ detail: { code: 'too-large', message } }]);
  expect(await viewer.evaluate((element: PhongViewer) => element.camera.theta)).toBe(10);
  await expect(viewer.locator('[part=notice]')).toBeVisible();
  await viewer.evaluate((element: PhongViewer) => element.meshes[0]!.remove());
  await viewer.locator('[part=retry]').dispatchEvent('click');
  await expect(viewer.locator('[part=notice]')).toBeHidden();
  await expect.poll(() => shown(viewer), 'a frame sorts them').toEqual(['b', 'c', 'd']);
  // As flat copies they leave no room for a fourth one, which keeps its shading.
  await viewer.evaluate((element: PhongViewer) => {
    const mesh = document.createElement('phong-mesh');
    element.append(Object.assign(mesh, { name: 'e', geometry: 'sphere', segments: 40 }));
    return element.ready;
  });
  expect(await heard.take()).toEqual([]);
  await assign(viewer.locator('phong-mesh').last(), { shading: 'flat' });
  await settled(viewer);
  expect(await heard.take()).toHaveLength(1);
  expect(await shown(viewer)).toEqual(['b', 'c', 'd', 'e']);
  await expect(viewer.locator('[part=notice]')).toBeVisible();
  await viewer.evaluate((element: PhongViewer) => {
    for (const mesh of element.meshes.slice(0, 3)) mesh.shading = 'phong';
  });
  await viewer.locator('[part=retry]').dispatchEvent('click');
  await expect(viewer.locator('[part=notice]')).toBeHidden();
  expect(await heard.take()).toEqual([]);
});

test('2,000 equal boxes and spheres count as two', async ({ mount }) => {
  const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
  const heard = await record(viewer, 'error');
  await viewer.evaluate((element: PhongViewer) => {
    element.maxTriangles = 5000;
    for (let i = 0; i < 2000; i += 1) {
      const mesh = document.createElement('phong-mesh');
      element.append(
        Object.assign(mesh, { geometry: i % 2 ? 'box' : 'sphere', position: [i % 50, i / 50, 0] }),
      );
    }
  });
  await expect.poll(async () => (await shown(viewer)).length).toBe(2000);
  expect(await heard.take()).toEqual([]);
});

test('a limit that is none throws and changes nothing, and a model beyond it is not shown', async ({
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/Use fewer segments/, 1);
  const viewer = await mount('<phong-viewer geometry="box"></phong-viewer>', SIZE);
  const heard = await record(viewer, 'error');
  const thrown = await viewer.evaluate((element: PhongViewer) =>
    [-1, 2.5, NaN, 2 ** 24 + 1, '7'].map((value) => {
      try {
        Reflect.set(element, 'maxTriangles', value);
        return 'none';
      } catch (error) {
        return (error as Error).name;
      }
    }),
  );
  expect(thrown).toEqual(['RangeError', 'RangeError', 'RangeError', 'RangeError', 'TypeError']);
  expect(await viewer.evaluate((element: PhongViewer) => element.maxTriangles)).toBe(2 ** 24);
  const obj = `data:text/plain,${encodeURIComponent('v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\n')}`;
  await assign(viewer, { maxTriangles: 5, type: 'obj', src: obj });
  await settled(viewer);
  expect(await heard.take()).toMatchObject([{ detail: { code: 'too-large' } }]);
  expect(await shown(viewer)).toHaveLength(1);
  await assign(viewer, { maxTriangles: null });
  await expect.poll(() => viewer.evaluate((element: PhongViewer) => element.loaded)).toBe(true);
});
