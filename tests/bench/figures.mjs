// @ts-check
// How the element compares with its peers: frame time, JavaScript per frame, start, many viewers on a page; and, by
// `peers`, with everything else that shows a lit 3D scene.
//   node tests/bench/figures.mjs [--only frame,loop,raw,idle,script,start,viewers,peers] [--launches 3] [--rounds 5] [--out result.json]
//   --source CHECKOUT  measures that checkout's src/        --seed 1  other lights
//   --browser PATH --arg=--use-angle=vulkan --arg=…         a real GPU (none: software GL)
//   --build FOLDER     only builds the pages; --page FOLDER uses such, for machines with Node and a browser alone

import { readFileSync, writeFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { FIGURES } from './figures/index.mjs';
import { peerLine } from './figures/peer-row.mjs';
import { peers } from './figures/peers.mjs';
import { heading, line } from './report.mjs';
import { buildPages, Session } from './session.mjs';

const { values: options } = parseArgs({
  options: {
    only: { type: 'string', default: [...Object.keys(FIGURES), 'peers'].join() },
    launches: { type: 'string', default: '3' },
    rounds: { type: 'string', default: '5' },
    width: { type: 'string', default: '800' },
    height: { type: 'string', default: '600' },
    lights: { type: 'string', default: '1,2,4,8,16,32,64,128,256' },
    sample: { type: 'string', default: '150' },
    seed: { type: 'string', default: '1' },
    out: { type: 'string', default: '' },
    source: { type: 'string', default: '' },
    build: { type: 'string', default: '' },
    browser: { type: 'string', default: '' },
    arg: { type: 'string', multiple: true, default: [] },
    page: { type: 'string', default: '' },
  },
});

if (options.build !== '') {
  await buildPages(options.build, options.source);
  process.exit();
}

const session = await Session.open({ ...options, args: options.arg });
const machine = { ...(await session.machine()), seed: Number(options.seed) };
console.log(heading(machine));
const settings = {
  launches: Number(options.launches),
  rounds: Number(options.rounds),
  width: Number(options.width),
  height: Number(options.height),
  seed: Number(options.seed),
  sampleMs: Number(options.sample),
  counts: options.lights.split(',').map(Number),
  software: /SwiftShader|llvmpipe/i.test(machine.renderer),
};
/** @type {Record<string, import('./report.mjs').Figure[]>} */
const results = {};
/** @type {import('./figures/peer-row.mjs').PeerRow[] | undefined} */
let rows;
for (const name of options.only.split(',')) {
  console.log(`\n${name}`);
  if (name === 'peers') {
    rows = [];
    for await (const row of peers(session, settings)) {
      rows.push(row);
      console.log(peerLine(row));
      keep();
    }
    continue;
  }
  const measure = FIGURES[name];
  if (measure === undefined)
    throw new Error(`no figure is named ${name}: ${Object.keys(FIGURES).join(', ')}, peers`);
  const figures = (results[name] ??= []);
  for await (const figure of measure(session, settings)) {
    figures.push(figure);
    console.log(line(figure));
    keep();
  }
}
session.close();

/** After each figure: a run that ends early keeps what it has; figures of other runs in the same file stay. */
function keep() {
  if (options.out === '') return;
  /** @type {{ figures?: Record<string, unknown>, peers?: unknown }} */
  let before = {};
  try {
    before = JSON.parse(readFileSync(options.out, 'utf8'));
  } catch {
    // the first of its file
  }
  const figures = { ...before.figures, ...results };
  const result = { machine, figures, peers: rows ?? before.peers ?? [] };
  writeFileSync(options.out, `${JSON.stringify(result, null, 1)}\n`);
}
