// The long form of element/histories/histories.spec.ts: more and longer histories.

import { expectAsNew, seedsFrom } from '../element/histories/history.js';
import { test } from '../support/test.js';

const FIRST = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);
const WALKS = Number(process.env['PHONG_VIEWER_WALKS'] ?? 36);

for (const [what, kind] of [
  ['pages show the same after many random changes as new pages', undefined],
  ['pages show the same after changes with unusual trees and values as new pages', 'trees'],
  ['pictures show the same after many changes in the middle of their samples as new ones', 'still'],
] as const) {
  test(`@release ${what}`, async ({ page, mount, site, consoleGuard }) => {
    test.setTimeout(1_800_000);
    await expectAsNew({ page, mount, site, consoleGuard }, seedsFrom(FIRST, WALKS), 6, kind);
  });
}
