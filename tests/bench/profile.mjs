// @ts-check
// Which functions a page's JavaScript is spent in, by the browser's own profiler, on pages built with their names: that of
// a frame, or from navigation to the first picture.
//   node tests/bench/profile.mjs [--lights 128] [--step moving|setting|still|unlit|turning] [--frames 5000]
//   node tests/bench/profile.mjs --start start-element.html
//   [--top 25] [--source CHECKOUT] [--page FOLDER of pages built with PHONG_VIEWER_BENCH_NAMES set] [--browser PATH --arg=…]

import { mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { buildPages, Session } from './session.mjs';

const { values: options } = parseArgs({
  options: {
    start: { type: 'string', default: '' },
    lights: { type: 'string', default: '128' },
    step: { type: 'string', default: 'moving' },
    frames: { type: 'string', default: '5000' },
    top: { type: 'string', default: '25' },
    seed: { type: 'string', default: '1' },
    source: { type: 'string', default: '' },
    page: { type: 'string', default: '' },
    browser: { type: 'string', default: '' },
    arg: { type: 'string', multiple: true, default: [] },
  },
});

process.env['PHONG_VIEWER_BENCH_NAMES'] = 'kept';
const folder =
  options.page || (await buildPages(mkdtempSync(join(tmpdir(), 'phong-viewer-bench-')), options.source));
const session = await Session.open({ ...options, args: options.arg, page: folder });
const browser = await session.launch();
const page = await browser.newPage();
const debug = await page.context().newCDPSession(page);
await debug.send('Profiler.enable');
await debug.send('Profiler.setSamplingInterval', { interval: 100 });
if (options.start === '') await profileFrames();
else await profileStart();
await browser.close();
session.close();

async function profileFrames() {
  await page.goto(`${session.origin}/script.html`);
  const [lights, seed, frames] = [options.lights, options.seed, options.frames].map(Number);
  await page.evaluate(
    ([n, s]) => window.openScript(n, s).then(() => undefined),
    /** @type {const} */ ([lights ?? 0, seed ?? 0]),
  );
  const step = /** @type {import('./pages/script.js').Step} */ (options.step);
  await debug.send('Profiler.start');
  const ms = await page.evaluate(
    ([s, n]) => window.scriptBench.run(s, n),
    /** @type {const} */ ([step, frames ?? 0]),
  );
  const { profile } = await debug.send('Profiler.stop');
  const own = ownTimes(profile);
  own.delete('readPixels'); // the wait for the GPU, between the frames that are timed
  print(`${step}, ${lights} lights`, own, ms * 1e3, frames ?? 0);
}

async function profileStart() {
  await debug.send('Profiler.start');
  await page.goto(`${session.origin}/${options.start}`, { waitUntil: 'commit' });
  await page.waitForFunction(() => window.firstPicture !== undefined, undefined, { polling: 20 });
  const { profile } = await debug.send('Profiler.stop');
  const us = (await page.evaluate(() => window.firstPicture ?? NaN)) * 1e3;
  print(options.start, ownTimes(profile), us, 1);
}

/**
 * @typedef {{ functionName: string, url: string, lineNumber: number }} CallFrame
 * @typedef {{ nodes: { id: number, callFrame: CallFrame }[], samples?: number[], timeDeltas?: number[] }} Profile
 */

/** Microseconds by function: its own, without what it calls. @param {Profile} profile */
function ownTimes({ nodes, samples = [], timeDeltas = [] }) {
  const names = new Map(
    nodes.map(({ id, callFrame: { functionName, url, lineNumber } }) => {
      const file = url.split('/').pop() ?? '';
      return [id, `${functionName || '(anonymous)'}${file === '' ? '' : ` ${file}:${lineNumber + 1}`}`];
    }),
  );
  /** @type {Map<string, number>} */
  const own = new Map();
  samples.forEach((node, i) => {
    const name = names.get(node) ?? '';
    own.set(name, (own.get(name) ?? 0) + (timeDeltas[i] ?? 0));
  });
  return own;
}

/** @param {string} title @param {Map<string, number>} own @param {number} us @param {number} times */
function print(title, own, us, times) {
  console.log(`${title}: ${(us / times).toFixed(1)} µs, of which each function itself:`);
  const sorted = [...own].sort(([, a], [, b]) => b - a).slice(0, Number(options.top));
  for (const [name, time] of sorted) console.log(`${(time / times).toFixed(2).padStart(10)} µs  ${name}`);
}
