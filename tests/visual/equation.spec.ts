// Do whole pictures follow the equation? Random scenes on a plane, pixel by pixel against float64, by markup alone.
import { expect, pixels, test } from '../support/test.js';
import { compareWithReference } from './against-reference.js';
import { randomScene, sceneMarkup } from './random-scene.js';

const release = process.env['PHONG_VIEWER_RELEASE'] !== undefined;
/** Small pictures of many scenes: time grows with the pixels, and mistakes are found by the scenes. */
const SIZE = release ? { width: 200, height: 140 } : { width: 84, height: 60 };
/** For more or other scenes: PHONG_VIEWER_SCENES=500 PHONG_VIEWER_SEED=1000. */
const SCENES = Number(process.env['PHONG_VIEWER_SCENES'] ?? (release ? 300 : 12));
const FIRST = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);

for (const [what, geometry, scenes, shading] of [
  ['shades random scenes on a plane within one code of the equation in float64', 'plane', SCENES],
  ['shades random boxes, turned and mirrored, within one code', 'box', Math.ceil(SCENES / 3)],
  ['shades flat faces with the triangles’ own normals within one code', 'box', Math.ceil(SCENES / 6), 'flat'],
] as const) {
  test(what, async ({ mount }) => {
    test.setTimeout(1_800_000);
    // One page for all scenes: a page each takes longer than the pictures.
    const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
    let compared = 0;
    let exact = 0;
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
  });
}
