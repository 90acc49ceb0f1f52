// @ts-check
// `npm run bench:report`: writes REPORT.md, charts/ and the README's sentence from all results.
// Nothing in them is typed by hand.

import { existsSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { readCommandLine, readResultFiles } from '../support/command-line.mjs';
import { escaped, table, writePart } from '../support/markdown.mjs';
import { ACCURACY_HEAD, accuracyRows, accuracySentence, placeOf } from './accuracy-words.mjs';
import { AIMS, judge, stackKind } from './aims.mjs';
import { MODELS } from './models.mjs';
import { accuracyFile, picturesChart } from './picture-chart.mjs';
import {
  PLAIN,
  FULL,
  full,
  MULTISAMPLED,
  pictureTime,
  pictureValue,
  CODES,
  RMSE,
  ssaa,
  taa,
  WITHIN,
} from './pictures.mjs';
import {
  ratioOf,
  ratioOverSubjects,
  ratioToBest,
  readResults,
  rowOf,
  valueOf,
} from './results.mjs';
import {
  modelSubject,
  modelSubjects,
  NETWORKS,
  PICTURES,
  pictureSubject,
  SUBJECTS,
} from './subjects.mjs';

/** @typedef {import('./results.mjs').BenchResult} BenchResult */

const here = fileURLToPath(new URL('.', import.meta.url));

const USAGE = `
npm run bench:report -- [options]: writes REPORT.md, its charts and the README's sentence from the results
  --folder DIR   holds results/ and accuracy/, and gets REPORT.md and charts/; default tests/bench. Another one leaves the README alone
  --help`;

/** @typedef {{ stack: string, accuracy: import('./accuracy-words.mjs').Accuracy }} MeasuredAccuracy */

/** What node tests/bench/accuracy.mjs has measured. @param {string} folder @returns {MeasuredAccuracy[]} */
export const readAccuracies = (folder) =>
  existsSync(folder)
    ? readResultFiles(folder, 'node tests/bench/accuracy.mjs').map(({ name, content }) => ({
        stack: name,
        accuracy: content,
      }))
    : [];

/** The checks that the report begins with, by their labels. */
export const TEN = [
  'sphere, 8 lights, first frames',
  'sphere, 8 lights, settled',
  'sphere, 32 lights, settled',
  'sphere, 128 lights, settled',
  'sphere, 8 lights, longest frame over usual',
  '64 samples of a sphere, 760 × 420, ms from the change',
  'start, standalone',
  'heap, standalone',
  "first picture of models against three's page, GLB of 1 MB",
  'bytes, standalone',
];

/**
 * @param {readonly BenchResult[]} results @param {readonly MeasuredAccuracy[]} accuracies
 * @returns {{ report: string, charts: Map<string, string> }}
 */
export function reportOf(results, accuracies) {
  /** @type {Map<string, string>} */
  const charts = new Map();
  const plots = accuracies.map(({ stack, accuracy }) => {
    const file = `${stack}-accuracy.svg`;
    charts.set(file, accuracyFile(accuracy, PLOT_WIDTH));
    const sentence = accuracySentence(accuracy, placeOf(stack));
    return `${sentence}\n\n![${stack}: time of a frame against the largest error](charts/${file})`;
  });
  const pictures = results.flatMap((result) => {
    const svg = picturesChart(result);
    if (svg === undefined) return [];
    const file = `${result.stack}-pictures.svg`;
    charts.set(file, svg);
    return [`![${result.stack}: pictures](charts/${file})`];
  });
  const all = aimsTable(results);
  const report = `# What the bench measured

For people who ask what a picture costs. Written by \`npm run bench:report\` from \`results/\` and \`accuracy/\`.

## What does accuracy cost?

Six programs draw one scene of three lights in turns: the plain loop of textbooks, that of phong-viewer, and usual shortcuts. Left is fast, low is exact. The error is the
largest of a picture against the equation in float64, before rounding to a colour's 256 steps; in the grey band nobody can see it. Larger dots are higher exponents *n* of the
highlight: 32, 1,000, 100,000. The page of the bench measures the same on your machine; \`node tests/bench/accuracy.mjs --help\` does on a named one.

${plots.join('\n\n') || 'Not measured yet.'}

## In ten rows

Ratios are to plain three.js with MeshPhongMaterial on a canvas with the same
attributes: below 1 is less than it takes. ✗ misses a limit, which fails the nightly bench, or an aim that is not reached yet. They are measured in turns in the same browser: the median of the rounds' ratios, with quartiles in brackets. Frame times are the
GPU's own, in software the CPU time of the GPU process. The longest frame is wall time, and so is the start. Script is the CPU time
of the page's main thread; its ratios are to three's frame of one unlit mesh. *Settled*: once the lights have kept their kinds for 20 frames.

${aimsTable(results, TEN).table}

All checks are [at the end](#appendix-limits-and-aims).

## Frames

${framesTables(results).join('\n\n')}

## Script, start, heap and size

${otherTable(results)}

## First picture of a model, next to other viewers

Each cell: element : model-viewer : babylon-viewer; before it the ratio to the better of the two. A fresh browser for each page, the
viewers' published files, a 400 × 300 element. The picture counts when half of the model's pixels are on the screen; the slow
line has 10 Mbit/s and 40 ms, with scripts in brotli. Memory is the sum of the peaks of the page's and the GPU's process, MiB. The
longest task is the page's, from navigation to rest; both without the slow line.

${modelTables(results).join('\n\n') || 'Not measured yet.'}

## Whole pictures: time against error

Each cell: the RMSE in codes (0 to 255), over all channels of all pixels, background included, against the exact mean over each pixel, by a float64
ray caster with 1,024 samples per pixel on the same triangles; then the time from a change to the picture, the plain one = 1. 400 × 300 pixels; the nine viewers share them.
Frames follow one another without waiting for a display, and each is finished before the next. three.js draws the element's
triangles under a ShaderMaterial of the same equation: with 4 samples those of the plain picture, in its passes those of the
samples. Its passes average linear light, which OutputPass encodes; the second RMSE is theirs when they average the codes, as the
element does. TAARenderPass shows a picture after each accumulation; 0 is that of the change itself.

${pictureTables(results).join('\n\n') || 'Not measured yet.'}

## Charts

${pictures.join('\n\n')}

## Machines

${machinesTable(results)}
${additions(results)}${failures(results)}
\`npm run bench -- --help\` explains how to measure again.

## Appendix: accuracy in numbers

Each pair: the time of a frame, the plain loop = 1, and the largest error in codes.

${accuracyTables(accuracies)}

## Appendix: limits and aims

${all.met} of ${all.count} are met.

${all.table}
`;
  return { report, charts };
}

/** Of a plot in the report, in pixels. */
const PLOT_WIDTH = 680;

/** @param {readonly MeasuredAccuracy[]} accuracies */
const accuracyTables = (accuracies) =>
  accuracies
    .map(({ stack, accuracy }) => {
      const { renderer, date, size } = accuracy;
      const rows = accuracyRows(accuracy).map(({ label, about, cells }) => [
        `${label}: ${about}`,
        ...cells,
      ]);
      return `**${stack}**, ${size.join(' × ')} pixels, ${renderer}, ${date}\n\n${table(['', ...ACCURACY_HEAD], rows)}`;
    })
    .join('\n\n') || 'Not measured yet.';

/**
 * @param {readonly BenchResult[]} results @param {readonly string[]} [labels] in their order;
 * default: all checks
 */
function aimsTable(results, labels) {
  let [met, count] = [0, 0];
  const chosen = labels?.flatMap((label) => AIMS.filter((aim) => aim.label === label)) ?? AIMS;
  const rows = chosen.map((aim) => {
    const cells = results.map((result) => {
      const found = judge(aim, result);
      if (found === undefined) return '–';
      count += 1;
      if (found.met) {
        met += 1;
      }
      const sign = aim.least === true ? '≥' : '≤';
      const word = found.limit ? 'limit' : 'aim';
      return `${found.met ? '✓' : '**✗**'} ${spreadText(found.measured)}, ${word} ${sign} ${found.most}`;
    });
    return [aim.label, ...cells];
  });
  return { met, count, table: table(['', ...stacks(results)], rows) };
}

/** @param {readonly BenchResult[]} results */
function framesTables(results) {
  return results.map((result) => {
    const names = Object.keys(SUBJECTS).filter((name) => SUBJECTS[name]?.kind === 'frames');
    const rows = names.flatMap((subject) => {
      if (rowOf(result, subject, 'settled') === undefined) return [];
      const cells = ['first frames', 'settled'].map((measure) =>
        both(rowOf(result, subject, measure)),
      );
      return [[subject, ...cells, both(rowOf(result, subject, 'longest frame'), false)]];
    });
    const head = ['ms, base', 'first frames', 'settled', 'longest frame'];
    return `**${result.stack}**, ${result.size.join(' × ')} pixels${stackKind(result) === 'software' ? ' (fewer above 32 lights)' : ''}\n\n${table(head, rows)}`;
  });
}

/**
 * Ratio and both sides' values. @param {import('./results.mjs').Measure | undefined} row @param
 * {boolean} [withRatio]
 */
function both(row, withRatio = true) {
  if (row === undefined) return '–';
  const sides = Object.keys(row.samples);
  const values = sides.map((side) => digits(valueOf(row, side).median)).join(' : ');
  const ratio = ratioOf(row);
  return ratio === undefined || !withRatio ? values : `${spreadText(ratio)} = ${values}`;
}

/** @param {readonly BenchResult[]} results */
function modelTables(results) {
  const [local, slow] = NETWORKS;
  const columns = /** @type {const} */ ([
    [`first picture, ms, ${local}`, 'first picture', local],
    [`first picture, ms, ${slow}`, 'first picture', slow],
    ['longest task, ms', 'longest task', local],
    ['peak memory, MiB', 'peak memory', local],
  ]);
  const head = columns.map(([title]) => title);
  return results.flatMap((result) => {
    const rows = Object.keys(MODELS).map((model) => [
      model,
      ...columns.map(([, measure, network]) =>
        besideBest(rowOf(result, modelSubject(model, network), measure)),
      ),
    ]);
    if (rows.every((cells) => cells.slice(1).every((cell) => cell === '–'))) return [];
    const medians = columns.map(([, measure, network]) => {
      const ratio = ratioOverSubjects(result, modelSubjects(network), measure);
      return ratio === undefined ? '–' : spreadText(ratio);
    });
    return [
      `**${result.stack}**\n\n${table(['', ...head], [...rows, ['median ratio', ...medians]])}`,
    ];
  });
}

/**
 * All sides' values, and the first one's ratio to the better of the others. @param
 * {import('./results.mjs').Measure | undefined} row
 */
function besideBest(row) {
  const ratio = row === undefined ? undefined : ratioToBest(row);
  if (row === undefined || ratio === undefined) return '–';
  const values = Object.keys(row.samples).map((side) => digits(valueOf(row, side).median));
  return `${digits(ratio.median)} = ${values.join(' : ')}`;
}

/** @param {readonly BenchResult[]} results */
function otherTable(results) {
  /** @type {Map<string, string[]>} */
  const rows = new Map();
  for (const { subject, measure, unit, samples } of results.flatMap(({ measures }) => measures)) {
    if (['frames', 'model', 'picture'].includes(SUBJECTS[subject]?.kind ?? '')) continue;
    for (const side of Object.keys(samples)) {
      const label = `${subject}, ${measure}, ${side}, ${unit}`;
      const cells = results.map((result) => {
        const row = rowOf(result, subject, measure);
        return row === undefined || !(side in row.samples) ? '–' : spreadText(valueOf(row, side));
      });
      rows.set(label, [label, ...cells]);
    }
  }
  return table(['', ...stacks(results)], [...rows.values()]);
}

/** Rows of the pictures' table. */
const PICTURE_SIDES = [
  PLAIN,
  ...FULL.map(full),
  MULTISAMPLED,
  ...[4, 16, 32].map(ssaa),
  ...[0, 1, 4, 16, 32].map(taa),
];

/** @param {readonly BenchResult[]} results */
function pictureTables(results) {
  const names = /** @type {(keyof typeof PICTURES)[]} */ (Object.keys(PICTURES));
  return results.flatMap((result) => {
    const subjects = names.map(pictureSubject);
    if (subjects.every((subject) => pictureTime(result, subject, PLAIN) === undefined)) return [];
    /** @param {string} label @param {string} measure @param {string} side */
    const values = (label, measure, side) => [
      label,
      ...subjects.map((subject) => digits(pictureValue(result, subject, measure, side))),
    ];
    const rows = PICTURE_SIDES.map((side) => [
      side,
      ...subjects.map((subject) => {
        const time = pictureTime(result, subject, side);
        const error = pictureValue(result, subject, RMSE.triangles, side);
        if (time === undefined || error === undefined) return '–';
        const ofCodes = pictureValue(result, subject, RMSE.triangles, side + CODES);
        return `${digits(error)}${ofCodes === undefined ? '' : ` or ${digits(ofCodes)}`} in ${digits(time)}`;
      }),
    ]);
    const more = [PLAIN, full(64)].flatMap((side) => [
      values(`${side}: % of pixels within one code`, WITHIN, side),
      values(`${side}: RMSE to the round shape`, RMSE.round, side),
    ]);
    return [`**${result.stack}**\n\n${table(['RMSE in time', ...names], [...rows, ...more])}`];
  });
}

/** @param {readonly BenchResult[]} results */
function machinesTable(results) {
  const keys = [...new Set(results.flatMap(({ machine }) => Object.keys(machine)))];
  const rows = keys.map((key) => [key, ...results.map(({ machine }) => machine[key] ?? '–')]);
  const dates = ['measured', ...results.map(({ date }) => date)];
  const launches = ['launches', ...results.map((result) => String(result.launches))];
  return table(['', ...stacks(results)], [dates, launches, ...rows]);
}

/** @param {readonly BenchResult[]} results */
function additions(results) {
  const lines = results.flatMap(({ stack, added = [] }) =>
    added.map(({ subjects, machine, date, launches, note }) => {
      const facts = [date, `launches: ${launches}`, ...Object.values(machine).slice(0, 5), note];
      return `- ${stack}, ${subjects.join('; ')}: ${escaped(facts.filter((fact) => fact !== '').join(', '))}`;
    }),
  );
  return lines.length === 0 ? '' : `\nMeasured on their own:\n\n${lines.join('\n')}\n`;
}

/** @param {readonly BenchResult[]} results */
function failures(results) {
  const lines = results.flatMap(({ stack, failures: failed }) =>
    failed.map(({ subject, message }) => `- ${stack}, ${subject}: ${escaped(message)}`),
  );
  return lines.length === 0 ? '' : `\nNot measured:\n\n${lines.join('\n')}\n`;
}

/** @param {readonly BenchResult[]} results */
const stacks = (results) => results.map(({ stack }) => stack);

/** @param {import('./statistics.mjs').Spread} spread */
const spreadText = ({ median: middle, low, high, count }) =>
  count < 2 ? digits(middle) : `${digits(middle)} (${digits(low)}–${digits(high)})`;

/** Three significant digits, never an exponent. @param {number} [x] */
function digits(x) {
  if (x === undefined) return '–';
  return Math.abs(x) >= 100 ? x.toFixed(0) : String(Number(x.toPrecision(x >= 1 ? 3 : 2)));
}

/**
 * About speed: frames of the sphere next to three.js, on the GPU that does worst. With the README's
 * marks.
 * @param {readonly BenchResult[]} results
 */
export function readmeSentence(results) {
  const ratios = results
    .filter((result) => stackKind(result) === 'gpu')
    .map((result) => rowOf(result, 'sphere, 8 lights', 'settled'))
    .flatMap((row) => (row && ratioOf(row)?.median) ?? []);
  return `<!-- bench: written by npm run bench:report -->
Speed: nothing runs while nothing changes, and with eight lights a frame takes ${Math.max(...ratios).toFixed(2)} of the time of three.js's MeshPhongMaterial
on a GPU once the lights have kept their kinds for 20 frames ([report](tests/bench/REPORT.md)).
<!-- /bench -->`;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const { values } = readCommandLine(USAGE, { folder: { type: 'string', default: here } });
  const { folder } = values;
  const results = readResults(join(folder, 'results'));
  const { report, charts } = reportOf(results, readAccuracies(join(folder, 'accuracy')));
  rmSync(join(folder, 'charts'), { recursive: true, force: true });
  mkdirSync(join(folder, 'charts'));
  for (const [file, svg] of charts) {
    writeFileSync(join(folder, 'charts', file), `${svg}\n`);
  }
  writeFileSync(join(folder, 'REPORT.md'), report);
  console.log(`REPORT.md and ${charts.size} charts from ${results.length} results`);
  if (folder === here) {
    writePart(readmeSentence(results));
  }
}
