// A few hostile models, as a sample of what tests/release/long-forms.spec.ts loads by the thousand.
import { fuzzModels } from '../../fuzz/model-run.js';
import { test } from '../../support/test.js';
import { SEED } from '../../support/repeats.js';

test(`twelve hostile models end in events (seed ${SEED})`, async ({
  browser,
  page,
  mount,
  consoleGuard,
}) => {
  test.slow();
  await fuzzModels(browser, page, mount, { seed: SEED, count: 12, consoleGuard });
});
