// @ts-check
// The fronts of time against error: each axis with each of its scenes on a page of its own, its variants in turns, over fresh
// launches. In software time is the CPU time of the browser's GPU process, on a GPU its own timer's.

import { cpuSeconds } from './processes.mjs';
import { framesFor, isSoftware } from './sampling.mjs';
import { failOnErrors, gpuProcess } from './session.mjs';
import { interleaved, pairedRatios, spread } from './statistics.mjs';

/** In the order of a report. */
export const AXES = ['shading', 'loops', 'budget', 'antialias', 'scale'];

/**
 * @typedef {object} FrontSettings
 * @property {number} launches
 * @property {number} rounds
 * @property {number} width
 * @property {number} height
 * @property {number} sampleMs least time of a sample
 * @property {number} evaluations of the reference, at most
 * @property {number} seed
 * @property {readonly string[]} scenes empty: all
 */

/**
 * @param {import('./session.mjs').Session} session @param {string} axis @param {FrontSettings} settings
 * @returns {AsyncGenerator<import('./front.mjs').Front>}
 */
export async function* frontsOf(session, axis, settings) {
  const scenes = await scenesOf(session, axis);
  for (const scene of scenes) {
    if (settings.scenes.length > 0 && !settings.scenes.includes(scene)) continue;
    const front = await frontOf(session, axis, scene, settings);
    print(front);
    yield front;
  }
}

/** @param {import('./session.mjs').Session} session @param {string} axis */
async function scenesOf(session, axis) {
  const browser = await session.launch();
  const page = await browser.newPage();
  await page.goto(`${session.origin}/fronts.html`);
  const axes = await page.evaluate(() => window.fronts.axes);
  await browser.close();
  const found = axes.find(({ name }) => name === axis);
  if (found === undefined) throw new Error(`no axis ${axis}: ${axes.map(({ name }) => name).join(', ')}`);
  return found.scenes;
}

/**
 * @param {import('./session.mjs').Session} session @param {string} axis @param {string} scene @param {FrontSettings} settings
 * @returns {Promise<import('./front.mjs').Front>}
 */
async function frontOf(session, axis, scene, settings) {
  const { width, height, seed, evaluations, launches } = settings;
  /** @type {{ ms: number[][], ratios: number[][] }} [subject][sample] */
  const all = { ms: [], ratios: [] };
  /** @type {import('./error/error-figures.js').ErrorFigures[]} */
  let errors = [];
  /** @type {import('./stands/runner.js').StandFacts | undefined} */
  let facts;
  /** @type {import('./front.mjs').Front['measure']} */
  let measure = 'clock';
  for (let launch = 0; launch < launches; launch++) {
    const browser = await session.launch();
    const page = await browser.newPage({ viewport: { width, height } });
    const check = failOnErrors(page);
    await page.goto(`${session.origin}/fronts.html`);
    facts = await page.evaluate(
      ([a, s, o]) => window.fronts.open(a, s, o),
      /** @type {const} */ ([axis, scene, { size: [width, height], seed, evaluations }]),
    );
    if (launch === 0) errors = await page.evaluate(() => window.fronts.errors());
    const meter = await meterOf(page, await gpuProcess(browser), facts);
    measure = meter.measure;
    const samples = await samplesOf(facts, meter.sample, settings);
    const base = samples[facts.subjects.findIndex(({ id }) => id === facts?.base)] ?? [];
    samples.forEach((ms, i) => {
      (all.ms[i] ??= []).push(...ms);
      (all.ratios[i] ??= []).push(...pairedRatios(ms, base));
    });
    check();
    await browser.close();
  }
  if (facts === undefined) throw new Error('no launches: nothing was measured');
  const { title, truth, base, shipped, size, errorSize, subjects } = facts;
  const points = subjects.map(({ id, label }, i) => {
    const error = errors[i];
    if (error === undefined) throw new Error(`${axis}, ${scene}, ${id}: no error was measured`);
    return { id, label, time: spread(all.ms[i] ?? []), ratio: spread(all.ratios[i] ?? []), error };
  });
  return { ...{ axis, scene, title, truth, base, shipped, measure }, ...{ size, errorSize, points } };
}

/**
 * Milliseconds that so many frames of a subject take.
 * @param {import('playwright-core').Page} page @param {number | null} gpu its process @param {import('./stands/runner.js').StandFacts} facts
 * @returns {Promise<{ measure: import('./front.mjs').Front['measure'], sample: (subject: number, frames: number) => Promise<number> }>}
 */
export async function meterOf(page, gpu, { renderer, hasTimer }) {
  /** @param {number} subject @param {number} frames */
  const clock = (subject, frames) =>
    page.evaluate(([i, n]) => window.fronts.clock(i, n), /** @type {const} */ ([subject, frames]));
  if (!isSoftware(renderer)) {
    if (!hasTimer) return { measure: 'clock', sample: clock };
    return {
      measure: 'GPU timer',
      sample: (subject, frames) =>
        page.evaluate(([i, n]) => window.fronts.time(i, n), /** @type {const} */ ([subject, frames])),
    };
  }
  if (gpu === null) return { measure: 'clock', sample: clock };
  return {
    measure: 'CPU time of the GPU process',
    async sample(subject, frames) {
      const before = cpuSeconds(gpu);
      await clock(subject, frames);
      return (cpuSeconds(gpu) - before) * 1000;
    },
  };
}

/**
 * Milliseconds a frame: [subject][round].
 * @param {import('./stands/runner.js').StandFacts} facts @param {(subject: number, frames: number) => Promise<number>} sample
 * @param {Pick<FrontSettings, 'rounds' | 'sampleMs'>} settings
 */
export async function samplesOf({ subjects }, sample, { rounds, sampleMs }) {
  /** @type {number[]} */
  const frames = [];
  for (const i of subjects.keys())
    frames.push(await framesFor((count) => sample(i, count), sampleMs, MOST_FRAMES));
  const indices = subjects.map((_, i) => i);
  const samples = await interleaved(indices, rounds, (i) => sample(i, frames[i] ?? 1));
  return samples.map((ms, i) => ms.map((total) => total / (frames[i] ?? 1)));
}

/** A frame of nothing takes no time however often it is drawn. */
const MOST_FRAMES = 4000;

/** @param {import('./front.mjs').Front} front */
function print({ title, size, errorSize, measure, points }) {
  console.log(`\n${title} (${size.join(' × ')}, ${measure}; errors of ${errorSize.join(' × ')})`);
  for (const { label, time, ratio, error } of points) {
    const range = `${ratio.median.toFixed(3)} (${ratio.low.toFixed(3)}–${ratio.high.toFixed(3)})`;
    const { rmse, p999, max } = error;
    const errors = [rmse, p999, max].map((x) => x.toPrecision(2)).join(' / ');
    console.log(
      `  ${label.padEnd(44)} ${range.padEnd(24)} ${time.median.toPrecision(3).padStart(7)} ms  ${errors}`,
    );
  }
}
