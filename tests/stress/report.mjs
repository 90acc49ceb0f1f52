// @ts-check
// `npm run stress:report`: the contract as tables, from what tests/stress/results holds of each stack: REPORT.md here,
// and one sentence of the README between its markers. Nothing in them is typed by hand.

import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { readCommandLine, readResultFiles } from '../support/command-line.mjs';
import { table, writePart } from '../support/markdown.mjs';

const repository = fileURLToPath(new URL('../..', import.meta.url));
const here = join(repository, 'tests/stress');
const USAGE = `
npm run stress:report -- [options]: writes REPORT.md and the README's sentence from the results
  --folder DIR   holds results/ and gets REPORT.md; default tests/stress. Another one leaves the README alone
  --help`;
const WORST = ['up', 'down', 'either'];

/**
 * @typedef {{ seed: number, broken: string[], checked: import('../glsl/chunk-checks.js').Checked[], measured:
 * import('./measure.js').Measured[] }} Result
 * @typedef {{ name: string, renderer: string, browser: string, contract:
 * import('../glsl/page/page.js').Report['contract'], loop?: string, drivers: Record<string, Result> }} Stack
 * @typedef {{ scenes: number, table: { segments: number, rmse: number, percentile999: number, max: number }[] }}
 * Tessellation
 */

/** How far drawn spheres are from ideal ones. @returns {Tessellation} */
export const readTessellation = () =>
  JSON.parse(readFileSync(join(repository, 'tests/visual/tessellation.json'), 'utf8'));

/** What lies in a folder's results/, by name. @returns {Stack[]} */
export const readStacks = (folder = here) =>
  readResultFiles(join(folder, 'results'), 'npm run stress').map(({ name, content }) => ({
    name: name.replaceAll('-', ' '),
    ...content,
  }));

/**
 * The whole report.
 * @param {readonly Stack[]} stacks
 * @param {Tessellation} tessellation
 * @param {string} loop - the mark of the loop as it is now
 */
export function reportText(stacks, tessellation, loop) {
  return `# How exact the light loop is: the measured contract

For people who need to know how far a pixel can be trusted. Written by \`npm run stress:report\` from tests/stress/results; do not edit. \`npm run stress -- --out
tests/stress/results/NAME.json\` measures a stack anew, from a new seed.

The shipped GLSL with the shipped packing, on fragments whose point and normal are given, against the equation in float64
(\`phong-viewer/reference\`). Errors are of the sum before clamping, in 1/255, over max(1, the sum of the lights'
intensities times the largest of Ka, Kd and Ks).

For every value that an attribute accepts, a pixel inside a face differs from the equation by at most one 8-bit step, except
right at jumps of the equation itself, such as a cone's edge. Nothing is ever NaN. The largest error is elsewhere: a curved shape
is only as round as its triangles ([figures for spheres](#curved-shapes)).

${summary(stacks)}

Points that a rasteriser interpolates are less exact. In pictures by SwiftShader of floors whose sides are 10 to 1,000 times the
eye's distance, under near lamps, up to 0.09 % of the channels are off by more than one code, by up to 46; at 10,000 times
1.7 % are. With multisampling, a triangle seen edge-on and narrower than about 1/16 of a pixel can win one
of a pixel's four samples by a depth extrapolated outside it: a single pixel inside a face then shows a quarter of what lies behind.

## Stacks

${table(
  [
    'stack',
    'driver, as it names itself',
    'browser',
    'light loop',
    'cases',
    'on each worst driver',
    'seeds from',
  ],
  stacks.map((stack) => [
    stack.name,
    stack.renderer,
    browserName(stack.browser),
    stack.loop === loop ? 'as shipped' : 'an earlier one',
    millions(casesOf(stack, ['shipped'])),
    millions(Math.min(...WORST.map((driver) => casesOf(stack, [driver])))),
    [...new Set(Object.values(stack.drivers).map(({ seed }) => seed))].join(', '),
  ]),
)}

A *worst driver* is the same GLSL with each built-in function replaced by one that errs by all that the Vulkan specification
allows (exp2 3 + 2|x| ULP, log2 3 ULP or 2^-21 near 1, inversesqrt 2 ULP, division 2.5 ULP), always up, always down, or
either way by chance, and that gives NaN wherever the result is undefined.

## Categories

Largest error of each category on each stack, over all forms of programs that were measured there, and on the worst drivers of
all stacks. *Not measured here* is what came after a stack's run.

${table(
  ['category', 'bound', ...stacks.map(({ name }) => name), 'worst drivers', 'exact codes, least', 'left out'],
  rowsOf(stacks).map(({ title, bound, id }) => [
    title,
    String(bound),
    ...stacks.map((stack) => measured(largest([stack], id, ['shipped']))),
    measured(largest(stacks, id, WORST)),
    percent(leastExact(stacks, id)),
    leftOut(stacks, id),
  ]),
)}

On all stacks and drivers together: ${String(total(stacks, 'notFinite'))} channels NaN or infinite, ${String(
    total(stacks, 'wrongCodes'),
  )} 8-bit codes off by more than one (where lights are brighter than full: by more than the bound), of ${millions(total(stacks, 'channels'))} channels; exactly the nearest code
on at least ${percent(Math.min(...stacks.map(exactOfAll)))} of the channels of every stack with its own driver. The farthest from a cone's edge that a
fragment was taken for one of the other side: ${digits(widestEdge(stacks, ['shipped']))} rad, on the worst drivers ${digits(widestEdge(stacks, WORST))} rad.

## Forms of programs

The largest error of each program that the viewer draws with, over the categories whose bound is ${String(leastBound(stacks))}. *general*: loops over any
number of lights; *counted*, *inlined* and *grid*: for exactly the lights at hand. \`SHININESS_IS_MILD\`: all exponents are at
most 200. \`INTEGER_SHININESS\`: a whole exponent to 64, multiplied out. Without chords and narrow
cones: no cone is within 15° of 0 or 180, and no cutoff below 1 or above 32. The harness reads at run time what these programs have as literals (feature masks, the
exponent); the sums of such programs with their literals are under *Chunks alone*.

${table(
  ['program', ...stacks.map(({ name }) => name), 'worst drivers'],
  formNames(stacks).map((form) => [
    formTitle(form),
    ...stacks.map((stack) => measured(largestOfForm([stack], form, ['shipped']))),
    measured(largestOfForm(stacks, form, WORST)),
  ]),
)}

## What is left out

${leftOutText(stacks[0])}

## Chunks alone

Largest error of each function against its law in float64, on 16,384 inputs from all over its domain (the storages: every
number that they hold).

${table(
  ['what holds', 'bound', ...stacks.map(({ name }) => name), 'worst drivers'],
  checksOf(stacks).map(({ title, bound }) => [
    title,
    String(bound),
    ...stacks.map((stack) => measured(largestCheck([stack], title, ['shipped']))),
    measured(largestCheck(stacks, title, WORST)),
  ]),
)}

## Curved shapes

Beside arithmetic, a curved mesh differs from the shape that it stands for. A sphere as it is drawn against the ideal
one, both in float64, in 8-bit codes, over ${String(tessellation.scenes)} random scenes (tests/visual/sphere.spec.ts;
\`UPDATE_PICTURES=1\` records it anew):

${table(
  ['segments', 'RMSE', '99.9 % within', 'largest'],
  tessellation.table.map(({ segments, rmse, percentile999, max }) => [
    String(segments),
    digits(rmse),
    digits(percentile999),
    digits(max),
  ]),
)}

`;
}

/** The bounds and what was measured, in a few rows. @param {readonly Stack[]} stacks */
function summary(stacks) {
  const rows = rowsOf(stacks);
  const bounds = [...new Set(rows.map(({ bound }) => bound))].sort((a, b) => a - b);
  const groups = bounds.map((bound) => ({ bound, members: rows.filter((row) => row.bound === bound) }));
  const over = (/** @type {readonly { id: string }[]} */ members, /** @type {readonly string[]} */ drivers) =>
    digits(Math.max(...members.map(({ id }) => largest(stacks, id, drivers))));
  return `${table(
    ['', 'bound', 'largest measured', 'on the worst lawful driver'],
    groups
      .map(({ bound, members }) => [
        // The first bound is everybody's; what differs from it is named.
        bound === bounds[0]
          ? `all else: ${String(members.length)} categories`
          : members.map(({ title }) => title).join('; '),
        String(bound),
        over(members, ['shipped']),
        over(members, WORST),
      ])
      .reverse(),
  )}

${millions(total(stacks, 'cases'))} fragments on ${String(stacks.length)} stacks${formsText(stacks)}.`;
}

/** The README's sentence, markers included. @param {readonly Stack[]} stacks */
export function readmeText(stacks) {
  const worst = Math.max(...rowsOf(stacks).map(({ id }) => largest(stacks, id, ['shipped'])));
  return `<!-- contract: written by npm run stress:report -->
Accuracy: of ${millions(total(stacks, 'cases'))} measured fragments on ${String(stacks.length)} stacks none is further from the equation in double precision than ${digits(worst)} of an
8-bit step ([report](tests/stress/REPORT.md)).
<!-- /contract -->`;
}

/**
 * All categories, in the order of the run that has most: an older stack may lack some.
 * @param {readonly Stack[]} stacks
 */
const rowsOf = (stacks) =>
  distinct(
    stacks.map(({ drivers }) => drivers['shipped']?.measured ?? []),
    ({ id }) => id,
  ).map((row) =>
    stacks
      .flatMap(({ drivers }) => drivers['shipped']?.measured ?? [])
      .reduce((most, one) => (one.id === row.id && one.bound > most.bound ? one : most), row),
  );

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
  /** @type {Map<string, T>} */
  const items = new Map();
  for (const list of [...lists].sort((a, b) => b.length - a.length))
    for (const item of list) if (!items.has(keyOf(item))) items.set(keyOf(item), item);
  return [...items.values()];
}

/** @param {readonly Stack[]} stacks */
const leastBound = (stacks) => Math.min(...rowsOf(stacks).map(({ bound }) => bound));

/**
 * The largest error of each program by its name. Stacks without it were measured when the harness had one program,
 * which takes any lights and exponents.
 * @param {Pick<import('./measure.js').Measured, 'max'> & { forms?: Readonly<Record<string, number>> }} category
 * @returns {Readonly<Record<string, number>>}
 */
const formsOf = ({ forms, max }) => forms ?? { general: max };

/** @param {readonly Stack[]} stacks @returns {string[]} */
export const formNames = (stacks) =>
  [
    ...new Set(
      resultsOf(stacks).flatMap(({ measured }) => measured.flatMap((one) => Object.keys(formsOf(one)))),
    ),
  ].sort();

/** @param {string} form */
const formTitle = (form) => form.replace(/[A-Z_]{2,}/g, '`$&`');

/** @param {readonly Stack[]} stacks @param {string} form @param {readonly string[]} drivers */
const largestOfForm = (stacks, form, drivers) => {
  const least = leastBound(stacks);
  return Math.max(
    ...resultsOf(stacks, drivers).flatMap(({ measured }) =>
      measured.filter(({ bound }) => bound === least).map((one) => formsOf(one)[form] ?? -Infinity),
    ),
  );
};

/** Which stacks lack forms of programs. @param {readonly Stack[]} stacks */
function formsText(stacks) {
  const all = formNames(stacks).length;
  const fewer = stacks.filter((stack) => formNames([stack]).length < all);
  if (fewer.length === 0) return `, each through ${String(all)} forms of programs`;
  const names = fewer.map(
    (stack) => `${stack.name} (${String(formNames([stack]).length)} of ${String(all)})`,
  );
  return `, through ${String(all)} forms of programs; not yet all of them on ${names.join(', ')}`;
}

/** @param {readonly Stack[]} stacks @param {readonly string[]} [drivers] */
const resultsOf = (stacks, drivers) =>
  stacks.flatMap((stack) =>
    Object.entries(stack.drivers)
      .filter(([driver]) => drivers === undefined || drivers.includes(driver))
      .map(([, result]) => result),
  );

/** @param {readonly Stack[]} stacks @param {string} id @param {readonly string[]} [drivers] */
const ofCategory = (stacks, id, drivers) =>
  resultsOf(stacks, drivers).flatMap(({ measured }) => measured.filter((one) => one.id === id));

/** @param {readonly Stack[]} stacks @param {string} id @param {readonly string[]} drivers */
const largest = (stacks, id, drivers) => Math.max(...ofCategory(stacks, id, drivers).map(({ max }) => max));

/** @param {readonly Stack[]} stacks @param {string} title @param {readonly string[]} drivers */
const largestCheck = (stacks, title, drivers) =>
  Math.max(
    ...resultsOf(stacks, drivers).flatMap(({ checked }) =>
      checked.filter((one) => one.title === title).map(({ max }) => max),
    ),
  );

/** @param {readonly Stack[]} stacks @param {string} id */
const leastExact = (stacks, id) =>
  Math.min(...ofCategory(stacks, id, ['shipped']).map(({ exact, channels }) => exact / channels));

/** @param {Stack} stack */
const exactOfAll = (stack) => {
  const all = resultsOf([stack], ['shipped']).flatMap(({ measured }) => measured);
  return sum(all, 'exact') / sum(all, 'channels');
};

/** @param {readonly Stack[]} stacks @param {readonly string[]} drivers */
const widestEdge = (stacks, drivers) =>
  Math.max(...resultsOf(stacks, drivers).flatMap(({ measured }) => measured.map(({ edge }) => edge)));

/** @param {Stack} stack @param {readonly string[]} drivers */
const casesOf = (stack, drivers) =>
  sum(
    resultsOf([stack], drivers).flatMap(({ measured }) => measured),
    'cases',
  );

/** @param {readonly Stack[]} stacks @param {'notFinite' | 'wrongCodes' | 'channels' | 'cases'} key */
const total = (stacks, key) =>
  sum(
    resultsOf(stacks).flatMap(({ measured }) => measured),
    key,
  );

/**
 * @template {string} K
 * @param {readonly Record<K, number>[]} list @param {K} key
 */
const sum = (list, key) => list.reduce((before, one) => before + one[key], 0);

/** Shares of a category's cases beside a branch point. @param {readonly Stack[]} stacks @param {string} id */
function leftOut(stacks, id) {
  const all = ofCategory(stacks, id, ['shipped']);
  const cases = sum(all, 'cases');
  /** @type {Record<string, number>} */
  const counts = {};
  for (const { excluded } of all)
    for (const [name, count] of Object.entries(excluded)) counts[name] = (counts[name] ?? 0) + count;
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
- *normal*: an interpolated normal shorter than 2^${String(Math.log2(branches.normal))}, but not zero.`;
}

/** The largest of what was measured, which may be nothing. @param {number} x */
const measured = (x) => (x === -Infinity ? 'not measured here' : digits(x));

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
  return `${String(Math.floor(share * 100 * scale) / scale)} %`;
}

/** @param {number} count */
const millions = (count) =>
  count >= 1e6 ? `${String(Math.floor(count / 1e5) / 10)} million` : count.toLocaleString('en-GB');

/** @param {string} agent */
const browserName = (agent) => /(Firefox|Chrome)\/(\d+)/.exec(agent)?.slice(1, 3).join(' ') ?? agent;

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const { values } = readCommandLine(USAGE, { folder: { type: 'string', default: here } });
  const stacks = readStacks(values.folder);
  const { runnerImport } = await import('vite');
  /** @type {{ module: typeof import('../glsl/loop-mark.js') }} */
  const { module } = await runnerImport(join(repository, 'tests/glsl/loop-mark.ts'));
  const report = reportText(stacks, readTessellation(), module.LOOP_MARK);
  writeFileSync(join(values.folder, 'REPORT.md'), report);
  if (values.folder === here) writePart(readmeText(stacks));
  console.log(`REPORT.md from ${String(stacks.length)} stacks`);
}
