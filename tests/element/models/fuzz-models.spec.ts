// A few hostile models, as a sample of what tests/release/long-forms.spec.ts loads by the thousand.
import { fuzzModels, load, MemoryWatch } from '../../fuzz/model-run.js';
import { barClaimsGlb, barGlb } from '../../fuzz/models.js';
import { expect, test } from '../../support/test.js';

const SEED = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);

test(`twelve hostile models each end in an event, and the picture stays (seed ${SEED})`, async ({
  browser,
  page,
  mount,
  consoleGuard,
}) => {
  test.slow();
  await fuzzModels(browser, page, mount, { seed: SEED, count: 12, consoleGuard });
});

test('a small file whose accessor claims 300 million elements takes no memory for them, whichever accessor it is', async ({
  browser,
  mount,
  site,
  consoleGuard,
}) => {
  // Animations whose times do not fit their values are left out.
  consoleGuard.allow(/^warning: .* is shown without animations/);
  const viewer = await mount('<phong-viewer></phong-viewer>', { width: 60, height: 40 });
  expect(await load(viewer, site.file(barGlb()))).toBe('load');
  const memory = await MemoryWatch.of(browser);
  for (let accessor = 0; accessor < 14; accessor += 1) {
    for (const sparse of [false, true]) {
      const address = site.file(barClaimsGlb(accessor, 3e8, 5120, sparse));
      memory.start();
      expect(await load(viewer, `${address}?${String(accessor)},${String(sparse)}`)).toMatch(
        /^(bad-model|too-large|load)$/,
      );
      expect(memory.stop(), `growth in MB by accessor ${String(accessor)}`).toBeLessThan(100);
    }
  }
});
