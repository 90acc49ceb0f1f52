// Nothing in view is cut away by the near plane, and the largest shapes are drawn from close by: pictures against a
// float64 ray caster.
import type { PhongViewer } from '../../src/index.js';
import { expect, type Picture, pixels, test } from '../support/test.js';
import { createGeometry } from '../../src/scene/mesh/shapes/shapes.js';
import { coveredBy, expectNoHoles, markupOf } from './coverage.js';
import { LOW_EYES, randomLowEye } from './low-eyes.js';

const SIZE = { width: 40, height: 30 };
const SEED = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);

test('floors, rooms, walls and boxes up to 1e6 have no holes, seen from just beside them', async ({
  mount,
  page,
}) => {
  await mount('<phong-viewer></phong-viewer>', SIZE);
  const rooms = Array.from({ length: 8 }, (_, i) => randomLowEye(SEED + i));
  await expectNoHoles(page, [...LOW_EYES, ...rooms], SIZE);
});

test('a picture in tiles, a linked viewer and shadeAt see the same floor as the picture', async ({
  mount,
  page,
}) => {
  const [low] = LOW_EYES;
  const markup = markupOf(low!).replace('<phong-viewer', '<phong-viewer camera-group="low"');
  const viewer = await mount(markup + markup.replace(/theta="\d+"/u, 'theta="0"'), SIZE);
  const codes = async (index: number): Promise<Picture> =>
    pixels(page.locator('phong-viewer').nth(index), SIZE);
  expect((await codes(1)).data).toEqual((await codes(0)).data);
  // Larger than the GPU can draw at once: in tiles. Each column of the lowest row shows the floor.
  const long = await pixels(viewer, { width: 9000, height: 4 });
  const missing = Array.from({ length: 9000 }, (_, x) => long.data[4 * (3 * 9000 + x) + 3]).filter(
    (a) => a === 0,
  );
  expect(missing.length).toBe(0);
  const depths = await viewer.evaluate(async (element: PhongViewer, { width, height }) => {
    const { eye } = element.camera;
    const shaded = await element.shadeAt(width / 2, height - 0.5);
    return shaded === null ? null : Math.hypot(...shaded.p.map((x, i) => x - eye[i]!));
  }, SIZE);
  expect(depths).toBeLessThan(0.3);
});

const TEAPOT = { width: 400, height: 300 };

test('nothing of the page shows through the teapot, from all sides', async ({ mount, page }) => {
  const viewer = await mount('<phong-viewer geometry="teapot" segments="64" ka="0"></phong-viewer>', TEAPOT);
  const geometry = await createGeometry('teapot', undefined);
  // The default view, into the spout, and from below.
  for (const [theta, phi] of [
    [null, null],
    [90, 50],
    [100, 140],
  ] as const) {
    // prettier-ignore
    const { fov, ...pose } = await viewer.evaluate((element: PhongViewer, [theta, phi]) => {
      if (theta !== null) Object.assign(element, { theta, phi });
      const { theta: t, phi: p, radius, target } = element.camera;
      return { theta: t, phi: p, radius, target, fov: element.fov };
    }, [theta, phi] as const); // prettier-ignore
    const { data } = await pixels(page.locator('phong-viewer'), TEAPOT);
    const covered = coveredBy(geometry, pose, fov, TEAPOT);
    const inside = [...covered.keys()].filter((at) => isSurrounded(covered, at, TEAPOT.width));
    expect(inside.length).toBeGreaterThan(5000);
    expect(inside.filter((at) => data[4 * at + 3] !== 255).length, JSON.stringify(pose)).toBe(0);
  }
});

/** Whether this pixel and the eight around it are covered. */
function isSurrounded(covered: Uint8Array, at: number, width: number): boolean {
  for (const row of [-width, 0, width])
    for (const column of [-1, 0, 1]) if (covered[at + row + column] !== 1) return false;
  return true;
}
