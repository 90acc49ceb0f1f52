// @ts-check
// How time grows with the number of lights, pixels, triangles, meshes, and of viewers on a page.

import { startsOf } from './figures/index.mjs';
import { meterOf, samplesOf } from './fronts.mjs';
import { growthOf } from './growth.mjs';
import { failOnErrors, gpuProcess } from './session.mjs';

const NAMES = ['lights', 'pixels', 'triangles', 'meshes'];
const VIEWERS = [1, 4, 16, 64];

/**
 * @param {import('./session.mjs').Session} session @param {import('./fronts.mjs').FrontSettings} settings
 * @returns {AsyncGenerator<import('./growth.mjs').Growth>}
 */
export async function* growths(session, settings) {
  for (const name of NAMES) yield told(await growthIn(session, name, settings));
  const pages = VIEWERS.map((count) => ({
    path: `viewers-element.html?count=${count}`,
    tag: 'phong-viewer',
    count,
  }));
  const of = await startsOf(session, { ...settings, rounds: 1 }, pages);
  const samples = VIEWERS.map((at, i) => ({ at, ms: of(i, 'ms') }));
  yield told(growthOf('viewers on a page, navigation to all lit', 'viewers', 'clock', samples));
}

/**
 * @param {import('./session.mjs').Session} session @param {string} name @param {import('./fronts.mjs').FrontSettings} settings
 */
async function growthIn(session, name, settings) {
  const { width, height, seed, launches } = settings;
  /** @type {number[][]} */
  const all = [];
  /** @type {number[]} */
  let counts = [];
  /** @type {import('./growth.mjs').Growth['measure']} */
  let measure = 'clock';
  for (let launch = 0; launch < launches; launch++) {
    const browser = await session.launch();
    const page = await browser.newPage({ viewport: { width, height } });
    const check = failOnErrors(page);
    await page.goto(`${session.origin}/fronts.html`);
    const facts = await page.evaluate(
      ([n, o]) => window.fronts.open('growth', n, o),
      /** @type {const} */ ([name, { size: [width, height], seed, evaluations: 0 }]),
    );
    counts = facts.subjects.map(({ id }) => Number(id));
    const meter = await meterOf(page, await gpuProcess(browser), facts);
    measure = meter.measure;
    const samples = await samplesOf(facts, meter.sample, settings);
    samples.forEach((ms, i) => (all[i] ??= []).push(...ms));
    check();
    await browser.close();
  }
  return growthOf(
    name,
    name,
    measure,
    counts.map((at, i) => ({ at, ms: all[i] ?? [] })),
  );
}

/** @param {import('./growth.mjs').Growth} growth */
function told(growth) {
  const { name, measure, slope, slopeUpper, points } = growth;
  console.log(
    `\n${name} (${measure}): time grows by the power ${slope.toFixed(2)}, ${slopeUpper.toFixed(2)} in the upper half`,
  );
  for (const { at, time } of points) {
    console.log(`  ${at.toLocaleString('en').padStart(10)}  ${time.median.toPrecision(3)} ms`);
  }
  return growth;
}
