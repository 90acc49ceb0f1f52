// Are round shapes as near the true ones as the issue of their number of segments asks for? At full size; the short forms are in
// element/children/segments.spec.ts.
import { errorAgainstRound } from '../support/caster/against-round.js';
import { expect, test } from '../support/test.js';
import { assign, settled } from '../element/support/viewer.js';

const SIZE = { width: 400, height: 300 };

test('a default sphere and torus at 400 × 300 are nearer their true shapes than 64 segments @release', async ({
  mount,
}) => {
  test.setTimeout(1_200_000);
  const viewer = await mount('<phong-viewer></phong-viewer>', SIZE);
  const found: Record<string, number> = {};
  for (const [geometry, aim] of [
    ['sphere', 3.8],
    ['torus', 4.4],
  ] as const) {
    for (const segments of ['auto', 64] as const) {
      await assign(viewer, { geometry, segments });
      await settled(viewer);
      found[`${geometry}, ${String(segments)}`] = await errorAgainstRound(viewer, SIZE, 1024);
    }
    expect(found[`${geometry}, auto`], geometry).toBeLessThan(aim);
    expect(found[`${geometry}, auto`]! / found[`${geometry}, 64`]!, geometry).toBeLessThan(0.95);
  }
  console.log('RMSE against the round shape:', JSON.stringify(found));
});
