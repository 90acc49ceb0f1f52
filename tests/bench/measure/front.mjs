// @ts-check
// One launch of a front: run time of every variant, in turns, and its error against float64.

import { frameTime, gpuProcess, openPage } from '../browser.mjs';
import { interleaved } from '../statistics.mjs';
import { framesFor } from './frames.mjs';

const SAMPLE = { ms: 40, most: 2000 };

/**
 * @param {import('../browser.mjs').Lab} lab @param {string} subject @param {string} name @param {Pick<import('./frames.mjs').Options, 'size' | 'rounds'>} options
 * @returns {Promise<import('../results.mjs').FrontResult>}
 */
export async function measureFront(lab, subject, name, { size, rounds }) {
  const browser = await lab.launch();
  const gpu = await gpuProcess(browser);
  const { page, check } = await openPage(browser, `${lab.origin}/front.html`, size);
  const facts = await page.evaluate(([n, s]) => window.openFront(n, s), /** @type {const} */ ([name, size]));
  const errors = await page.evaluate(() => window.front.errors());
  /** @param {number} variant @param {number} frames */
  const sample = (variant, frames) => {
    const call = /** @type {const} */ ([variant, frames]);
    return frameTime(
      facts.renderer,
      gpu,
      () => page.evaluate(([v, n]) => window.front.time(v, n), call),
      () => page.evaluate(([v, n]) => window.front.draw(v, n), call),
    );
  };
  /** @type {number[]} */
  const counts = [];
  for (const i of facts.variants.keys()) {
    await sample(i, 1); // compiles
    counts.push(await framesFor((frames) => sample(i, frames), SAMPLE));
  }
  const ms = await interleaved([...counts.keys()], rounds, async (i) => {
    const count = counts[i] ?? 1;
    return Number(((await sample(i, count)) / count).toPrecision(4));
  });
  check();
  const { title, variants, base } = facts;
  return { subject, title, variants: [...variants], base, errors, ms };
}
