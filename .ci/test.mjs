// @ts-check
// `npm test`: every check as a named step. All steps run even where one fails; the last line is a
// count. Quick steps run in two rows beside each other and print their output when they end; the
// others have all cores. How long each step took last time is kept in node_modules/.cache, to say
// how much time is left.

import { spawn } from 'node:child_process';
import {
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { readCommandLine, timeText } from '../tests/support/command-line.mjs';

const nodeFolders = ['unit', 'extras', 'stress'];
const browserFolders = ['element', 'extras', 'visual', 'a11y', 'glsl', 'package'];
const checks = ['format', 'lint', 'types', 'build', 'browser', 'release', 'mutation'];

const USAGE = `
npm test -- [steps] [--release]: all checks, or only the named ones
  steps       ${[...new Set([...checks, ...nodeFolders, ...browserFolders])].join(', ')}
  --release   adds the slow tests and a sample of mutants (npm run test:release)
  --help
Which step answers which question: tests/README.md`;

process.chdir(fileURLToPath(new URL('..', import.meta.url)));
const { values, positionals: chosen } = readCommandLine(
  USAGE,
  { release: { type: 'boolean', default: false } },
  [...checks, ...nodeFolders, ...browserFolders],
);
if (values.release || chosen.includes('release')) {
  process.env['PHONG_VIEWER_RELEASE'] = '1';
}

/** @typedef {{ passed: number, failed: number, skipped: number }} Count */
/** @type {{ name: string, count: Count, seconds: number }[]} */
const results = [];
/** Browser tests that passed only at a second attempt: their places and titles. @type {string[]} */
const retried = [];
const reports = mkdtempSync(join(tmpdir(), 'phong-viewer-'));
const secondsFile = 'node_modules/.cache/phong-viewer/step-seconds.json';

await import('./install.mjs');

const all = chosen.length === 0;
const wantedNode = nodeFolders.filter((name) => chosen.includes(name));
const wantedBrowser = browserFolders.filter((name) => chosen.includes(name));
if (chosen.includes('release')) {
  wantedNode.push('release');
  wantedBrowser.push('release');
}
const allBrowser = all || chosen.includes('browser');
const anyBrowser = allBrowser || wantedBrowser.length > 0;

/** @typedef {[wanted: boolean, name: string, args: string[]]} Step */

const vite = ['node_modules/vite/bin/vite.js', 'build', '--logLevel', 'warn'];
const building = anyBrowser || chosen.includes('build');
const slow = values.release && all;
/** Rows run beside each other, the steps of a row one after the other. @type {Step[][]} */
const rows = [
  [
    [all || chosen.includes('format'), 'format', ['node_modules/oxfmt/bin/oxfmt', '--check']],
    [all || chosen.includes('lint'), 'lint', ['.ci/lint.mjs']],
    [all || chosen.includes('types'), 'types', ['node_modules/typescript/bin/tsc', '--noEmit']],
  ],
  [
    [building, 'build', ['.ci/build.mjs']],
    [building, 'demo build', vite],
    [building, 'harness', [...vite, '--config', '.ci/vite/harness.config.ts']],
  ],
];
/** Twenty minutes at most on four cores. @type {Step[]} */
const last = [
  [slow || chosen.includes('mutation'), 'mutation', ['tests/mutation/run.mjs', '--sample', '400']],
];
/** @type {[wanted: boolean, name: string, run: () => Promise<void>][]} */
const alone = [
  [all || wantedNode.length > 0, 'unit', unit],
  [anyBrowser, 'browser', browser],
];

/** Seconds that each step took last time. @type {Record<string, number>} */
const lastSeconds = existsSync(secondsFile) ? JSON.parse(readFileSync(secondsFile, 'utf8')) : {};
/** When each running step began, in ms. @type {Map<string, number>} */
const running = new Map();

await Promise.all(rows.map(row));
for (const [wanted, , run] of alone) {
  if (wanted) {
    await run();
  }
}
for (const [wanted, name, args] of last) {
  if (!wanted) continue;
  await step(name, async () => {
    const { status } = await node(args);
    return { passed: status === 0 ? 1 : 0, failed: status === 0 ? 0 : 1, skipped: 0 };
  });
}

rmSync(reports, { recursive: true, force: true });
summarize();

/**
 * Steps that only say yes or no, one after the other; each counts as one.
 * @param {Step[]} steps
 */
async function row(steps) {
  for (const [wanted, name, args] of steps) {
    if (!wanted) continue;
    const start = performance.now();
    running.set(name, start);
    const { status, said } = await node(args, 'kept');
    const ok = status === 0;
    finish(name, start, { passed: ok ? 1 : 0, failed: ok ? 0 : 1, skipped: 0 });
    console.log(`${heading(name)}\n${said.trim()}`);
  }
}

async function unit() {
  const report = join(reports, 'unit.json');
  await step('unit', async () => {
    const args = ['run', '--reporter=default', '--reporter=json', `--outputFile.json=${report}`];
    const folders = wantedNode.map((name) => `tests/${name}/`);
    const { status } = await node(['node_modules/vitest/vitest.mjs', ...args, ...folders]);
    return counted(report, status, (json) => ({
      passed: json.numPassedTests,
      // A file that cannot be loaded is a failed suite without tests.
      failed: Math.max(json.numFailedTests, json.success ? 0 : 1),
      skipped: json.numPendingTests + json.numTodoTests,
    }));
  });
}

async function browser() {
  const report = join(reports, 'browser.json');
  const { browserVersion, ensureBrowser, findTestBrowser } = await import('./browser.mjs');
  let path = '';
  try {
    const installed = await ensureBrowser();
    path = (await findTestBrowser()) ?? installed;
  } catch (error) {
    console.error(String(error));
  }
  await step('browser', async () => {
    if (path === '') return { passed: 0, failed: 1, skipped: 0 };
    console.log(`${browserVersion(path)} at ${path}`);
    process.env['PLAYWRIGHT_JSON_OUTPUT_FILE'] = report;
    const folders = allBrowser ? [] : wantedBrowser.map((name) => `tests/${name}/`);
    const reporters = '--reporter=list,json,./tests/support/time-left.mjs';
    const args = ['test', reporters, '--pass-with-no-tests', ...folders];
    const { status } = await node(['node_modules/@playwright/test/cli.js', ...args]);
    return counted(report, status, ({ stats, errors, suites }) => {
      retried.push(...suites.flatMap(flakyIn));
      return {
        passed: stats.expected + stats.flaky,
        failed: Math.max(stats.unexpected, errors.length > 0 ? 1 : 0),
        skipped: stats.skipped,
      };
    });
  });
}

/**
 * The tests of a suite that Playwright calls flaky.
 * @param {{ suites?: any[], specs: { file: string, line: number, title: string, tests: { status:
 * string }[] }[] }} suite
 * @returns {string[]}
 */
function flakyIn({ suites = [], specs }) {
  const own = specs.filter(({ tests }) => tests.some(({ status }) => status === 'flaky'));
  return [
    ...own.map(({ file, line, title }) => `tests/${file}:${line} ${title}`),
    ...suites.flatMap(flakyIn),
  ];
}

/**
 * @param {string} report @param {number} status @param {(json: any) => Count} read @returns {Count}
 */
function counted(report, status, read) {
  if (!existsSync(report)) return { passed: 0, failed: 1, skipped: 0 };
  const count = read(JSON.parse(readFileSync(report, 'utf8')));
  return { ...count, failed: status === 0 ? count.failed : Math.max(count.failed, 1) };
}

/** @param {string} name @param {() => Promise<Count>} run */
async function step(name, run) {
  const start = performance.now();
  running.set(name, start);
  console.log(heading(name));
  finish(name, start, await run());
}

/** @param {string} name @param {number} start when it began, in ms @param {Count} count */
function finish(name, start, count) {
  const seconds = (performance.now() - start) / 1000;
  running.delete(name);
  results.push({ name, count, seconds });
  // A part of a step's tests says nothing about all of them.
  if (all || !alone.some(([, other]) => other === name)) {
    lastSeconds[name] = Math.round(seconds);
  }
  mkdirSync(dirname(secondsFile), { recursive: true });
  writeFileSync(secondsFile, JSON.stringify(lastSeconds));
}

/** @param {string} name */
function heading(name) {
  return `\n== ${name} (after ${timeText(performance.now() / 1000)}, about ${timeText(secondsLeft())} left)`;
}

/** Of all steps that are still to run, rows beside each other. */
function secondsLeft() {
  const left = (/** @type {readonly (readonly [boolean, string, unknown])[]} */ steps) =>
    steps.reduce((sum, [wanted, name]) => {
      if (!wanted || results.some((result) => result.name === name)) return sum;
      const start = running.get(name);
      const elapsed = start === undefined ? 0 : (performance.now() - start) / 1000;
      return sum + Math.max(0, (lastSeconds[name] ?? guessedSeconds(name)) - elapsed);
    }, 0);
  return Math.max(...rows.map(left)) + left(alone) + left(last);
}

/**
 * For the first run on a machine: as measured on two cores, where the tests grow with their files.
 * @param {string} name
 */
function guessedSeconds(name) {
  if (name === 'unit') return 0.5 * filesIn(nodeFolders, '.test.ts');
  if (name === 'browser') return 5 * filesIn(browserFolders, '.spec.ts');
  return (
    { format: 2, lint: 15, types: 30, build: 25, 'demo build': 6, harness: 6, mutation: 900 }[
      name
    ] ?? 15
  );
}

/** @param {readonly string[]} folders @param {string} end */
function filesIn(folders, end) {
  return folders
    .flatMap((folder) => readdirSync(`tests/${folder}`, { recursive: true }).map(String))
    .filter((file) => file.endsWith(end)).length;
}

/**
 * Runs a script in Node; what it says is shown as it comes, or kept.
 * @param {string[]} args
 * @param {'shown' | 'kept'} words
 * @returns {Promise<{ status: number, said: string }>}
 */
function node(args, words = 'shown') {
  return new Promise((resolve) => {
    const child = spawn(process.execPath, args, { stdio: words === 'shown' ? 'inherit' : 'pipe' });
    /** @type {Buffer[]} */
    const parts = [];
    for (const stream of [child.stdout, child.stderr]) {
      stream?.on('data', (part) => parts.push(part));
    }
    child.on('error', (error) => resolve({ status: 1, said: String(error) }));
    child.on('close', (code) =>
      resolve({ status: code ?? 1, said: Buffer.concat(parts).toString() }),
    );
  });
}

function summarize() {
  const total = { passed: 0, failed: 0, skipped: 0 };
  console.log('\n== summary');
  for (const { name, count, seconds } of results) {
    total.passed += count.passed;
    total.failed += count.failed;
    total.skipped += count.skipped;
    const verdict = count.failed > 0 ? 'FAILED' : 'ok';
    console.log(
      `${name.padEnd(12)}${verdict.padEnd(8)}${countLine(count)} in ${seconds.toFixed(1)} s`,
    );
  }
  if (retried.length > 0) {
    console.log(`${retried.length} passed only at a second attempt:\n  ${retried.join('\n  ')}`);
  }
  console.log(countLine(total));
  process.exit(total.failed > 0 ? 1 : 0);
}

/** @param {Count} count */
function countLine({ passed, failed, skipped }) {
  return `${passed} passed, ${failed} failed` + (skipped > 0 ? `, ${skipped} skipped` : '');
}
