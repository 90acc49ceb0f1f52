// The long form of visual/near-plane.spec.ts: more random rooms, and floors and boxes of all sizes in both windings,
// from both sides.

import { expect, test } from '../support/test.js';
import { type CoverageScene, expectNoHoles } from '../visual/coverage.js';
import { floorsOfAllSizes, randomLowEye } from '../visual/low-eyes.js';

const FIRST = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);
const COUNT = Number(process.env['PHONG_VIEWER_ROOMS'] ?? 100);
/** Scenes on one page. */
const AT_ONCE = 50;

test(`@release nothing in view is cut in random rooms (seeds from ${FIRST}) and over floors of all sizes`, async ({
  mount,
  page,
}) => {
  test.setTimeout(1_800_000);
  const rooms = Array.from({ length: COUNT }, (_, i) => randomLowEye(FIRST + i));
  const scenes: readonly CoverageScene[] = [...floorsOfAllSizes(), ...rooms];
  expect(scenes.length).toBeGreaterThan(COUNT);
  for (const size of [
    { width: 40, height: 30 },
    { width: 160, height: 90 },
  ]) {
    for (let first = 0; first < scenes.length; first += AT_ONCE) {
      await mount('<phong-viewer></phong-viewer>', size);
      await expectNoHoles(page, scenes.slice(first, first + AT_ONCE), size);
    }
  }
});
