// @ts-check
// One launch of a front: run time of every variant, in turns, and its error against float64.

import { frameTime, gpuProcess, openPage } from '../browser.mjs';
import { frameTimes } from './frames.mjs';

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
  const samplers = facts.variants.map((_, variant) => (/** @type {number} */ frames) => {
    const call = /** @type {const} */ ([variant, frames]);
    return frameTime(
      facts.renderer,
      gpu,
      () => page.evaluate(([v, n]) => window.front.time(v, n), call),
      () => page.evaluate(([v, n]) => window.front.draw(v, n), call),
    );
  });
  for (const sample of samplers) await sample(1); // compiles
  const times = await frameTimes(samplers, SAMPLE, rounds);
  const ms = times.map((rounds) => rounds.map((time) => Number(time.toPrecision(4))));
  check();
  const { title, variants, base } = facts;
  return { subject, title, variants: [...variants], base, errors, ms };
}
