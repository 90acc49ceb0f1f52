// @ts-check
// Which functions the JavaScript of a frame is spent in, by the browser's own profiler, on pages built with their names:
//   node tests/bench/profile.mjs [--lights 128] [--step moving|setting|still|unlit|turning] [--frames 20000] [--top 25]
//   [--source CHECKOUT] [--browser PATH --arg=…]

import { mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { buildPages, Session } from './session.mjs';

const { values: options } = parseArgs({
  options: {
    lights: { type: 'string', default: '128' },
    step: { type: 'string', default: 'moving' },
    frames: { type: 'string', default: '20000' },
    top: { type: 'string', default: '25' },
    seed: { type: 'string', default: '1' },
    source: { type: 'string', default: '' },
    browser: { type: 'string', default: '' },
    arg: { type: 'string', multiple: true, default: [] },
  },
});

process.env['PHONG_VIEWER_BENCH_NAMES'] = 'kept';
const page = await buildPages(mkdtempSync(join(tmpdir(), 'phong-viewer-bench-')), options.source);
const session = await Session.open({ ...options, args: options.arg, page });
const browser = await session.launch();
const tab = await browser.newPage();
await tab.goto(`${session.origin}/script.html`);
const [lights, seed] = [Number(options.lights), Number(options.seed)];
await tab.evaluate(
  ([n, s]) => window.openScript(n, s).then(() => undefined),
  /** @type {const} */ ([lights, seed]),
);
const debug = await tab.context().newCDPSession(tab);
await debug.send('Profiler.enable');
await debug.send('Profiler.setSamplingInterval', { interval: 100 });
await debug.send('Profiler.start');
const step = /** @type {import('./pages/script.js').Step} */ (options.step);
const frames = Number(options.frames);
const ms = await tab.evaluate(
  ([s, n]) => window.scriptBench.run(s, n),
  /** @type {const} */ ([step, frames]),
);
const { profile } = await debug.send('Profiler.stop');
await browser.close();
session.close();

/** Microseconds by function: its own, without what it calls. @type {Map<string, number>} */
const own = new Map();
const names = new Map(
  profile.nodes.map(({ id, callFrame }) => [
    id,
    `${callFrame.functionName || '(anonymous)'} ${callFrame.url.split('/').pop() ?? ''}:${callFrame.lineNumber + 1}`,
  ]),
);
profile.samples?.forEach((node, i) => {
  const name = names.get(node) ?? '';
  own.set(name, (own.get(name) ?? 0) + (profile.timeDeltas?.[i] ?? 0));
});
console.log(
  `${step}, ${lights} lights: ${((ms * 1e3) / frames).toFixed(1)} µs a frame, of which each function itself:`,
);
const sorted = [...own].sort(([, a], [, b]) => b - a).slice(0, Number(options.top));
for (const [name, us] of sorted) console.log(`${(us / frames).toFixed(2).padStart(8)} µs  ${name}`);
