// @ts-check
// Run time against error, for everything that trades one for the other, with growth and peers in the same run.
//   npm run bench                              everything; an hour or so in software
//   npm run bench -- --only loops,growth       some of it: an axis, growth, peers, figures   --scenes '8 mixed,8 spots'
//   --launches 5 --rounds 5 --seed 1           fresh browsers, samples of each in a browser, other lights
//   --out FILE.json                            default: a file of tests/bench/results, named after the machine's GPU
//   --compare A.json B.json                    what moved by more than its noise
//   --browser PATH --arg=--use-angle=vulkan    a real GPU (none: software GL)   --width 1920 --height 1080
//   --build FOLDER   only builds the pages;  --page FOLDER uses such, for machines with Node and a browser alone

import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { printComparison } from './compare-results.mjs';
import { AXES, frontsOf } from './fronts.mjs';
import { growths } from './growths.mjs';
import { FIGURES } from './figures/index.mjs';
import { peerLine } from './figures/peer-row.mjs';
import { peers } from './figures/peers.mjs';
import { reportOf } from './report-text.mjs';
import { heading, line } from './report.mjs';
import { readResult } from './result-file.mjs';
import { isSoftware } from './sampling.mjs';
import { buildPages, Session } from './session.mjs';
import { writeReport } from './write-report.mjs';

const { values: options, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    only: { type: 'string', default: [...AXES, 'growth', 'peers', 'figures'].join() },
    scenes: { type: 'string', default: '' },
    launches: { type: 'string', default: '5' },
    rounds: { type: 'string', default: '3' },
    width: { type: 'string', default: '' },
    height: { type: 'string', default: '' },
    lights: { type: 'string', default: '1,4,16,64' },
    sample: { type: 'string', default: '40' },
    evaluations: { type: 'string', default: '600000' },
    seed: { type: 'string', default: '1' },
    out: { type: 'string', default: '' },
    source: { type: 'string', default: '' },
    build: { type: 'string', default: '' },
    compare: { type: 'string', default: '' },
    browser: { type: 'string', default: '' },
    arg: { type: 'string', multiple: true, default: [] },
    page: { type: 'string', default: '' },
  },
});

if (options.compare !== '') {
  printComparison(readResult(options.compare), readResult(positionals[0] ?? ''));
  process.exit();
}
if (options.build !== '') {
  await buildPages(resolve(options.build), options.source);
  process.exit();
}

const only = options.only.split(',');
const begun = Date.now();
const alone = only.every((name) => name === 'growth' || AXES.includes(name));
const session = await Session.open({ ...options, args: options.arg, alone });
const machine = await session.machine();
console.log(heading(machine));
const software = isSoftware(machine.renderer);
/** What a picture of usual size is on each. */
const [width, height] = software ? [480, 360] : [1920, 1080];
const settings = {
  launches: Number(options.launches),
  rounds: Number(options.rounds),
  width: Number(options.width || width),
  height: Number(options.height || height),
  sampleMs: Number(options.sample),
  evaluations: Number(options.evaluations),
  seed: Number(options.seed),
  counts: options.lights.split(',').map(Number),
  scenes: options.scenes === '' ? [] : options.scenes.split(','),
  software,
};
const here = fileURLToPath(new URL('.', import.meta.url));
const file = options.out || join(here, 'results', `${stackName(machine)}.json`);

/** @type {import('./result-file.mjs').BenchResult} */
const result = {
  machine: { ...machine, measured: new Date(begun).toISOString().slice(0, 10) },
  seed: settings.seed,
  launches: settings.launches,
  rounds: settings.rounds,
  ...{ fronts: [], growth: [], peers: [], figures: {} },
};
for (const axis of AXES.filter((name) => only.includes(name))) {
  for await (const front of frontsOf(session, axis, settings)) keep(() => result.fronts.push(front));
}
if (only.includes('growth')) {
  for await (const growth of growths(session, settings)) keep(() => result.growth.push(growth));
}
if (only.includes('peers')) {
  for await (const row of peers(session, settings)) {
    console.log(peerLine(row));
    keep(() => result.peers.push(row));
  }
}
for (const [name, measure] of Object.entries(FIGURES)) {
  if (!only.includes('figures') && !only.includes(name)) continue;
  for await (const figure of measure(session, settings)) {
    console.log(line(figure));
    keep(() => (result.figures[name] ??= []).push(figure));
  }
}
session.close();
const drawn = drawCharts();
console.log(`\n${file} and ${drawn}, ${((Date.now() - begun) / 60_000).toFixed(1)} min`);

/** The fronts as pictures: of what is kept for the report with it, of other files beside them. */
function drawCharts() {
  if (options.out === '') {
    const { charts } = writeReport(here);
    return `${charts} charts of the report`;
  }
  const folder = file.replace(/\.json$/, '') + '-charts';
  mkdirSync(folder, { recursive: true });
  const { charts } = reportOf([{ stack: stackName(machine), ...result }]);
  for (const [name, chart] of charts) writeFileSync(join(folder, name), `${chart}\n`);
  return `${charts.size} charts in ${folder}`;
}

/** After each part: a run that ends early keeps what it has. @param {() => void} add */
function keep(add) {
  add();
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, `${JSON.stringify(result, null, 1)}\n`);
}

/** The card and what it was reached through, as a file's name. @param {{ renderer: string }} machine */
function stackName({ renderer }) {
  const card =
    /SwiftShader|llvmpipe/.exec(renderer)?.[0] ??
    /(?:NVIDIA|AMD|Intel|Apple|Adreno|Mali|Radeon|GeForce)[ -](?!Corporation|NVIDIA)[\w .-]*\w/.exec(
      renderer,
    )?.[0] ??
    'GPU';
  const through = /SwiftShader|llvmpipe/.test(card)
    ? undefined
    : /Vulkan|OpenGL|Direct3D11|Metal/.exec(renderer)?.[0];
  return (through === undefined ? card : `${card} through ${through}`).replaceAll(/[^\w]+/g, '-');
}
