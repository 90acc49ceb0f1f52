// Nothing in view is cut away by the near plane, and the largest shapes are drawn from close by:
// pictures against a float64 ray caster.
import { basisOf } from '../../src/phong/camera/orbit.js';
import { createGeometry } from '../../src/phong/model/shapes/shapes.js';
import { Tracer } from '../../src/extras/still/tracer.js';
import { firstOf, fullOr, SEED } from '../support/repeats.js';
import { expect, pixels, test } from '../support/test.js';
import { expectNoHoles, markupOf } from './coverage.js';
import { floorsOfAllSizes, LOW_EYES, randomLowEye } from './low-eyes.js';
import { BLACK, trianglesOf } from './ray-cast.js';

const SIZE = { width: 40, height: 30 };
/** Scenes on one page. */
const AT_ONCE = 50;

test(`floors, rooms and boxes up to 1e6 have no holes from close by (seeds from ${SEED})`, async ({
  mount,
  page,
}) => {
  test.setTimeout(1_800_000);
  const rooms = Array.from({ length: fullOr(100, 8) }, (_, i) => randomLowEye(SEED + i));
  const scenes = [...LOW_EYES, ...firstOf(floorsOfAllSizes(), 0), ...rooms];
  for (const size of firstOf([SIZE, { width: 160, height: 90 }], 1)) {
    for (let first = 0; first < scenes.length; first += AT_ONCE) {
      await mount('<phong-viewer></phong-viewer>', size);
      await expectNoHoles(page, scenes.slice(first, first + AT_ONCE), size);
    }
  }
});

test('a picture in tiles, a linked viewer and shadeAt see the same floor as the picture', async ({
  mount,
  page,
}) => {
  const [low] = LOW_EYES;
  const markup = markupOf(low!).replace('<phong-viewer', '<phong-viewer camera-group="low"');
  const viewer = await mount(markup + markup.replace(/theta="\d+"/u, 'theta="0"'), SIZE);
  const codes = async (index: number) => pixels(page.locator('phong-viewer').nth(index), SIZE);
  expect((await codes(1)).data).toEqual((await codes(0)).data);
  // Larger than the GPU can draw at once: in tiles. Each column of the lowest row shows the floor.
  const { data } = await pixels(viewer, { width: 9000, height: 4 });
  const alphas = data.slice(4 * 3 * 9000).filter((_, i) => i % 4 === 3);
  expect(alphas.includes(0)).toBe(false);
  const depth = await viewer.evaluate(async (element, { width, height }) => {
    const { eye } = element.camera;
    const shaded = await element.shadeAt(width / 2, height - 0.5);
    return shaded === null ? null : Math.hypot(...shaded.p.map((x, i) => x - eye[i]!));
  }, SIZE);
  expect(depth).toBeLessThan(0.3);
});

const TEAPOT = { width: 400, height: 300 };

test('nothing of the page shows through the teapot, from all sides', async ({ mount }) => {
  const viewer = await mount(
    '<phong-viewer geometry="teapot" segments="64" ka="0"></phong-viewer>',
    TEAPOT,
  );
  const shape = trianglesOf(await createGeometry('teapot', undefined));
  const objects = [{ shape, material: BLACK }];
  const { width, height } = TEAPOT;
  // The default view, into the spout, and from below.
  for (const view of [{}, { theta: 90, phi: 50 }, { theta: 100, phi: 140 }]) {
    const { theta, phi, eye, fov } = await viewer.evaluate((element, angles) => {
      Object.assign(element, angles);
      const { theta, phi, eye } = element.camera;
      return { theta, phi, eye, fov: element.fov };
    }, view);
    const { data } = await pixels(viewer, TEAPOT);
    const camera = { eye, ...basisOf({ theta, phi }), fov };
    const tracer = new Tracer({ camera, lights: [], objects }, width, height);
    const covered = Array.from(
      { length: width * height },
      (_, i) => tracer.hitAt((i % width) + 0.5, Math.floor(i / width) + 0.5).t < Infinity,
    );
    // Pixels that are covered, and the eight around them too.
    const inside = [...covered.keys()].filter((at) =>
      [-width, 0, width].every((row) => [-1, 0, 1].every((column) => covered[at + row + column])),
    );
    expect(inside.length).toBeGreaterThan(5000);
    expect(inside.filter((at) => data[4 * at + 3] !== 255).length, JSON.stringify(view)).toBe(0);
  }
});
