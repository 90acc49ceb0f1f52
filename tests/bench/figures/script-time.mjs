// @ts-check
// JavaScript that a frame costs a page, and the calls to WebGL it makes: the element with moving lights against three.js
// with one unlit mesh, in turns on one page. CPU time of the page's thread where the system tells of it, else the clock.

import { mainThreadSeconds, processOfPage, tellsCpuTime } from '../processes.mjs';
import { failOnErrors } from '../session.mjs';
import { interleaved } from '../statistics.mjs';

/** Frames of a sample: some ten milliseconds, beside which the call from outside is nothing. */
const FRAMES = 1000;

/** @typedef {import('../pages/script.js').Step} Step */

/**
 * @param {import('../session.mjs').Session} session @param {number} lights
 * @param {{ launches: number, rounds: number, seed: number }} options
 */
export async function scriptTimes(session, lights, { launches, rounds, seed }) {
  /** Microseconds a frame. @type {Record<Step, number[]>} */
  const times = { moving: [], setting: [], still: [], unlit: [], turning: [] };
  /** @type {Partial<Record<Step, Record<string, number>>>} */
  const calls = {};
  const steps = /** @type {Step[]} */ (Object.keys(times));
  for (let launch = 0; launch < launches; launch++) {
    const browser = await session.launch();
    const page = await browser.newPage();
    const check = failOnErrors(page);
    await page.goto(`${session.origin}/script.html`);
    await page.evaluate(
      ([n, s]) => window.openScript(n, s).then(() => undefined),
      /** @type {const} */ ([lights, seed]),
    );
    const thread = tellsCpuTime() ? await processOfPage(browser, page) : null;
    /** @param {Step} step */
    const sample = async (step) => {
      const before = thread === null ? 0 : mainThreadSeconds(thread);
      const ms = await page.evaluate(
        ([s, n]) => window.scriptBench.run(s, n),
        /** @type {const} */ ([step, FRAMES]),
      );
      return thread === null ? (ms * 1e3) / FRAMES : ((mainThreadSeconds(thread) - before) * 1e6) / FRAMES;
    };
    const samples = await interleaved(steps, rounds, sample);
    steps.forEach((step, i) => times[step].push(...(samples[i] ?? [])));
    for (const step of steps) calls[step] = await page.evaluate((s) => window.scriptBench.calls(s), step);
    check();
    await browser.close();
  }
  return { times, calls };
}

/** @param {Record<string, number> | undefined} calls */
export const total = (calls) => Object.values(calls ?? {}).reduce((sum, n) => sum + n, 0);

/** What one frame calls more often than another, such as `bufferSubData +1`. @param {Record<string, number>} more @param {Record<string, number>} less */
export const differences = (more, less) =>
  [...new Set([...Object.keys(more), ...Object.keys(less)])]
    .map((name) => ({ name, by: (more[name] ?? 0) - (less[name] ?? 0) }))
    .filter(({ by }) => by !== 0)
    .map(({ name, by }) => `${name} ${by > 0 ? '+' : ''}${by}`)
    .join(', ');
