// The long form of element/frames/programs.spec.ts: longer walks.

import { test } from '../support/test.js';
import { logGl } from '../element/support/gl-log.js';
import { expectFewPrograms } from '../element/frames/program-walk.js';

const FIRST = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);

test(`@release walks of four hundred steps make one general program per feature set, seeds from ${FIRST}`, async ({
  page,
  mount,
}) => {
  test.setTimeout(1_800_000);
  await logGl(page);
  for (let seed = FIRST; seed < FIRST + 5; seed++) {
    const viewer = await mount('<phong-viewer></phong-viewer>', { width: 60, height: 42 });
    await expectFewPrograms(page, viewer, seed, 400);
  }
});
