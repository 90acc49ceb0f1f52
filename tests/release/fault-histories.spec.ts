// The long form of element/faults/fault-histories.spec.ts: more and longer histories, with pictures of 9000 × 9000
// pixels.

import { expectRecovery } from '../element/faults/fault-history.js';
import { seedsFrom } from '../element/histories/history.js';
import { test } from '../support/test.js';

const FIRST = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);
const COUNT = Number(process.env['PHONG_VIEWER_FAULTS'] ?? 120);

test(`@release pages recover from long random faults (seeds from ${FIRST})`, async ({ page, mount, consoleGuard }) => {
  test.setTimeout(1_800_000);
  await expectRecovery({ page, mount, consoleGuard }, seedsFrom(FIRST, COUNT), { tasks: 40, withLargest: true }); // prettier-ignore
});
