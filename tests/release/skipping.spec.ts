// The long forms of visual/skipping.spec.ts and element/frames/programs.spec.ts: more scenes, longer walks.

import { expect, pixels, test } from '../support/test.js';
import { logGl } from '../element/support/gl-log.js';
import { expectFewPrograms } from '../element/frames/program-walk.js';
import type { PhongViewer } from '../element/support/viewer.js';
import { betweenPrograms, DifferenceSum, picturesBy } from '../visual/between-programs.js';
import { compareRandomScenes, SIZE } from '../visual/program-scenes.js';
import { Dice, randomLight, randomScene, sceneMarkup } from '../visual/random-scene.js';

const FIRST = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);
const SCENES = Number(process.env['PHONG_VIEWER_SCENES'] ?? 300);

test.beforeEach(async ({ page }) => {
  test.setTimeout(1_800_000);
  await logGl(page);
});

test('@release three hundred random scenes differ by a code on few channels between general and specialised programs', async ({
  page,
  mount,
}) => {
  await mount('<phong-viewer></phong-viewer>', SIZE);
  await compareRandomScenes(page, FIRST, SCENES);
});

test('@release walks of four hundred steps make one general program per feature set, for several seeds', async ({
  page,
  mount,
}) => {
  for (let seed = FIRST; seed < FIRST + 5; seed++) {
    const viewer = await mount('<phong-viewer></phong-viewer>', { width: 60, height: 42 });
    await expectFewPrograms(page, viewer, seed, 400);
  }
});

test('@release four thousand moving lights look the same as still ones', async ({ page, mount }) => {
  const dice = new Dice(FIRST);
  const lights = Array.from({ length: 4096 }, () => {
    const light = randomLight(dice);
    const dim = (c: readonly number[]) =>
      c.map((x) => Number((x / 4096).toFixed(5))) as unknown as typeof light.diffuse;
    return {
      ...light,
      active: true,
      ambient: dim(light.ambient),
      diffuse: dim(light.diffuse),
      specular: dim(light.specular),
    };
  });
  const size = { width: 60, height: 42 };
  const viewer = await mount(sceneMarkup({ ...randomScene(4), lights }), size);
  const [general] = await picturesBy(page, [viewer], 'general', size);
  const sum = new DifferenceSum();
  await viewer.evaluate(async (element: PhongViewer) => {
    for (const by of [0.5, -0.25, -0.25]) {
      for (const light of element.lights) {
        const [x, y, z, w] = light.position;
        light.position = [x + by, y, z, w];
      }
      await element.ready;
    }
  });
  const back = await pixels(viewer, size);
  // Three sums of steps that binary numbers hold exactly: places to three decimals come back but for float64's
  // rounding.
  sum.add(betweenPrograms(general!, back));
  console.log(`4,096 lights: ${String(sum)}`);
  sum.expectPromise();
  expect(sum.channels).toBeGreaterThan(1000);
});
