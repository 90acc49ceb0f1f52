// Does a page show the same after any history of changes as a new page? Random histories of one to
// three viewers, compared now and then with a page that starts with the same scenes. Failures print
// the seed and the shortest history that still fails.

import { test } from '../../support/test.js';
import { expectAsNew, seedsFrom } from './history.js';

for (const [what, seeds, looks, mix] of [
  ['random changes', seedsFrom(1, 6), 1, undefined], // one history of each mix
  ['changes with unusual trees and values', seedsFrom(2, 1), 2, 'trees'],
  ['changes in the middle of its samples', seedsFrom(1, 1), 1, 'still'],
] as const) {
  test(`a page shows the same after ${what} as a new page`, async ({
    page,
    mount,
    site,
    consoleGuard,
  }) => {
    test.slow();
    await expectAsNew({ page, mount, site, consoleGuard }, seeds, looks, mix);
  });
}
