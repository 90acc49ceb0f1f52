// Do the stress cases still tell a guard's worth? A handful of mutants, live; `npm run mutation` makes all of them.
import { MUTANTS } from '../mutation/mutants.mjs';
import { expect, test } from '../support/test.js';
import type { Report } from './page/page.js';

/** From all over the loop: a series, a chord, a guard. */
const LIVE: readonly (readonly [file: string, removes: string])[] = [
  ['shaders/power.glsl', 'the series: log2 everywhere'],
  ['shaders/light_loop.glsl', 'the chord to the axis: half of one minus the cosine'],
  ['shaders/guard.glsl', 'the guard against vectors of zero length'],
];

/** Few, so that all of it takes seconds. */
const CATEGORIES = 'generic,cutoff-1e6,shininess-1e4,normals';
/** Of all chunks the programs alone take twenty times as long to compile. */
const CHUNKS = 'unitOrZero';

test('the stress cases find out when a guard is taken away', async ({ page }) => {
  test.setTimeout(120_000);
  const report = async (edit: object | null): Promise<Report> => {
    const query = new URLSearchParams({
      only: CATEGORIES,
      cases: '1000',
      seed: '1',
      chunks: CHUNKS,
      edit: JSON.stringify(edit),
    });
    await page.goto(`/harness/index.html?${query.toString()}`);
    return page.evaluate(() => window.finished);
  };
  expect(await report(null)).toMatchObject({ error: null, broken: [] });
  for (const [file, removes] of LIVE) {
    const mutant = MUTANTS.find((one) => one.file === file && one.removes === removes)!;
    const { error, broken } = await report({ from: mutant.from, to: mutant.to });
    expect.soft(error, removes).toBeNull();
    expect.soft(broken.length, removes).toBeGreaterThan(0);
  }
});
