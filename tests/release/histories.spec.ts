// The long form of histories: more of them, and longer ones.

import { expectAsNew, seedsFrom } from '../element/history.js';
import { test } from '../support/test.js';

const FIRST = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);
const WALKS = Number(process.env['PHONG_VIEWER_WALKS'] ?? 36);

test('@release pages that have lived long show what new ones show', async ({
  page,
  mount,
  site,
  consoleGuard,
}) => {
  test.setTimeout(1_800_000);
  await expectAsNew({ page, mount, site, consoleGuard }, seedsFrom(FIRST, WALKS), 6);
});

test('@release pages of any trees and any values show what new ones show', async ({
  page,
  mount,
  site,
  consoleGuard,
}) => {
  test.setTimeout(1_800_000);
  await expectAsNew({ page, mount, site, consoleGuard }, seedsFrom(FIRST, WALKS), 6, 'trees');
});
