// @ts-check
// Frame times of one scene by all its sides, each on a page of its own in one fresh browser: the
// first frames, the longest frame of the take-over by a specialised program, and settled. Also
// script per frame. The longest frame and the usual frame beside it are wall time; the others are
// GPU time, in software CPU time of the GPU process.

import { frameTime, gpuProcess, mainThreadTime, openPage } from '../browser.mjs';
import { interleaved, inTurns } from '../statistics.mjs';

/** Frames before the first sample: the very first ones compile. */
const WARM_FRAMES = 2;
/** With the warm ones, below the 20 frames after which a specialised program may be requested. */
const FIRST_FRAMES = 8;
/** Length of a settled sample, in milliseconds, and its most frames. */
const SAMPLE = { ms: 60, most: 400 };
const SCRIPT_SAMPLE = { ms: 150, most: 4000 };
const SCRIPT_SIZE = /** @type {const} */ ([16, 16]);
/** Frames until the browser has optimised the script. */
const SCRIPT_WARM_MS = 1500;

/**
 * @typedef {import('../pages/frame.js').SideName} SideName
 * @typedef {{ side: SideName, page: import('playwright-core').Page, check: () => void, facts:
 * Awaited<ReturnType<import('../pages/frame.js').FrameBench['open']>> }} Opened
 * @typedef {{ size: readonly [number, number], rounds: number, add: (measure: string, unit: string,
 * values: Record<string, number>) => void }} Options
 */

/**
 * One launch of a frame subject.
 * @param {import('../browser.mjs').Lab} lab @param {import('../subjects.mjs').FrameSubject} subject
 * @param {number} launch @param {Options} options
 */
export async function measureFrames(lab, { scene, sides }, launch, { size, rounds, add }) {
  const browser = await lab.launch();
  const gpu = await gpuProcess(browser);
  /** @type {Record<string, Opened & { first: number, longest: number, usual: number }>} */
  const opened = {};
  for (const side of inTurns(sides, launch)) {
    const one = await openSide(browser, lab, scene, side, size);
    await one.page.evaluate((n) => window.bench.draw(n), WARM_FRAMES);
    const first = (await sample(one, gpu, FIRST_FRAMES)) / FIRST_FRAMES;
    opened[side] = { ...one, first, ...(await one.page.evaluate(() => window.bench.settle())) };
  }
  const pages = sides.flatMap((side) => opened[side] ?? []);
  assertAlike(pages);
  const settled = await frameTimes(
    pages.map((one) => (n) => sample(one, gpu, n)),
    SAMPLE,
    rounds,
  );
  pages.forEach(({ check }) => check());
  /**
   * @param {string} measure @param {(one: typeof pages[number], i: number) => number | undefined}
   * valueOf
   */
  const addAll = (measure, valueOf) =>
    add(
      measure,
      'ms',
      Object.fromEntries(pages.map((one, i) => [one.side, valueOf(one, i) ?? NaN])),
    );
  addAll('first frames', ({ first }) => first);
  addAll('longest frame', ({ longest }) => longest);
  addAll('usual frame', ({ usual }) => usual);
  for (let round = 0; round < rounds; round++) {
    addAll('settled', (_, i) => settled[i]?.[round]);
  }
}

/**
 * One launch of a script subject. In microseconds of the page's main thread per frame.
 * @param {import('../browser.mjs').Lab} lab @param {import('../subjects.mjs').ScriptSubject}
 * subject @param {Omit<Options, 'size'>} options
 */
export async function measureScript(lab, { scene, sides }, { rounds, add }) {
  const browser = await lab.launch();
  /** @type {((frames: number) => Promise<number>)[]} */
  const samplers = [];
  /** @type {(() => void)[]} */
  const checks = [];
  for (const side of sides) {
    const { page, check } = await openSide(browser, lab, scene, side, SCRIPT_SIZE);
    const cpuTime = await mainThreadTime(page);
    /** @param {number} frames */
    const time = async (frames) => {
      const before = await cpuTime();
      await page.evaluate((n) => window.bench.script(n), frames);
      return (await cpuTime()) - before;
    };
    for (const begin = Date.now(); Date.now() - begin < SCRIPT_WARM_MS;) {
      await time(5);
    }
    samplers.push(time);
    checks.push(check);
  }
  const samples = await frameTimes(samplers, SCRIPT_SAMPLE, rounds);
  checks.forEach((check) => check());
  for (let round = 0; round < rounds; round++) {
    const values = sides.map((side, i) => [side, 1000 * (samples[i]?.[round] ?? NaN)]);
    add('script per frame', 'µs', Object.fromEntries(values));
  }
}

/**
 * @param {import('playwright-core').Browser} browser @param {import('../browser.mjs').Lab} lab
 * @param {string} scene @param {SideName} side
 * @param {readonly [number, number]} size @returns {Promise<Opened>}
 */
async function openSide(browser, lab, scene, side, size) {
  const url = `${lab.origin}/frame.html?scene=${scene}&side=${side}`;
  const { page, check } = await openPage(browser, url, size);
  const facts = await page.evaluate(() => window.bench.open());
  check();
  if (facts.lit < 0.02) throw new Error(`${scene}, ${side}: the picture is empty`);
  return { side, page, check, facts };
}

/**
 * The sides have to draw the same number of samples of as many pixels. @param {readonly Opened[]}
 * opened
 */
function assertAlike(opened) {
  const [one, ...others] = opened.map(({ facts }) => JSON.stringify(facts.canvas));
  for (const other of others) {
    if (other !== one) throw new Error(`the sides' canvases differ: ${one} and ${other}`);
  }
  const shares = opened.map(({ facts }) => facts.lit);
  if (Math.max(...shares) - Math.min(...shares) > 0.02) {
    throw new Error(`the sides' pictures differ: shares ${shares.join(', ')} are covered`);
  }
}

/**
 * Milliseconds that so many frames take. @param {Opened} one @param {number | null} gpu @param
 * {number} frames
 */
const sample = ({ page, facts }, gpu, frames) =>
  frameTime(
    facts.renderer,
    gpu,
    () => page.evaluate((n) => window.bench.time(n), frames),
    () => page.evaluate((n) => window.bench.draw(n), frames),
  );

/**
 * So many frames that a sample is long enough.
 * @param {(frames: number) => Promise<number>} time milliseconds of so many frames
 * @param {{ ms: number, most: number }} wanted
 */
async function framesFor(time, { ms, most }) {
  let count = 1;
  for (;;) {
    const taken = Math.max(await time(count), 0.01);
    if (taken >= ms || count >= most) return count;
    count = Math.min(most, Math.ceil(count * Math.min(8, (1.3 * ms) / taken)));
  }
}

/**
 * Milliseconds of one frame by each sampler, in turns.
 * @param {readonly ((frames: number) => Promise<number>)[]} samplers @param {{ ms: number, most:
 * number }} wanted @param {number} rounds
 */
async function frameTimes(samplers, wanted, rounds) {
  const timed = [];
  for (const time of samplers) {
    timed.push({ time, count: await framesFor(time, wanted) });
  }
  return interleaved(timed, rounds, async ({ time, count }) => (await time(count)) / count);
}
