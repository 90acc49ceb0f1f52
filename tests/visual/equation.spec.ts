// Do whole pictures follow the equation? Random scenes on a plane, pixel by pixel against float64, by markup alone.
import { expect, type Mount, pixels, test } from '../support/test.js';
import { compareWithReference } from './against-reference.js';
import type { Vec3 } from '../../src/math/vector.js';
import { Dice, randomLight, randomScene, sceneMarkup } from './random-scene.js';
import type { DeclaredScene } from './ray-cast.js';

const release = process.env['PHONG_VIEWER_RELEASE'] !== undefined;
/** Small pictures of many scenes: time grows with the pixels, and mistakes are found by the scenes. */
const SIZE = release ? { width: 200, height: 140 } : { width: 84, height: 60 };
/** For more or other scenes: PHONG_VIEWER_SCENES=500 PHONG_VIEWER_SEED=1000. */
const SCENES = Number(process.env['PHONG_VIEWER_SCENES'] ?? (release ? 300 : 18));
const FIRST = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);

async function holds(
  mount: Mount,
  geometry: 'plane' | 'box',
  scenes: number,
  shading = 'phong',
): Promise<void> {
  let compared = 0;
  let exact = 0;
  // One page for all scenes: a page each takes longer than the pictures.
  const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
  for (let seed = FIRST; seed < FIRST + scenes; seed++) {
    const scene = randomScene(seed, geometry);
    const markup = sceneMarkup(scene, shading);
    await viewer.evaluate((element, text) => (element.outerHTML = text), markup);
    const errors = compareWithReference(await pixels(viewer, SIZE), scene);
    compared += errors.compared;
    exact += errors.exact;
    expect.soft(errors.max, `seed ${seed}, ${errors.at}\n${markup}`).toBeLessThanOrEqual(1);
  }
  expect(compared).toBeGreaterThan(1e4);
  expect(exact / compared).toBeGreaterThan(0.98);
}

test('shades random scenes on a plane within one code of the equation in float64', async ({ mount }) => {
  test.setTimeout(1_800_000);
  await holds(mount, 'plane', SCENES);
});

test('shades random boxes, turned and mirrored, within one code', async ({ mount }) => {
  test.setTimeout(1_800_000);
  await holds(mount, 'box', Math.ceil(SCENES / 3));
});

test('shades flat faces with the triangles’ own normals within one code', async ({ mount }) => {
  test.setTimeout(1_800_000);
  await holds(mount, 'box', Math.ceil(SCENES / 6), 'flat');
});

test('sums more lights than uniforms can hold', async ({ mount }) => {
  test.setTimeout(120_000);
  const small = { width: 44, height: 30 };
  const scene = randomScene(4);
  const dice = new Dice(7);
  const lights = Array.from({ length: 400 }, () => {
    const light = randomLight(dice);
    // Dim, so that the sum stays in range; rounded, as an author would write it.
    const dim = (c: Vec3): Vec3 => [Math.round(c[0]) / 100, Math.round(c[1]) / 100, Math.round(c[2]) / 100];
    return {
      ...light,
      // No cones: so many would leave no pixel away from every edge.
      aperture: 180,
      ambient: dim(light.ambient),
      diffuse: dim(light.diffuse),
      specular: dim(light.specular),
    };
  });
  for (const count of [200, 400]) {
    const crowd: DeclaredScene = { ...scene, lights: lights.slice(0, count) };
    const viewer = await mount(sceneMarkup(crowd), small);
    const errors = compareWithReference(await pixels(viewer, small), crowd);
    expect.soft(errors.max, `${count} lights, ${errors.at}`).toBeLessThanOrEqual(1);
    expect(errors.compared).toBeGreaterThan(500);
  }
});
