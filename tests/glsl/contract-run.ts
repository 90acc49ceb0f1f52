// One run of the contract as a test: the harness page tests itself in this browser, on its own
// driver or on a worst lawful one.
import { expect, test } from '../support/test.js';
import type { Driver } from './worst-driver.js';
import { SEED } from '../support/repeats.js';

interface ContractRun {
  readonly driver: Driver;
  /** Stress cases of the whole loop. */
  readonly cases: number;
  /** Inputs of each chunk alone, whose programs take longer to compile than to run. */
  readonly checks: number;
  /**
   * Of the lights of the long programs, one in this many: all 16 take a worst driver 16 s to
   * compile, every second one 4 s.
   */
  readonly everyLight: number;
}

/** `tag` begins the title. */
export function testContract({ driver, cases, checks, everyLight }: ContractRun, tag = ''): void {
  const where = driver === 'shipped' ? 'this driver' : `the worst lawful driver, erring ${driver}`;
  test(`${tag}keeps the contract on ${where}, in ${String(cases)} adversarial cases`, async ({
    page,
  }) => {
    test.setTimeout(300_000);
    const extent = `cases=${cases}&checks=${checks}&everyLight=${everyLight}`;
    await page.goto(`/harness/index.html?driver=${driver}&seed=${SEED}&${extent}`);
    const report = await page.evaluate(() => window.finished);
    console.log(`seed ${String(SEED)}, ${report.seconds.toFixed(1)} s, ${report.renderer}`);
    expect(report.error).toBeNull();
    expect(report.checked.length).toBeGreaterThan(10);
    expect(
      report.measured.reduce((sum, { cases: count }) => sum + count, 0),
    ).toBeGreaterThanOrEqual(cases);
    // Three channels a case: where branch points are sought, at cones' edges and with denormal
    // normals, half of the cases may lie beside them.
    for (const { id, channels, cases: count } of report.measured) {
      expect.soft(channels / 3 / count, id).toBeGreaterThan(0.45);
    }
    expect(report.broken).toEqual([]);
  });
}
