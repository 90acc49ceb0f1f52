// @ts-check
// `npm run stress:report`: the contract as tables, from what tests/stress/results holds of each
// stack: REPORT.md here, and one sentence of the README between its markers. Nothing in them is
// typed by hand.

import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { readCommandLine, readResultFiles } from '../support/command-line.mjs';
import { table, writePart } from '../support/markdown.mjs';
import { repository } from '../support/repository.mjs';

const here = join(repository, 'tests/stress');
const USAGE = `
npm run stress:report -- [options]: writes REPORT.md and the README's sentence from the results
  --folder DIR   holds results/ and gets REPORT.md; default tests/stress. Another one leaves the README alone
  --help`;
const WORST = ['up', 'down', 'either'];

/**
 * @typedef {{ seed: number, broken: string[], checked: import('../glsl/chunk-checks.js').Checked[],
 * measured: import('./measure.js').Measured[] }} Result
 * @typedef {{ name: string, renderer: string, browser: string, contract:
 * import('../glsl/page/page.js').Report['contract'], loop?: string, drivers: Record<string, Result>
 * }} Stack
 */

/** What lies in a folder's results/, by name. @returns {Stack[]} */
export const readStacks = (folder = here) =>
  readResultFiles(join(folder, 'results'), 'npm run stress').map(({ name, content }) => ({
    name: name.replaceAll('-', ' '),
    ...content,
  }));

/**
 * The whole report.
 * @param {readonly Stack[]} stacks
 * @param {string} loop - the mark of the loop as it is now
 */
export function reportText(stacks, loop) {
  const names = [...stacks.map(({ name }) => name), 'worst drivers'];
  return `# How exact the light loop is: the measured contract

For people who need to know how far a pixel can be trusted. Written by \`npm run stress:report\` from tests/stress/results; do not edit. \`npm run stress -- --out
tests/stress/results/NAME.json\` measures a stack anew, from a new seed.

The shipped GLSL with the shipped packing, on fragments whose point and normal are given, against the equation in float64
(\`phong-viewer/reference\`). Errors are of the sum before clamping, in 1/255, over max(1, the sum of the lights'
intensities times the largest of Ka, Kd and Ks).

Inside a triangle a pixel differs from the equation by at most one 8-bit step where the bound times that product is below 1: ${brightness(stacks)}.
Under brighter lights it may differ by the bound times the product. Right at jumps of the equation itself, such as a cone's edge, it may be
on either side. Nothing is ever NaN. A curved shape is as round as its triangles: with \`segments="auto"\`, the default, its shading stays
within one step of the true shape's; with a number of segments it is what they are. A pixel on the seam of two triangles of a smooth face is
the mean of their parts, each extrapolated to its samples.

${summary(stacks)}

Points that a rasteriser interpolates are less exact. In pictures by SwiftShader of floors whose sides are 10 to 1,000 times the
eye's distance, under near lamps, up to 0.09 % of the channels are off by more than one code, by up to 46; at 10,000 times
1.7 % are. With multisampling, a triangle seen edge-on and narrower than about 1/16 of a pixel can win one
of a pixel's four samples by a depth extrapolated outside it: a single pixel then shows a quarter of what lies behind.

## Stacks

${stacksTable(stacks, loop)}

A *worst driver* is the same GLSL with each built-in function replaced by one that errs by all that the Vulkan specification
allows (exp2 3 + 2|x| ULP, log2 3 ULP or 2^-21 near 1, inversesqrt 2 ULP, division 2.5 ULP), always up, always down, or
either way by chance, and that gives NaN wherever the result is undefined.

## Categories

Largest error of each category on each stack, over all forms of programs that were measured there, and on the worst drivers of
all stacks. *Not measured here* is what came after a stack's run.

${table(
  ['category', 'bound', ...names, 'exact codes, least', 'left out'],
  rowsOf(stacks).map(({ title, bound, id }) => [
    title,
    String(bound),
    ...largestOfEach(stacks, ofCategory(id)),
    percent(Math.min(...withId(stacks, id).map((one) => exactShare([one])))),
    leftOut(stacks, id),
  ]),
)}

On all stacks and drivers together: ${total(stacks, 'notFinite')} channels NaN or infinite, ${total(stacks, 'wrongCodes')} 8-bit codes off by more than one (where lights are brighter than full: by more than the bound), of ${millions(total(stacks, 'channels'))} channels; exactly the nearest code
on at least ${percent(Math.min(...stacks.map((stack) => exactShare(ordinary(stack)))))} of the channels of the categories whose bound is ${leastBound(stacks)}, on every stack with its own driver. The farthest from a cone's edge that a
fragment was taken for one of the other side: ${digits(widestEdge(stacks, ['shipped']))} rad, on the worst drivers ${digits(widestEdge(stacks, WORST))} rad.

## Forms of programs

The largest error of each program that the viewer draws with, over the categories whose bound is ${leastBound(stacks)}. *general*: loops over any
number of lights; *counted*, *inlined* and *grid*: for exactly the lights at hand. \`SHININESS_IS_MILD\`: all exponents are at
most ${mildOf(stacks)}. \`INTEGER_SHININESS\`: a whole exponent to 64, multiplied out. Without chords and narrow
cones: no cone is within 15° of 0 or 180, and no cutoff below 1 or above 32. The harness reads at run time what these programs have as literals (feature masks, the
exponent); the sums of such programs with their literals are under *Chunks alone*.

${table(
  ['program', ...names],
  formNames(stacks).map((form) => [
    form.replace(/[A-Z_]{2,}/g, '`$&`'),
    ...largestOfEach(stacks, ofForm(form, leastBound(stacks))),
  ]),
)}

## What is left out

${leftOutText(stacks[0])}

## Chunks alone

Largest error of each function against its law in float64, on 16,384 inputs from all over its domain (the storages: every
number that they hold).

${table(
  ['what holds', 'bound', ...names],
  checksOf(stacks).map(({ title, bound }) => [
    title,
    String(bound),
    ...largestOfEach(stacks, ({ checked }) =>
      checked.filter((one) => one.title === title).map(({ max }) => max),
    ),
  ]),
)}
`;
}

/** @param {readonly Stack[]} stacks @param {string} loop */
function stacksTable(stacks, loop) {
  const cases = (/** @type {Stack} */ stack, /** @type {string} */ driver) =>
    total([stack], 'cases', [driver]) + total([stack], 'searched', [driver]);
  const head = ['stack', 'driver, as it names itself', 'browser', 'light loop', 'cases'];
  const rows = stacks.map((stack) => [
    stack.name,
    stack.renderer,
    /(Firefox|Chrome)\/(\d+)/.exec(stack.browser)?.slice(1, 3).join(' ') ?? stack.browser,
    stack.loop === loop ? 'as shipped' : 'an earlier one',
    millions(cases(stack, 'shipped')),
    millions(Math.min(...WORST.map((driver) => cases(stack, driver)))),
    [...new Set(Object.values(stack.drivers).map(({ seed }) => seed))].join(', '),
  ]);
  return table([...head, 'on each worst driver', 'seeds from'], rows);
}

/** The bounds and what was measured, in a few rows. @param {readonly Stack[]} stacks */
function summary(stacks) {
  const rows = rowsOf(stacks);
  const bounds = [...new Set(rows.map(({ bound }) => bound))].sort((a, b) => a - b);
  const groups = bounds.map((bound) => {
    const members = rows.filter((row) => row.bound === bound);
    const titles = members.map(({ title }) => title).join('; ');
    // The first bound is everybody's; what differs from it is named.
    const label = bound === bounds[0] ? `all else: ${members.length} categories` : titles;
    const over = (/** @type {readonly string[]} */ drivers) =>
      digits(Math.max(...members.map(({ id }) => largest(stacks, drivers, ofCategory(id)))));
    return [label, String(bound), over(['shipped']), over(WORST)];
  });
  return `${table(['', 'bound', 'largest measured', 'on the worst lawful driver'], groups.reverse())}

${fragments(stacks)}${formsText(stacks)}.

Every category holds constructed cases. ${climbed(stacks)}`;
}

/** The README's sentence, markers included. @param {readonly Stack[]} stacks */
export function readmeText(stacks) {
  const rows = rowsOf(stacks);
  const most = String(Math.max(...rows.map(({ bound }) => bound)));
  return `<!-- contract: written by npm run stress:report -->
Accuracy: inside triangles, before rounding, errors are below ${boundOf(stacks, 'mild-powers')} of an 8-bit step with shininess to ${mildOf(stacks)}
and cutoff to 10,000, and ${most} to 1e6, times lights and material where brighter than full ([report](tests/stress/REPORT.md)).
<!-- /contract -->`;
}

/** How much was measured. @param {readonly Stack[]} stacks */
const fragments = (stacks) =>
  `${millions(total(stacks, 'cases') + total(stacks, 'searched'))} fragments on ${stacks.length} stacks`;

/** On which stacks the largest errors were climbed to. @param {readonly Stack[]} stacks */
function climbed(stacks) {
  const searching = stacks.filter((stack) => total([stack], 'searched') > 0);
  const others = stacks.filter((stack) => !searching.includes(stack)).map(({ name }) => name);
  const found = `${millions(total(searching, 'searched'))} fragments on ${searching.map(({ name }) => name).join(', ')}`;
  const rest = others.length === 0 ? '' : `, not yet on ${others.join(', ')}`;
  return `From the worst ones of each category a search climbs further: it changes the
numbers that a case was made from a little, and goes on from the worst again (${found}${rest}).`;
}

/** @param {readonly Stack[]} stacks @param {string} id */
const boundOf = (stacks, id) => rowsOf(stacks).find((row) => row.id === id)?.bound;

/** LARGEST_MILD_POWER, as the category's title names it. @param {readonly Stack[]} stacks */
const mildOf = (stacks) =>
  /shininess to (\d+)/.exec(
    rowsOf(stacks).find(({ id }) => id === 'mild-powers')?.title ?? '',
  )?.[1];

/** Up to which product of lights and material one step is kept. @param {readonly Stack[]} stacks */
function brightness(stacks) {
  const limit = (/** @type {string} */ id) =>
    String(Math.floor(10 / (boundOf(stacks, id) ?? NaN)) / 10);
  return `up to ${limit('mild-powers')} times full with shininess to ${mildOf(stacks)} and cutoff to 10,000, ${limit('shininess-1e5')} to 1e5 and ${limit('shininess-1e6')} to 1e6`;
}

/**
 * All categories, in the order of the run that has most: an older stack may lack some.
 * @param {readonly Stack[]} stacks
 */
const rowsOf = (stacks) => {
  const lists = stacks.map(({ drivers }) => drivers['shipped']?.measured ?? []);
  return distinct(lists, ({ id }) => id).map((row) =>
    lists
      .flat()
      .reduce((most, one) => (one.id === row.id && one.bound > most.bound ? one : most), row),
  );
};

/** All checks of chunks that the newest loop has. @param {readonly Stack[]} stacks */
const checksOf = (stacks) => {
  const newest = Math.max(...stacks.map((stack) => formNames([stack]).length));
  return distinct(
    stacks
      .filter((stack) => formNames([stack]).length === newest)
      .map(({ drivers }) => drivers['shipped']?.checked ?? []),
    ({ title }) => title,
  );
};

/**
 * The items of all lists, each once; the longest list's first.
 * @template T
 * @param {readonly (readonly T[])[]} lists @param {(item: T) => string} keyOf @returns {T[]}
 */
function distinct(lists, keyOf) {
  const all = [...lists].sort((a, b) => b.length - a.length).flat();
  return all.filter((item, i) => all.findIndex((one) => keyOf(one) === keyOf(item)) === i);
}

/** What the stack's own driver made of the categories with the least bound. @param {Stack} stack */
const ordinary = (stack) =>
  measuredOf([stack], ['shipped']).filter(({ bound }) => bound === leastBound([stack]));

/** @param {readonly Stack[]} stacks */
const leastBound = (stacks) => Math.min(...rowsOf(stacks).map(({ bound }) => bound));

/** @param {readonly Stack[]} stacks @returns {string[]} */
export const formNames = (stacks) =>
  [...new Set(measuredOf(stacks).flatMap((one) => Object.keys(one.forms)))].sort();

/** Which stacks lack forms of programs. @param {readonly Stack[]} stacks */
function formsText(stacks) {
  const all = formNames(stacks).length;
  const fewer = stacks.filter((stack) => formNames([stack]).length < all);
  if (fewer.length === 0) return `, each through ${all} forms of programs`;
  const names = fewer.map((stack) => `${stack.name} (${formNames([stack]).length} of ${all})`);
  return `, through ${all} forms of programs; not yet all of them on ${names.join(', ')}`;
}

/** @param {readonly Stack[]} stacks @param {readonly string[]} [drivers] */
const resultsOf = (stacks, drivers) =>
  stacks.flatMap((stack) =>
    Object.entries(stack.drivers)
      .filter(([driver]) => drivers === undefined || drivers.includes(driver))
      .map(([, result]) => result),
  );

/** @param {readonly Stack[]} stacks @param {readonly string[]} [drivers] */
const measuredOf = (stacks, drivers) =>
  resultsOf(stacks, drivers).flatMap(({ measured }) => measured);

/**
 * What the stacks' own drivers made of a category. @param {readonly Stack[]} stacks @param {string}
 * id
 */
const withId = (stacks, id) => measuredOf(stacks, ['shipped']).filter((one) => one.id === id);

/** @typedef {(result: Result) => number[]} ErrorsOf */

/** @param {string} id @returns {ErrorsOf} */
const ofCategory =
  (id) =>
  ({ measured }) =>
    measured.filter((one) => one.id === id).map(({ max }) => max);

/**
 * Over the categories with this bound. @param {string} form @param {number} least @returns
 * {ErrorsOf}
 */
const ofForm =
  (form, least) =>
  ({ measured }) =>
    measured.filter(({ bound }) => bound === least).map((one) => one.forms[form] ?? -Infinity);

/**
 * @param {readonly Stack[]} stacks @param {readonly string[]} drivers @param {ErrorsOf} errorsOf
 */
const largest = (stacks, drivers, errorsOf) =>
  Math.max(...resultsOf(stacks, drivers).flatMap(errorsOf));

/**
 * Cells: each stack's own driver, then the worst drivers of all. @param {readonly Stack[]} stacks
 * @param {ErrorsOf} errorsOf
 */
const largestOfEach = (stacks, errorsOf) =>
  [
    ...stacks.map((stack) => largest([stack], ['shipped'], errorsOf)),
    largest(stacks, WORST, errorsOf),
  ].map((error) => (error === -Infinity ? 'not measured here' : digits(error)));

/** @param {readonly import('./measure.js').Measured[]} list */
const exactShare = (list) => sum(list, 'exact') / sum(list, 'channels');

/** @param {readonly Stack[]} stacks @param {readonly string[]} drivers */
const widestEdge = (stacks, drivers) =>
  Math.max(...measuredOf(stacks, drivers).map(({ edge }) => edge));

/**
 * @param {readonly Stack[]} stacks @param {'notFinite' | 'wrongCodes' | 'channels' | 'cases' |
 * 'searched'} key
 * @param {readonly string[]} [drivers]
 */
const total = (stacks, key, drivers) => sum(measuredOf(stacks, drivers), key);

/**
 * @template {string} K
 * @param {readonly Record<K, number>[]} list @param {K} key
 */
const sum = (list, key) => list.reduce((before, one) => before + (one[key] ?? 0), 0);

/**
 * Shares of a category's cases beside a branch point. @param {readonly Stack[]} stacks @param
 * {string} id
 */
function leftOut(stacks, id) {
  const all = withId(stacks, id);
  const cases = sum(all, 'cases');
  /** @type {Record<string, number>} */
  const counts = {};
  for (const { excluded } of all) {
    for (const [name, count] of Object.entries(excluded)) {
      counts[name] = (counts[name] ?? 0) + count;
    }
  }
  return Object.entries(counts)
    .filter(([, count]) => count / cases >= 5e-5)
    .map(([name, count]) => `${name} ${percent(count / cases, 2)}`)
    .join(', ');
}

/** @param {Stack | undefined} stack */
function leftOutText(stack) {
  if (stack === undefined) return '';
  const { branches, edge } = stack.contract;
  return `Beside points where the equation itself jumps or is infinitely steep, or where the float32 input no longer tells what
was meant, only finite numbers are promised:

- *edge*: nearer to a cone's edge than ${exponent(edge)} rad;
- *gate*: |N·L| below ${exponent(branches.gate)}, where the specular term begins;
- *lobe*: |R·V| or |N·H| below ${exponent(branches.lobe)} with shininess below 1;
- *back*: nearer than ${exponent(branches.back)} rad to straight behind a spot with cutoff below 1;
- *near*: a light at less than ${exponent(branches.near)} of the largest coordinate in shading space, but not within 1e-15;
- *half*: with Blinn's lobe, that share (at most 1) times |L + V| below ${exponent(branches.half)}, but |L + V| not 0: light and
  eye opposite each other;
- *normal*: an interpolated normal shorter than 2^${Math.log2(branches.normal)}, but not zero.`;
}

/** Two digits, and none after a zero. @param {number} x */
function digits(x) {
  if (!Number.isFinite(x)) return '–';
  if (x === 0) return '0';
  return x < 1e-3 ? exponent(Number(x.toPrecision(2))) : String(Number(x.toPrecision(2)));
}

/** @param {number} x */
const exponent = (x) => x.toExponential().replace('e+', 'e');

/** Rounded down: "at least". @param {number} share */
function percent(share, places = 4) {
  const scale = 10 ** places;
  return `${Math.floor(share * 100 * scale) / scale} %`;
}

/** @param {number} count */
const millions = (count) =>
  count >= 1e6 ? `${Math.floor(count / 1e5) / 10} million` : count.toLocaleString('en-GB');

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const { values } = readCommandLine(USAGE, { folder: { type: 'string', default: here } });
  const stacks = readStacks(values.folder);
  const { runnerImport } = await import('vite');
  /** @type {{ module: typeof import('../glsl/loop-mark.js') }} */
  const { module } = await runnerImport(join(repository, 'tests/glsl/loop-mark.ts'));
  const report = reportText(stacks, module.LOOP_MARK);
  writeFileSync(join(values.folder, 'REPORT.md'), report);
  if (values.folder === here) {
    writePart(readmeText(stacks));
  }
  console.log(`REPORT.md from ${stacks.length} stacks`);
}
