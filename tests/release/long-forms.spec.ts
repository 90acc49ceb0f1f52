// The long forms of random tests: more and longer ones, from PHONG_VIEWER_SEED if it is set.

import { expectSmooth, filmZoom, loadAgain } from '../element/children/round-levels.js';
import { expectRecovery } from '../element/faults/fault-history.js';
import { expectAsNew, seedsFrom } from '../element/histories/history.js';
import { fuzzModels } from '../fuzz/model-run.js';
import { testContract } from '../glsl/contract-run.js';
import { test } from '../support/test.js';
import { SEED } from '../support/repeats.js';

const HOUR = 3_600_000;

// Of glsl/stress.spec.ts: all lights of the long programs at once, and drivers that err in one
// direction only.
testContract({ driver: 'shipped', cases: 1e6, checks: 16384, everyLight: 1 }, '@release ');
for (const driver of ['up', 'down', 'either'] as const) {
  testContract({ driver, cases: 2e5, checks: 16384, everyLight: 1 }, '@release ');
}

// Of element/faults/fault-histories.spec.ts, with pictures of 9000 × 9000 pixels.
const FAULTS = Number(process.env['PHONG_VIEWER_FAULTS'] ?? 120);
test(`@release pages recover from long random faults (seeds from ${SEED})`, async ({
  page,
  mount,
  consoleGuard,
}) => {
  test.setTimeout(HOUR / 2);
  const long = { tasks: 40, withLargest: true };
  await expectRecovery({ page, mount, consoleGuard }, seedsFrom(SEED, FAULTS), long);
});

// Of element/histories/histories.spec.ts.
const WALKS = Number(process.env['PHONG_VIEWER_WALKS'] ?? 36);
for (const [what, kind] of [
  ['pages show the same after many random changes as new pages', undefined],
  ['pages show the same after changes with unusual trees and values as new pages', 'trees'],
  ['pictures show the same after many changes in the middle of their samples as new ones', 'still'],
] as const) {
  test(`@release ${what}`, async ({ page, mount, site, consoleGuard }) => {
    test.setTimeout(HOUR / 2);
    await expectAsNew({ page, mount, site, consoleGuard }, seedsFrom(SEED, WALKS), 6, kind);
  });
}

// Of element/models/fuzz-models.spec.ts, whose seeds are below 100.
for (let seed = SEED + 99; seed < SEED + 105; seed++) {
  test(`@release 400 hostile models end in events (seed ${seed})`, async ({
    browser,
    page,
    mount,
    consoleGuard,
  }) => {
    test.setTimeout(HOUR / 2);
    await fuzzModels(browser, page, mount, { seed, count: 400, consoleGuard });
  });
}

// Of element/children/segments.spec.ts.
test('@release the same markup gives the same picture of the same triangles at 100 loads', async ({
  mount,
}) => {
  test.setTimeout(HOUR / 12);
  await loadAgain(mount, 100);
});

test('@release zooms of 150 frames show no jump and no blank frame', async ({ page, mount }) => {
  test.setTimeout(HOUR / 12);
  for (const geometry of ['sphere', 'torus', 'cylinder', 'cone']) {
    expectSmooth(await filmZoom(page, mount, geometry, 150, { width: 160, height: 120 }), geometry);
  }
});
