// A page that has lived shows what a new one shows: random histories of one to three viewers, held now and then against a page
// that begins with the same scenes. Failures print the seed and the shortest history that still fails.

import { test } from '../support/test.js';
import { expectAsNew, seedsFrom } from './history.js';

test('a page that has lived shows what a new one shows', async ({ page, mount, site, consoleGuard }) => {
  test.slow();
  // Of each mix of steps one, and of those that have programs made two that change what is in them at once.
  await expectAsNew({ page, mount, site, consoleGuard }, [...seedsFrom(1, 4), 6, 23, 41], 3);
});

test('a page of any tree and any values shows what a new one shows', async ({
  page,
  mount,
  site,
  consoleGuard,
}) => {
  test.slow();
  await expectAsNew({ page, mount, site, consoleGuard }, seedsFrom(1, 5), 3, 'trees');
});
