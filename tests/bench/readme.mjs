// @ts-check
// Which figures of the bench does the README show? Frames of the sphere next to three.js, by number of lights and stack.
// `npm run bench:report` writes them between the README's marks.

import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { ratioOf } from './results.mjs';
import { SPHERE_LIGHTS } from './subjects.mjs';

const MARKS = /** @type {const} */ (['<!-- bench -->', '<!-- /bench -->']);

/** The README's part, marks included. @param {readonly import('./results.mjs').BenchResult[]} results */
function readmeFigures(results) {
  const rows = results.map((result) => {
    const cells = SPHERE_LIGHTS.map((count) => {
      const subject = `sphere, ${count === 1 ? '1 light' : `${count} lights`}`;
      return ['first frames', 'settled'].map((measure) => ratioText(result, subject, measure)).join(' / ');
    });
    return `| ${[result.stack, ...cells].join(' | ')} |`;
  });
  return `${MARKS[0]}

Frame times of a sphere that fills the view, next to three.js's MeshPhongMaterial (1; less is faster): first frames / faster program.

| lights | ${SPHERE_LIGHTS.join(' | ')} |
| --- |${' --- |'.repeat(SPHERE_LIGHTS.length)}
${rows.join('\n')}

${MARKS[1]}`;
}

/** @param {import('./results.mjs').BenchResult} result @param {string} subject @param {string} measure */
function ratioText(result, subject, measure) {
  const row = result.measures.find((one) => one.subject === subject && one.measure === measure);
  const ratio = row === undefined ? undefined : ratioOf(row);
  return ratio === undefined ? '–' : ratio.median.toFixed(2);
}

/** Writes them into the README. @param {readonly import('./results.mjs').BenchResult[]} results */
export function writeFigures(results) {
  const file = fileURLToPath(new URL('../../README.md', import.meta.url));
  const readme = readFileSync(file, 'utf8');
  const [open, close] = MARKS.map((mark) => readme.indexOf(mark));
  if (open === undefined || close === undefined || open < 0 || close < open)
    throw new Error('README.md has lost its marks for the bench');
  writeFileSync(file, readme.slice(0, open) + readmeFigures(results) + readme.slice(close + MARKS[1].length));
}
