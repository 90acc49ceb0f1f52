// @ts-check
// `npm run mutation`: do the tests notice wrong code? Makes wrong versions of the sources, runs the
// tests on each, and compares the share that some test kills with the recorded one in scores.json.
// Fails where a folder's score has fallen.

import { writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { fileURLToPath } from 'node:url';
import {
  numberOption,
  Progress,
  readCommandLine,
  readJson,
  refuse,
  timeText,
} from '../support/command-line.mjs';
import { chunks, mutantsOf, runGlsl } from './glsl.mjs';

/**
 * @typedef {import('./typescript.mjs').Result} Result
 * @typedef {{ score: number, killed: number, mutants: number, notCompiled: number }} Score score:
 * percent killed of those that compile
 */

/**
 * Each folder's files; those of `shaders` are listed by glsl.mjs. @type {Record<string, readonly
 * string[]>}
 */
const FOLDERS = {
  math: ['src/phong/math/**/*.ts'],
  fields: ['src/phong/fields/**/*.ts'],
  light: ['src/phong/light/**/*.ts'],
  reference: ['src/phong/reference/**/*.ts'],
  camera: ['src/phong/camera/**/*.ts'],
  parser: ['src/phong/fields/attribute-text.ts'],
  shaders: [],
};

const USAGE = `
npm run mutation -- [options]: do the tests notice wrong code?
  --folder NAME   only this folder, may be given again: ${Object.keys(FOLDERS).join(', ')}
  --sample N      about N mutants, drawn by --seed, shared among the folders by their size
  --seed S        of the sample; a new one otherwise
  --only TEXT     of the shaders, only mutants with this text in their names, such as spot.glsl:12
  --jobs N        processes at a time; all cores but one otherwise
  --record        writes what was measured to tests/mutation/scores.json
  --list          prints each survivor with its place
  --help`;

process.chdir(fileURLToPath(new URL('../..', import.meta.url)));
const file = 'tests/mutation/scores.json';
const { values: options } = readCommandLine(USAGE, {
  folder: { type: 'string', multiple: true, default: Object.keys(FOLDERS) },
  sample: { type: 'string', default: '0' },
  seed: { type: 'string', default: String(Math.floor(Math.random() * 2 ** 31)) },
  only: { type: 'string', default: '' },
  jobs: { type: 'string', default: String(Math.max(1, availableParallelism() - 1)) },
  record: { type: 'boolean', default: false },
  list: { type: 'boolean', default: false },
});
const unknown = options.folder.find((name) => !(name in FOLDERS));
if (unknown !== undefined) {
  refuse(`Unknown folder '${unknown}'`);
}
const sample = numberOption('sample', options.sample);
const seed = numberOption('seed', options.seed);
const jobs = numberOption('jobs', options.jobs, 1);

/** @type {Record<string, Score>} */
const recorded = readJson(file);
const start = performance.now();
if (sample > 0) {
  console.log(`A sample of about ${sample} mutants, seed ${seed}`);
}

const results = [...(await typeScriptResults()), ...(await glslResults())];
if (options.list) {
  for (const { name, status } of results) {
    if (status === 'survived') {
      console.log(`survived: ${name}`);
    }
  }
}
/** @type {Record<string, Score>} */
const measured = {};
let fell = false;
for (const folder of options.folder) {
  const score = scoreOf(results.filter(({ name }) => isIn(folder, name)));
  measured[folder] = score;
  const before = recorded[folder];
  const worse = before !== undefined && hasFallen(score, before);
  fell ||= worse;
  console.log(
    `${folder.padEnd(10)} ${score.score.toFixed(1)} % of ${score.mutants} killed` +
      (score.notCompiled > 0 ? `, ${score.notCompiled} more did not compile` : '') +
      (before === undefined
        ? ''
        : `; recorded: ${before.score.toFixed(1)} % of ${before.mutants}`) +
      (worse ? '  FALLEN' : ''),
  );
}
console.log(`${results.length} mutants in ${timeText((performance.now() - start) / 1000)}`);
if (options.record) {
  // Read again: another folder's run may have written since this one began.
  const all = Object.entries({ ...readJson(file), ...measured }).sort(([a], [b]) =>
    a < b ? -1 : 1,
  );
  writeFileSync(file, `${JSON.stringify(Object.fromEntries(all), null, 2)}\n`);
}
process.exit(fell && !options.record ? 1 : 0);

async function typeScriptResults() {
  const files = options.folder.flatMap((folder) => FOLDERS[folder] ?? []);
  if (files.length === 0) return [];
  // Loading StrykerJS takes seconds, which --help need not wait for.
  const { runTypeScript } = await import('./typescript.mjs');
  return runTypeScript({ files, share: share(), seed, jobs });
}

async function glslResults() {
  if (!options.folder.includes('shaders')) return [];
  /**
   * Begins with the first result: starting browsers says nothing about the pace. @type {Progress |
   * undefined}
   */
  let progress;
  const { results, notRun } = await runGlsl({
    sample: sample === 0 ? 0 : Math.ceil(share() * sizeOf('shaders')),
    seed,
    jobs,
    only: options.only,
    onResult: (name, done, total) => {
      progress ??= new Progress();
      progress.show(done, total, name);
    },
  });
  progress?.clear();
  if (notRun.length > 0) {
    console.log(`Not mutated, no check runs them alone: ${notRun.join(', ')}`);
  }
  return results;
}

/** The sample's share of all mutants in the chosen folders. */
function share() {
  if (sample === 0) return 1;
  return Math.min(1, sample / options.folder.reduce((sum, folder) => sum + sizeOf(folder), 0));
}

/** Mutants of a folder: counted for shaders, as recorded for the others. @param {string} folder */
function sizeOf(folder) {
  if (folder === 'shaders') return chunks().flatMap(mutantsOf).length;
  return recorded[folder]?.mutants ?? 300;
}

/** @param {string} folder @param {string} name */
function isIn(folder, name) {
  const places = (FOLDERS[folder] ?? []).map((pattern) => pattern.replace('**/*.ts', ''));
  return folder === 'shaders'
    ? name.startsWith('shaders/')
    : places.some((place) => name.startsWith(place));
}

/** @param {readonly Result[]} list @returns {Score} */
function scoreOf(list) {
  const count = (/** @type {Result['status']} */ wanted) =>
    list.filter(({ status }) => status === wanted).length;
  const [killed, notCompiled] = [count('killed'), count('did not compile')];
  const mutants = list.length - notCompiled;
  // Rounded down: what is recorded was reached.
  const score = mutants === 0 ? 100 : Math.floor((1000 * killed) / mutants) / 10;
  return { score, killed, mutants, notCompiled };
}

/** Of a sample three standard deviations are let pass. @param {Score} now @param {Score} before */
function hasFallen(now, before) {
  if (sample === 0) return now.score < before.score;
  const expected = (before.killed / before.mutants) * now.mutants;
  const deviation = Math.sqrt((expected * (now.mutants - expected)) / Math.max(now.mutants, 1));
  return now.killed < expected - 3 * deviation - 1;
}
