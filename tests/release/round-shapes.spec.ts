// Are round shapes nearer the true ones than with 64 segments, in plain pictures at full size? RMSE in codes on a white
// page, 400 × 300, headlight, by 1,024 float64 samples a pixel: sphere 2.10 (64 segments: 2.95), torus 2.27 (3.15). With
// dark outlines on black: 0.80 (1.68) and 0.78 (1.90). The short forms are in element/children/segments.spec.ts.
import { errorAgainstRound } from '../support/caster/against-round.js';
import { expect, test } from '../support/test.js';
import { assign, settled } from '../element/support/viewer.js';

const SIZE = { width: 400, height: 300 };

test('@release a default sphere and torus are nearer their true shapes than 64 segments', async ({
  mount,
}) => {
  test.setTimeout(1_200_000);
  const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
  const found: Record<string, number> = {};
  // The aims as shares of the error with 64 segments: 3.8 of 4.9 and 4.4 of 5.3, in a picture with brighter outlines.
  for (const [geometry, most, share] of [
    ['sphere', 2.2, 3.8 / 4.9],
    ['torus', 2.4, 4.4 / 5.3],
  ] as const) {
    for (const segments of ['auto', 64] as const) {
      await assign(viewer, { geometry, segments });
      await settled(viewer);
      found[`${geometry}, ${String(segments)}`] = await errorAgainstRound(viewer, SIZE, 1024);
    }
    expect(found[`${geometry}, auto`], geometry).toBeLessThan(most);
    expect(found[`${geometry}, auto`]! / found[`${geometry}, 64`]!, geometry).toBeLessThan(share);
  }
  console.log('RMSE against the round shape:', JSON.stringify(found));
});
