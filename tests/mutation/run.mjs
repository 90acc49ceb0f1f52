// @ts-check
// `npm run mutation`: makes every mutant of mutants.mjs in turn, never in the working tree, and looks for the test that fails.
// GLSL goes through the stress harness in a browser; TypeScript through the unit tests that concern it, and then through a
// harness built with it. A mutant that lives is a failure. Writes results.json and TABLE.md.
//
//   npm run mutation -- --only power.glsl   (a part of names: the results of all others stay as they are)
//   npm run mutation -- --new   (those alone that no test is known to kill)
//   npm run mutation -- --quick   (few cases; only prints)

import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { startHarness } from './harness.mjs';
import { mutated, MUTANTS, nameOf, UNIT_TESTS } from './mutants.mjs';
import { table } from './table.mjs';
import { failingUnitTest } from './unit-tests.mjs';

/** @typedef {{ name: string, file: string, removes: string, killedBy: string | null }} Result */

const { values: options } = parseArgs({
  options: {
    only: { type: 'string', default: '' },
    new: { type: 'boolean', default: false },
    quick: { type: 'boolean', default: false },
  },
});
const repository = fileURLToPath(new URL('../..', import.meta.url));
const here = join(repository, 'tests/mutation');
process.chdir(repository);

const killed = options.new ? resultsBefore().filter(({ killedBy }) => killedBy !== null) : [];
const known = new Set(killed.map(({ name }) => name));
const chosen = MUTANTS.map((mutant) => ({ mutant, name: nameOf(mutant) }))
  .filter(({ name }) => name.includes(options.only) && !known.has(name))
  .map(({ mutant }) => mutant);
for (const mutant of chosen) mutated(readFileSync(mutant.file, 'utf8'), mutant);

const start = performance.now();
const harness = await startHarness(options.quick);
await checkThatTheCodeItselfPasses();
/** @type {Result[]} */
const results = [];
for (const mutant of chosen) {
  const { file, removes } = mutant;
  const before = performance.now();
  const killedBy = await killer(mutant);
  const seconds = ((performance.now() - before) / 1000).toFixed(1);
  results.push({ name: nameOf(mutant), file, removes, killedBy });
  console.log(
    `${killedBy === null ? 'LIVES ' : 'killed'} ${seconds.padStart(5)} s  ${nameOf(mutant)}  ← ${killedBy}`,
  );
}
await harness.close();

if (!options.quick) {
  const all = [...results, ...keptResults()].sort((a, b) => (a.name < b.name ? -1 : 1));
  writeFileSync(join(here, 'results.json'), `${JSON.stringify(all, null, 2)}\n`);
  writeFileSync(join(here, 'TABLE.md'), table(all));
}
const living = results.filter(({ killedBy }) => killedBy === null);
const minutes = ((performance.now() - start) / 60_000).toFixed(1);
console.log(`\n${results.length - living.length} of ${results.length} killed in ${minutes} min`);
for (const { name } of living) console.log(`LIVES: ${name}`);
process.exit(living.length > 0 ? 1 : 0);

/** What was found before of mutants that still are, and were not made this time. @returns {Result[]} */
function keptResults() {
  const others = new Set(MUTANTS.filter((mutant) => !chosen.includes(mutant)).map(nameOf));
  if (others.size === 0) return [];
  return resultsBefore().filter(({ name }) => others.has(name));
}

/** @returns {Result[]} */
function resultsBefore() {
  return JSON.parse(readFileSync(join(here, 'results.json'), 'utf8'));
}

/** A test that fails anyway kills nothing. */
async function checkThatTheCodeItselfPasses() {
  const broken = await harness.glsl(null);
  if (broken !== null) throw new Error(`${broken.sentence} (${broken.driver}), with nothing removed`);
  const files = new Set(chosen.map(({ file }) => file));
  for (const names of new Set([...files].map((file) => UNIT_TESTS[file] ?? []))) {
    const failing = names.length === 0 ? null : await failingUnitTest(null, names);
    if (failing !== null) throw new Error(`${failing}, with nothing removed`);
  }
}

/** @param {import('./mutants.mjs').Mutant} mutant @returns {Promise<string | null>} */
async function killer(mutant) {
  if (mutant.file.endsWith('.glsl')) return stress(await harness.glsl(mutant));
  const unit = await failingUnitTest(mutant, UNIT_TESTS[mutant.file] ?? []);
  return unit ?? stress(await harness.typescript(mutant));
}

/** @param {import('./harness.mjs').Broken | null} broken */
function stress(broken) {
  if (broken === null) return null;
  const driver =
    broken.driver === 'shipped' ? 'the browser’s driver' : `the worst driver, erring ${broken.driver}`;
  return `stress › ${broken.sentence} (${driver})`;
}
