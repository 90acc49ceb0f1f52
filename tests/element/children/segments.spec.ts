// Are round shapes as round as the screen shows, by default, in pictures, files and comparisons?
// Also: a viewer keeps to its limit of triangles. The long form is release/long-forms.spec.ts.

import { expect, pixels, test } from '../../support/test.js';
import {
  assign,
  cameraOf,
  type PhongViewer,
  record,
  set,
  settled,
  trianglesOf,
} from '../support/viewer.js';
import { expectSmooth, filmZoom } from './round-levels.js';

const SIZE = { width: 120, height: 120 };

/** Of a sphere. */
const sphereOf = (segments: number) => 2 * segments * (segments / 2 - 1);

test('a sphere has the segments that its size and the camera need, and the camera stays', async ({
  mount,
}) => {
  const viewer = await mount('<phong-viewer geometry="sphere"></phong-viewer>', SIZE);
  expect(await trianglesOf(viewer)).toBe(sphereOf(64));
  const { radius } = await cameraOf(viewer);
  const counts: number[] = [];
  const views = [{ radius: 100 }, { radius: 0.501 }, { target: [0.5, 0, 0], radius: 0.2 }];
  for (const view of views) {
    await assign(viewer, view);
    await settled(viewer);
    counts.push(await trianglesOf(viewer));
  }
  // At 0.501 no outline is in view.
  expect(counts.slice(0, 2)).toEqual([sphereOf(16), sphereOf(64)]);
  expect(counts[2]).toBeGreaterThan(sphereOf(64));
  // Framing is that of the round shape.
  for (const segments of [3, 24, 'auto'] as const) {
    await set(viewer, { segments, target: 'auto', radius: 'auto' });
    expect((await cameraOf(viewer)).radius).toBe(radius);
  }
  expect(await trianglesOf(viewer)).toBe(sphereOf(64));
});

test('a file has the segments of its own size, and the picture keeps its own', async ({
  mount,
}) => {
  const viewer = await mount('<phong-viewer geometry="sphere"></phong-viewer>', SIZE);
  const covered = async (side: number) => {
    const { data } = await pixels(viewer, { width: side, height: side });
    return data.reduce((sum, code, i) => (i % 4 === 3 ? sum + code : sum), 0) / (255 * side ** 2);
  };
  // The share of a disc: the sphere's outline in the default view, sin of whose angle is sin(22.5°)
  // / 1.05.
  const sine = Math.sin(Math.PI / 8) / 1.05;
  const share = (Math.PI / 4) * (sine ** 2 / (1 - sine ** 2) / Math.tan(Math.PI / 8) ** 2);
  expect(Math.abs((await covered(1200)) / share - 1)).toBeLessThan(0.0005);
  expect(Math.abs((await covered(120)) / share - 1)).toBeLessThan(0.004);
  await viewer.evaluate((element) => element.requestRender());
  await settled(viewer);
  expect(await trianglesOf(viewer)).toBe(sphereOf(64));
});

test('Gouraud and flat pictures keep the fixed number; so does a Phong one beside them', async ({
  mount,
  page,
}) => {
  await mount(
    `<phong-compare layout="side" labels=""><phong-viewer geometry="sphere" radius="12" target="0 0 0"></phong-viewer><phong-viewer
      geometry="sphere" radius="12" target="0 0 0"></phong-viewer></phong-compare>`,
    { width: 240, height: 120 },
  );
  const [left, right] = [page.locator('phong-viewer').first(), page.locator('phong-viewer').last()];
  await expect.poll(() => trianglesOf(left)).toBe(await trianglesOf(right));
  const auto = await trianglesOf(left);
  expect(auto).toBeLessThan(sphereOf(64));
  await set(right, { shading: 'gouraud' });
  await settled(left);
  expect([await trianglesOf(left), await trianglesOf(right)]).toEqual([sphereOf(64), sphereOf(64)]);
  await set(right, { shading: 'phong' });
  await settled(left);
  expect([await trianglesOf(left), await trianglesOf(right)]).toEqual([auto, auto]);
});

test('a zoom from a dot to the inside of a shape shows no jump and no blank frame', async ({
  page,
  mount,
}) => {
  for (const geometry of ['sphere', 'cone']) {
    expectSmooth(await filmZoom(page, mount, geometry, 24, { width: 60, height: 60 }), geometry);
  }
});

test('a mesh beyond the limit of triangles is reported, and shown on request', async ({
  mount,
  consoleGuard,
}) => {
  consoleGuard.allow(/Use fewer segments or shapes/, 1);
  const viewer = await mount(
    '<phong-viewer radius="5" target="0 0 0" theta="10"></phong-viewer>',
    SIZE,
  );
  const shown = () => viewer.evaluate((element) => element.scene.children.map(({ name }) => name));
  const heard = await record(viewer, 'error');
  // 64 segments have 3,968 triangles, and 13,605 more as a flat copy.
  await viewer.evaluate(async (element) => {
    element.maxTriangles = 40_000;
    for (const [name, segments] of Object.entries({ a: 64, b: 66, c: 62, d: 12 })) {
      const mesh = document.createElement('phong-mesh');
      Object.assign(mesh, { name, geometry: 'sphere', segments, shading: 'flat' });
      element.append(mesh);
    }
    await element.ready;
  });
  expect(await shown()).toEqual(['a', 'b', 'd']);
  const message: unknown = expect.stringContaining('at most 40,000 can be shown');
  expect(await heard.take()).toMatchObject([{ detail: { code: 'too-large', message } }]);
  expect((await cameraOf(viewer)).theta).toBe(10);
  await expect(viewer.locator('[part=notice]')).toBeVisible();
  // A shape of the viewer's own, while `ready` is pending.
  const own = (element: PhongViewer) => {
    Object.assign(element, { segments: 70, shading: 'flat', background: 'red' });
    void element.ready;
    element.geometry = 'torus';
    return element.ready;
  };
  await viewer.evaluate(own);
  expect(await heard.take()).toHaveLength(1);
  await assign(viewer, { geometry: null });
  await viewer.evaluate((element) => element.meshes[0]!.remove());
  await viewer.locator('[part=retry]').dispatchEvent('click');
  await expect(viewer.locator('[part=notice]')).toBeHidden();
  await expect.poll(shown, 'a frame sorts them').toEqual(['b', 'c', 'd']);
  expect(await heard.take()).toEqual([]);
});
