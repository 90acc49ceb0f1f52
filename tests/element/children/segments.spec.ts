// Are round shapes as round as the screen shows, by default, in pictures, files and comparisons? The long forms are in
// release/round-films.spec.ts and round-shapes.spec.ts.

import { expect, test } from '../../support/test.js';
import { countEverything } from '../support/counting.js';
import { assign, type PhongViewer, settled } from '../support/viewer.js';
import { expectSmooth, filmZoom, showThumbnails, triangles } from './round-levels.js';

const SIZE = { width: 120, height: 120 };

/** Of a sphere. */
const sphereOf = (segments: number): number => 2 * segments * (segments / 2 - 1);

test('a sphere has the segments that its size and the camera need, and the camera stays', async ({
  mount,
}) => {
  const viewer = await mount('<phong-viewer geometry="sphere"></phong-viewer>', SIZE);
  const first = await triangles(viewer);
  expect(first).toBe(sphereOf(64));
  const { radius } = await viewer.evaluate((element: PhongViewer) => element.camera);
  await assign(viewer, { radius: 100 });
  await settled(viewer);
  expect(await triangles(viewer)).toBe(sphereOf(16));
  await assign(viewer, { radius: 0.501 });
  await settled(viewer);
  expect(await triangles(viewer), 'no outline is in view').toBe(sphereOf(64));
  await assign(viewer, { target: [0.5, 0, 0], radius: 0.2 });
  await settled(viewer);
  expect(await triangles(viewer)).toBeGreaterThan(sphereOf(64));
  await assign(viewer, { target: 'auto', radius: 'auto' });
  await settled(viewer);
  expect(await triangles(viewer)).toBe(first);
  expect(await viewer.evaluate((element: PhongViewer) => element.camera.radius)).toBe(radius);
  // Framing is that of the round shape.
  for (const segments of [3, 24, 'auto'] as const) {
    await assign(viewer, { segments });
    await settled(viewer);
    expect(await viewer.evaluate((element: PhongViewer) => element.camera.radius)).toBe(radius);
  }
  expect(await viewer.evaluate((element: PhongViewer) => element.segments)).toBe('auto');
});

test('a file has the segments of its own size, and the picture keeps its own', async ({ mount }) => {
  const viewer = await mount('<phong-viewer geometry="sphere"></phong-viewer>', SIZE);
  const corners = await viewer.evaluate(async (element: PhongViewer) => {
    const read = async (blob: Blob, size: number): Promise<number> => {
      const canvas = new OffscreenCanvas(size, size);
      const context = canvas.getContext('2d')!;
      context.drawImage(await createImageBitmap(blob), 0, 0);
      const { data } = context.getImageData(0, 0, size, size);
      let covered = 0;
      for (let i = 3; i < data.length; i += 4) covered += data[i]! / 255;
      return covered / size ** 2;
    };
    const small = await read(await element.toBlob(), 120);
    const large = await read(await element.toBlob({ width: 1200, height: 1200 }), 1200);
    return { small, large };
  });
  // The share of a disc: the sphere's outline in the default view, sin of whose angle is sin(22.5°) / 1.05.
  const sine = Math.sin(Math.PI / 8) / 1.05;
  const share = (Math.PI / 4) * (sine ** 2 / (1 - sine ** 2) / Math.tan(Math.PI / 8) ** 2);
  expect(Math.abs(corners.large / share - 1)).toBeLessThan(0.0005);
  expect(Math.abs(corners.small / share - 1)).toBeLessThan(0.004);
  await viewer.evaluate((element: PhongViewer) => element.requestRender());
  await settled(viewer);
  expect(await triangles(viewer)).toBe(sphereOf(64));
});

test('Gouraud and flat pictures keep the fixed number, and so does a Phong one beside them', async ({
  mount,
  page,
}) => {
  await mount(
    `<phong-compare layout="side" labels=""><phong-viewer geometry="sphere" radius="12" target="0 0 0"></phong-viewer><phong-viewer
      geometry="sphere" radius="12" target="0 0 0"></phong-viewer></phong-compare>`,
    { width: 240, height: 120 },
  );
  const [left, right] = [page.locator('phong-viewer').first(), page.locator('phong-viewer').last()];
  await expect.poll(() => triangles(left)).toBe(await triangles(right));
  const auto = await triangles(left);
  expect(auto).toBeLessThan(sphereOf(64));
  await assign(right, { shading: 'gouraud' });
  await settled(right);
  await settled(left);
  expect([await triangles(left), await triangles(right)]).toEqual([sphereOf(64), sphereOf(64)]);
  await assign(right, { shading: 'phong' });
  await settled(right);
  await settled(left);
  expect([await triangles(left), await triangles(right)]).toEqual([auto, auto]);
});

test('fifty thumbnails have the levels of their sizes, share them, and rest', async ({ page, mount }) => {
  await countEverything(page);
  await showThumbnails(page, mount, 50);
});

test('a zoom from a dot to the inside of a shape shows no jump and no blank frame', async ({
  page,
  mount,
}) => {
  for (const geometry of ['sphere', 'cone'])
    expectSmooth(await filmZoom(page, mount, geometry, 24, { width: 60, height: 60 }), geometry);
});
