// @ts-check
// `npm run stress`: many stress cases in a real browser, over several pages at once, from a new
// seed, on the shipped shader and on the worst lawful drivers; prints each category and writes one
// JSON a stack. Plain JavaScript, so that it runs on any machine with Node, a browser and
// dist-harness/.

import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { launchOptions, serveFolder } from '../support/built-pages.mjs';
import {
  numberOption,
  Progress,
  readCommandLine,
  readJson,
  refuse,
  timeText,
} from '../support/command-line.mjs';

const DRIVERS = ['shipped', 'up', 'down', 'either'];

const USAGE = `
npm run stress -- [options]: does the light loop keep its contract, in many random cases, and in worse ones climbed to from them?
  --cases N        of each driver, default 1e8
  --seed S         a new one otherwise
  --drivers LIST   of ${DRIVERS.join(', ')}; default all: the browser's own and the worst lawful ones
  --only LIST      ids of categories, such as generic,normals; default all
  --pages N        at a time, default all cores but one
  --out FILE       adds the results to this JSON, such as tests/stress/results/NAME.json
  --browser PATH   another Chromium, with its own --arg=--use-angle=vulkan --arg=...; default software GL
  --firefox        Firefox instead
  --harness DIR    a built harness page; default: builds it
  --help`;

const { values: options } = readCommandLine(USAGE, {
  cases: { type: 'string', default: '1e8' },
  seed: { type: 'string', default: String(Math.floor(Math.random() * 2 ** 31)) },
  drivers: { type: 'string', default: DRIVERS.join() },
  pages: { type: 'string', default: String(Math.max(1, availableParallelism() - 1)) },
  harness: { type: 'string', default: '' },
  out: { type: 'string', default: '' },
  only: { type: 'string', default: '' },
  browser: { type: 'string', default: '' },
  arg: { type: 'string', multiple: true, default: [] },
  firefox: { type: 'boolean', default: false },
});
const cases = numberOption('cases', options.cases, 1);
const seed = numberOption('seed', options.seed);
const pages = numberOption('pages', options.pages, 1);
const chosen = options.drivers.split(',');
const strange = chosen.find((driver) => !DRIVERS.includes(driver));
if (strange !== undefined) {
  refuse(`Unknown driver '${strange}'`);
}

if (options.harness !== '' && !existsSync(join(options.harness, 'index.html'))) {
  refuse(`There is no built harness in ${options.harness}`);
}
// A file that cannot be read is refused now, not after hours of measuring.
if (existsSync(options.out)) {
  readJson(options.out);
}

/** So many that starting a page is little of its time, so few that all pages have work. */
const CASES_A_PAGE = 2e6;

/** @typedef {import('../glsl/page/page.js').Report} Report */
/** @typedef {import('./measure.js').Measured} Measured */
/** @typedef {import('../glsl/chunk-checks.js').Checked} Checked */

const site = await serveFolder(options.harness || (await builtHarness()));
const browser = await launch();
console.log(`seed ${seed}`);

/**
 * @typedef {{ seed?: number, broken: readonly string[], checked: readonly Checked[], measured:
 * readonly Measured[] }} Result
 */
/** @type {Record<string, Result>} */
const drivers = {};
let renderer = '';
let agent = '';
/** @type {Report['contract'] | undefined} */
let contract;
/** Of which loop: a file's drivers are all of one. */
let loop = '';
const progress = new Progress();
for (const driver of chosen) {
  const start = performance.now();
  const result = await runDriver(driver);
  drivers[driver] = { seed, ...result };
  print(driver, (performance.now() - start) / 1000, result);
  // After each driver, so that a run that is cut short leaves something.
  if (options.out !== '') {
    keep(options.out);
  }
}
await browser.close();
site.close();
process.exit(Object.values(drivers).some(({ broken }) => broken.length > 0) ? 1 : 0);

/**
 * Writes what was measured beside what the file holds of other drivers on the same stack. @param
 * {string} file
 */
function keep(file) {
  mkdirSync(dirname(file), { recursive: true });
  const before = existsSync(file) ? readJson(file) : {};
  const others = before.renderer === renderer && before.loop === loop ? before.drivers : {};
  const stack = { renderer, browser: agent, contract, loop, drivers: { ...others, ...drivers } };
  // The worst case itself is for looking into at once: with the seed it can be had again.
  const text = JSON.stringify(stack, (key, value) => (key === 'worst' ? undefined : value), 1);
  writeFileSync(file, `${text}\n`);
}

/** @param {string} driver */
async function runDriver(driver) {
  const parts = Math.max(Math.ceil(cases / CASES_A_PAGE), Math.min(pages, Math.ceil(cases / 2e5)));
  /** @type {Report[]} */
  const reports = [];
  let next = 0;
  const worker = async () => {
    for (let part = next++; part < parts; part = next++) {
      const query = new URLSearchParams({
        driver,
        seed: String(seed + part),
        cases: String(cases / parts),
      });
      if (options.only !== '') {
        query.set('only', options.only);
      }
      const report = await browser.report(`${site.origin}/index.html?${query}`);
      const ids = report.measured.map(({ id }) => id);
      const strange = options.only.split(',').find((id) => id !== '' && !ids.includes(id));
      if (strange !== undefined && report.error === null) {
        refuse(`Unknown category '${strange}'`);
      }
      reports.push(report);
      const done = Object.keys(drivers).length * parts + reports.length;
      progress.show(done, chosen.length * parts, `${driver}, ${reports.length} of ${parts} pages`);
    }
  };
  await Promise.all(Array.from({ length: pages }, worker));
  const failed = reports.find(({ error }) => error !== null);
  if (failed) throw new Error(`${failed.renderer}: ${failed.error}`);
  ({ renderer, browser: agent, contract, loop } = /** @type {Report} */ (reports[0]));
  return browser.merge(reports);
}

async function launch() {
  const { open, close } = options.firefox ? await firefox() : await chromium();
  /** @type {import('playwright-core').Page | undefined} */
  let merging;
  return {
    close,
    /** @param {string} address @returns {Promise<Report>} */
    async report(address) {
      const page = await open();
      // The page's own checks of chunks come before it has loaded: minutes on a slow machine.
      await page.goto(address, { timeout: 0 });
      const report = await page.evaluate(() => window.finished);
      await page.close();
      return report;
    },
    /** The page knows how reports are put together. @param {Report[]} reports */
    async merge(reports) {
      if (merging === undefined) {
        merging = await open();
        // No check has this title: the page is there for its functions alone.
        await merging.goto(`${site.origin}/index.html?cases=0&chunks=none`, { timeout: 0 });
      }
      return merging.evaluate((/** @type {Report[]} */ all) => window.merged(all), reports);
    },
  };
}

async function chromium() {
  const { chromium } = await import('playwright-core');
  const own = await chromium.launch(await launchOptions(options.browser, options.arg));
  return { open: () => own.newPage(), close: () => own.close() };
}

async function firefox() {
  const { startFirefox } = await import('../../.ci/firefox.mjs');
  const own = await startFirefox();
  // Of a page only what both drivers have alike is used here.
  const open = async () =>
    /** @type {import('playwright-core').Page} */ (
      /** @type {unknown} */ (await own.browser.newPage())
    );
  return { open, close: own.close };
}

async function builtHarness() {
  const { build } = await import('vite');
  const { outputFolder } = await import('../../.ci/output-folder.mjs');
  const repository = fileURLToPath(new URL('../..', import.meta.url));
  await build({ configFile: join(repository, '.ci/vite/harness.config.ts'), logLevel: 'warn' });
  return outputFolder('dist-harness');
}

/** @param {string} driver @param {number} seconds @param {Result} result */
function print(driver, seconds, { broken, measured }) {
  const count = (/** @type {'cases' | 'searched'} */ key) =>
    measured.reduce((total, one) => total + one[key], 0);
  progress.clear();
  console.log(
    `\n${driver}: ${count('cases')} cases and ${count('searched')} found by climbing in ${timeText(seconds)}, ${renderer}`,
  );
  console.log(
    'Errors: of the sum before clamping, in codes (1/255 of full), over max(1, the brightness).',
  );
  console.table(
    Object.fromEntries(
      measured.map(({ id, max, notFinite, exact, channels, wrongCodes, excluded }) => [
        id,
        {
          'largest error': Number(max.toPrecision(3)),
          'NaN or Inf': notFinite,
          'exact codes, %': Number(((100 * exact) / channels).toFixed(4)),
          'off by > 1': wrongCodes,
          'left out': Object.entries(excluded).join(' ').replaceAll(',', ' '),
        },
      ]),
    ),
  );
  console.log(broken.length === 0 ? 'The contract holds.' : `BROKEN\n${broken.join('\n')}`);
}
