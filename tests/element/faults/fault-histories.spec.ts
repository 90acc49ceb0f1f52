// Does a page recover from every fault? Random histories of lost and refused contexts, failed
// requests, viewers that come and go, sizes, hidden documents and printing. Failures print the seed
// and the shortest history that still fails.

import { test } from '../../support/test.js';
import { expectRecovery } from './fault-history.js';
import { seedsFrom } from '../histories/history.js';

test('a page shows what a new one does after its faults (seeds 1 and 2)', async ({
  page,
  mount,
  consoleGuard,
}) => {
  test.slow();
  await expectRecovery({ page, mount, consoleGuard }, seedsFrom(1, 2), {
    tasks: 12,
    withLargest: false,
  });
});
