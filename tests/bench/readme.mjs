// @ts-check
// The README's sentence about speed: frames of the sphere next to three.js, on the GPU that does worst. `npm run
// bench:report` writes it between the README's marks.

import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { stackKind } from './aims.mjs';
import { ratioOf } from './results.mjs';

/** @typedef {import('./results.mjs').BenchResult} BenchResult */

const MARKS = /** @type {const} */ (['<!-- bench: written by npm run bench:report -->', '<!-- /bench -->']);

/** Marks included. @param {readonly BenchResult[]} results */
export function readmeSentence(results) {
  const ratios = results
    .filter((result) => stackKind(result) === 'gpu')
    .flatMap(({ measures }) =>
      measures.filter(({ subject, measure }) => subject === 'sphere, 8 lights' && measure === 'settled'),
    )
    .flatMap((row) => ratioOf(row)?.median ?? []);
  return `${MARKS[0]}
Speed: nothing runs while nothing changes, and with eight lights a frame takes ${Math.max(...ratios).toFixed(2)} of the time of three.js's MeshPhongMaterial
on a GPU once the lights have kept their kinds for 20 frames ([report](tests/bench/REPORT.md)).
${MARKS[1]}`;
}

/** Writes it into the README. @param {readonly BenchResult[]} results */
export function writeSentence(results) {
  const file = fileURLToPath(new URL('../../README.md', import.meta.url));
  const readme = readFileSync(file, 'utf8');
  const [open, close] = MARKS.map((mark) => readme.indexOf(mark));
  if (open === undefined || close === undefined || open < 0 || close < open)
    throw new Error('README.md has lost its marks for the bench');
  writeFileSync(
    file,
    readme.slice(0, open) + readmeSentence(results) + readme.slice(close + MARKS[1].length),
  );
}
