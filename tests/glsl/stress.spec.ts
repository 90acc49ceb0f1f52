// Does the shipped GLSL, with the shipped packing, keep the numerical contract? The harness page tests itself in this browser:
// on its own driver, and on the worst lawful one. Before a release with ten times as many cases, on all lights of specialised programs at
// once, and on drivers that err one way alone; `npm run stress` does the same with a thousand times as many.
import type { Report } from './page/page.js';
import { expect, test } from '../support/test.js';

const SEED = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);

/**
 * Cases of the whole loop; `checks` of each chunk alone, whose programs take longer to compile than to run. Of 16 lights the exact
 * ones of a worst driver take 16 s, of every second one 4 s.
 */
const RUNS = {
  '': [
    { driver: 'shipped', cases: 1e5, checks: 4096, everyLight: 1 },
    { driver: 'either', cases: 2e4, checks: 4096, everyLight: 2 },
  ],
  '@release ': [
    { driver: 'shipped', cases: 1e6, checks: 16384, everyLight: 1 },
    { driver: 'up', cases: 2e5, checks: 16384, everyLight: 1 },
    { driver: 'down', cases: 2e5, checks: 16384, everyLight: 1 },
    { driver: 'either', cases: 2e5, checks: 16384, everyLight: 1 },
  ],
} as const;

for (const [release, { driver, cases, checks, everyLight }] of Object.entries(RUNS).flatMap(([tag, runs]) =>
  runs.map((run) => [tag, run] as const),
)) {
  const where = driver === 'shipped' ? 'this driver' : `the worst lawful driver, erring ${driver}`;
  test(`${release}keeps the contract on ${where}, in ${String(cases)} adversarial cases`, async ({
    page,
  }) => {
    test.setTimeout(300_000);
    const query = new URLSearchParams(
      Object.entries({ driver, cases, checks, everyLight, seed: SEED }).map(([key, value]) => [
        key,
        String(value),
      ]),
    );
    await page.goto(`/harness/index.html?${query.toString()}`);
    const report: Report = await page.evaluate(() => window.finished);
    console.log(`seed ${String(SEED)}, ${report.seconds.toFixed(1)} s, ${report.renderer}`);
    expect(report.error).toBeNull();
    expect(report.checked.length).toBeGreaterThan(10);
    expect(report.measured.reduce((sum, { cases: count }) => sum + count, 0)).toBeGreaterThanOrEqual(cases);
    // Three channels a case: where branch points are sought, at cones' edges and with denormal normals, half of the cases
    // may lie beside them.
    for (const { id, channels, cases: count } of report.measured) {
      expect.soft(channels / 3 / count, id).toBeGreaterThan(0.45);
    }
    expect(report.broken).toEqual([]);
  });
}
