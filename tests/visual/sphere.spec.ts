// How exact is a sphere's picture, against the element's own triangles in float64? Random scenes; their seeds are
// printed.
import { fullOr } from '../support/repeats.js';
import { expect, pixels, test } from '../support/test.js';
import { compareWithTriangles } from './against-triangles.js';
import { subpixelBitsOf } from './program-scenes.js';
import { Dice, randomScene, sceneMarkup } from './random-scene.js';
import type { DeclaredScene } from './ray-cast.js';

const SIZE = { width: fullOr(120, 90), height: fullOr(84, 63) };
/** For more or other scenes: PHONG_VIEWER_SCENES=500 PHONG_VIEWER_SEED=1000. */
const SCENES = Number(process.env['PHONG_VIEWER_SCENES'] ?? fullOr(300, 12));
const FIRST = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);

const SHADINGS = ['phong', 'flat', 'gouraud'] as const;

/** The shape's own number among them, and as few as there can be: triangles as large as the picture. */
const FINENESS = [64, 3, 8, 16, 32, 128] as const;

/** Scenes of each shading. */
const EACH = Math.ceil(SCENES / SHADINGS.length);

test('shades a sphere within one code of its own triangles in float64', async ({ mount, page }) => {
  test.setTimeout(1_800_000);
  const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
  const subpixelBits = await subpixelBitsOf(page);
  expect(subpixelBits).toBeGreaterThanOrEqual(4); // what OpenGL ES promises
  for (const shading of SHADINGS) {
    const sum = { compared: 0, exact: 0, snapped: 0 };
    for (let seed = FIRST; seed < FIRST + EACH; seed++) {
      const base = randomScene(seed, 'sphere');
      const segments = new Dice(seed).pick(FINENESS);
      const mesh = { ...base.meshes[0]!, segments };
      const scene: DeclaredScene = { ...base, meshes: [mesh] };
      const markup = sceneMarkup(scene, shading);
      await viewer.evaluate((element, text) => (element.outerHTML = text), markup);
      const errors = compareWithTriangles(await pixels(viewer, SIZE), scene, shading, subpixelBits);
      expect.soft(errors.max, `seed ${seed}, ${errors.at}\n${markup}`).toBeLessThanOrEqual(1);
      sum.compared += errors.compared;
      sum.exact += errors.exact;
      sum.snapped += errors.snapped;
    }
    console.log(`${shading}, seeds ${FIRST} to ${FIRST + EACH - 1}: ${JSON.stringify(sum)}`);
    expect(sum.compared).toBeGreaterThan(1e4);
    expect(sum.exact / sum.compared).toBeGreaterThan(0.98);
    // Measured: 1.2e-4, where vertices lie on sixteenths of a pixel.
    expect(sum.snapped / sum.compared).toBeLessThan(3e-4);
  }
});
