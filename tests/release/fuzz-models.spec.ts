// The long form of tests/element/models/fuzz-models.spec.ts: 2,400 hostile models.
import { fuzzModels } from '../fuzz/model-run.js';
import { test } from '../support/test.js';

const FIRST = Number(process.env['PHONG_VIEWER_SEED'] ?? 100);

for (let seed = FIRST; seed < FIRST + 6; seed++) {
  test(`@release four hundred hostile models each end in an event within bounded memory, and the picture stays (seed ${seed})`, async ({
    browser,
    page,
    mount,
    consoleGuard,
  }) => {
    test.setTimeout(1_800_000);
    await fuzzModels(browser, page, mount, { seed, count: 400, consoleGuard });
  });
}
