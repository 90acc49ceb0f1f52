// @ts-check
// The report of all stacks' results as Markdown, and the charts that it shows. Pure: nothing is read or written here, and
// nothing in it is typed by hand but how to read it.

import { frontChart, growthChart } from './chart.mjs';
import { range, short } from './chart/text.mjs';
import { dominated, frontier } from './front.mjs';
import { inHtml, plain, table } from './markdown.mjs';
import { figures, growth, peers } from './report-comparisons.mjs';
import { chartName, images, nameOf, unique, unitsOf } from './stacks.mjs';

/** @typedef {import('./stacks.mjs').Stack} Stack */

/**
 * @param {readonly Stack[]} stacks
 * @param {string} [findings] Markdown of what was found, taken as it is
 * @returns {{ report: string, charts: Map<string, string> }} charts by their file's name
 */
export function reportOf(stacks, findings) {
  const charts = chartsOf(stacks);
  const sections = [
    OPENING,
    ...(findings === undefined ? [] : [findings.trim()]),
    machines(stacks),
    ...fronts(stacks),
    growth(stacks),
    peers(stacks),
    figures(stacks),
    REPEATING,
  ];
  return { report: `${sections.filter((section) => section !== '').join('\n\n')}\n`, charts };
}

const OPENING = `# Run time against error

Written by \`npm run bench:report\` from tests/bench/results; do not edit.

Each front times variants of one drawing side by side and compares their pictures with what they should show. Times are medians
(and quartiles) of a frame; *time* is the ratio to the base variant within the same round, which another machine's load leaves
alone. Errors are of channels in 1/255, before rounding: root mean square, 99.9 % of channels within, largest; *other codes* is the
share of channels whose 8-bit code differs; CIEDE2000 and FLIP (0–1) say what an eye makes of it, in the mean over all pixels. A
variant is on the front (●) where no other is at least as fast and as exact, and better in one (○).`;

const REPEATING = `## Measuring it again

\`\`\`sh
npm run bench -- --out tests/bench/results/NAME.json                 # this machine, software GL
npm run bench -- --browser PATH --arg=--use-angle=vulkan --out …     # a GPU
npm run bench -- --build FOLDER                                      # pages to take to a machine with Node and a browser alone
npm run bench -- --compare BEFORE.json AFTER.json                    # what moved by more than the noise of both runs
npm run bench:report
\`\`\``;

/** @param {readonly Stack[]} stacks */
function chartsOf(stacks) {
  /** @type {Map<string, string>} */
  const charts = new Map();
  const add = (/** @type {string} */ name, /** @type {string} */ chart) => {
    if (charts.has(name)) throw new Error(`two charts are called ${name}`);
    charts.set(name, chart);
  };
  for (const stack of stacks) {
    for (const front of stack.fronts) add(chartName(stack, front.axis, front.scene), frontChart(front));
    for (const unit of unitsOf([stack])) {
      add(chartName(stack, 'growth', unit), growthChart(stack.growth.filter((one) => one.unit === unit)));
    }
  }
  return charts;
}

/** @param {readonly Stack[]} stacks */
function machines(stacks) {
  if (stacks.length === 0) return '';
  const facts = stacks.map(({ machine, seed, launches, rounds }) => ({
    .../** @type {Record<string, unknown>} */ (machine),
    ...{ seed, launches, 'rounds a launch': rounds },
  }));
  const keys = unique(facts.flatMap((one) => Object.keys(one)));
  const rows = keys.map((key) => [
    plain(key),
    ...facts.map((one) => plain(String(/** @type {Record<string, unknown>} */ (one)[key] ?? '–'))),
  ]);
  return `## Machines and versions\n\n${table(['', ...stacks.map((stack) => plain(nameOf(stack)))], rows)}`;
}

/** A section an axis, a part a scene. @param {readonly Stack[]} stacks */
function fronts(stacks) {
  const all = stacks.flatMap((stack) => stack.fronts.map((front) => ({ stack, front })));
  return unique(all.map(({ front }) => front.axis)).map((axis) => {
    const ofAxis = all.filter(({ front }) => front.axis === axis);
    const parts = unique(ofAxis.map(({ front }) => front.scene)).map((scene) => {
      const here = ofAxis.filter(({ front }) => front.scene === scene);
      return [
        `### ${plain(here[0]?.front.title ?? scene)}`,
        images(
          here.map(({ stack, front }) => ({
            stack,
            name: chartName(stack, axis, front.scene),
            of: front.title,
          })),
        ),
        ...here.map(({ stack, front }) => details(summaryOf(stack, front), frontTable(front))),
      ].join('\n\n');
    });
    return [`## Axis: ${plain(axis)}`, ...parts].join('\n\n');
  });
}

/** @param {string} summary in HTML @param {string} content */
const details = (summary, content) => `<details><summary>${summary}</summary>\n\n${content}\n\n</details>`;

/** @param {Stack} stack @param {import('./front.mjs').Front} front */
function summaryOf(stack, { measure, size, errorSize, truth, points }) {
  const best = frontier(points).map(({ label }) => label);
  return inHtml(
    `${nameOf(stack)}: ${measure}, ${size.join(' × ')}; errors against ${truth}, ${errorSize.join(' × ')}. ` +
      `On the front ${best.length} of ${points.length}: ${best.join('; ')}`,
  );
}

/** Fastest first. @param {import('./front.mjs').Front} front */
function frontTable({ points, base, shipped }) {
  const pointless = dominated(points);
  const noted = points.some(({ note }) => note !== undefined);
  const head = ['', 'variant', 'time', 'ms', 'RMSE', '99.9 %', 'largest', 'other codes', 'CIEDE2000', 'FLIP'];
  const rows = [...points]
    .sort((a, b) => a.time.median - b.time.median)
    .map(({ id, label, time, ratio, error, note }) => [
      pointless.has(id) ? '○' : '●',
      [
        id === shipped ? `**${plain(label)}** (ships)` : plain(label),
        ...(id === base ? ['(base)'] : []),
      ].join(' '),
      range(ratio),
      short(time.median),
      ...[error.rmse, error.p999, error.max].map((x) => short(x)),
      percent(error.share),
      ...[error.deltaE, error.flip].map((x) => short(x)),
      ...(noted ? [plain(note ?? '')] : []),
    ]);
  return table(noted ? [...head, 'note'] : head, rows);
}

/** @param {number} share */
const percent = (share) => `${short(100 * share)} %`;
