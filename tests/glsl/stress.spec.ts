// Does the shipped GLSL, with the shipped packing, keep the numerical contract? The harness page tests itself in this browser:
// on its own driver, and on the worst lawful ones. `npm run stress` does the same with a hundred times as many cases.
import type { Report } from './page/page.js';
import { expect, test } from '../support/test.js';

const SEED = Number(process.env['PHONG_VIEWER_SEED'] ?? 1);

for (const [driver, cases, release = ''] of [
  ['shipped', 3e5],
  ['up', 6e4],
  ['down', 6e4],
  ['either', 6e4],
  ['shipped', 1e6, '@release '],
  ['up', 2e5, '@release '],
  ['down', 2e5, '@release '],
  ['either', 2e5, '@release '],
] as const) {
  const where = driver === 'shipped' ? 'this driver' : `the worst lawful driver, erring ${driver}`;
  test(`${release}keeps the contract on ${where}, in ${String(cases)} adversarial cases`, async ({
    page,
  }) => {
    test.setTimeout(300_000);
    await page.goto(`/harness/index.html?driver=${driver}&cases=${String(cases)}&seed=${String(SEED)}`);
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
