// Does a page show the same after any history of changes as a new page? Random histories of one to three viewers,
// compared now and then with a page that starts with the same scenes. Failures print the seed and the shortest history
// that still fails.

import { test } from '../../support/test.js';
import { expectAsNew, seedsFrom } from './history.js';

test('a page shows the same after random changes as a new page', async ({
  page,
  mount,
  site,
  consoleGuard,
}) => {
  test.slow();
  // One history of each mix.
  await expectAsNew({ page, mount, site, consoleGuard }, [...seedsFrom(1, 4), 6, 23], 3);
});

test('a page shows the same after changes with unusual trees and values as a new page', async ({
  page,
  mount,
  site,
  consoleGuard,
}) => {
  test.slow();
  await expectAsNew({ page, mount, site, consoleGuard }, seedsFrom(1, 2), 3, 'trees');
});

test('a picture shows the same after changes in the middle of its samples as a new one', async ({
  page,
  mount,
  site,
  consoleGuard,
}) => {
  test.slow();
  await expectAsNew({ page, mount, site, consoleGuard }, seedsFrom(1, 2), 2, 'still');
});
