// @ts-check
// `npm test`: every check as a named step, all of them run even where one fails, and a count as the last line.
// Arguments choose steps or test folders: `npm test -- unit element`; `--release` adds the slow tests.

import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const nodeFolders = ['unit', 'stress'];
const browserFolders = ['element', 'visual', 'a11y', 'glsl', 'package'];
const checks = ['format', 'lint', 'types', 'build', 'browser', 'release'];

process.chdir(fileURLToPath(new URL('..', import.meta.url)));
const chosen = process.argv.slice(2).filter((argument) => argument !== '--release');
const unknown = chosen.filter((name) => ![...nodeFolders, ...browserFolders, ...checks].includes(name));
if (unknown.length > 0) {
  console.error(
    `Unknown: ${unknown.join(', ')}. Steps: ${[...checks, ...nodeFolders, ...browserFolders].join(', ')}`,
  );
  process.exit(1);
}
if (process.argv.includes('--release') || chosen.includes('release'))
  process.env['PHONG_VIEWER_RELEASE'] = '1';

/** @typedef {{ passed: number, failed: number, skipped: number }} Count */
/** @type {{ name: string, count: Count, seconds: number }[]} */
const results = [];
const reports = mkdtempSync(join(tmpdir(), 'phong-viewer-'));

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

if (all || chosen.includes('format'))
  check('format', 'node_modules/prettier/bin/prettier.cjs', '--check', '.');
if (all || chosen.includes('lint')) check('lint', 'node_modules/eslint/bin/eslint.js', '.');
if (all || chosen.includes('types')) check('types', 'node_modules/typescript/bin/tsc', '--noEmit');
if (all || wantedNode.length > 0) unit();
if (anyBrowser || chosen.includes('build')) {
  check('build', '.ci/build.mjs');
  const vite = 'node_modules/vite/bin/vite.js';
  check('demo build', vite, 'build', '--logLevel', 'warn');
  check('harness', vite, 'build', '--config', 'vite.harness.config.ts', '--logLevel', 'warn');
}
if (anyBrowser) await browser();

rmSync(reports, { recursive: true, force: true });
summarize();

/** A step that only says yes or no counts as one. @param {string} name @param {string[]} args */
function check(name, ...args) {
  step(name, () => {
    const ok = node(args) === 0;
    return { passed: ok ? 1 : 0, failed: ok ? 0 : 1, skipped: 0 };
  });
}

function unit() {
  const report = join(reports, 'unit.json');
  step('unit', () => {
    const args = ['run', '--reporter=default', '--reporter=json', `--outputFile.json=${report}`];
    const folders = wantedNode.map((name) => `tests/${name}/`);
    const status = node(['node_modules/vitest/vitest.mjs', ...args, ...folders]);
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
  const { browserVersion, ensureBrowser } = await import('./browser.mjs');
  let path = '';
  try {
    path = await ensureBrowser();
  } catch (error) {
    console.error(String(error));
  }
  step('browser', () => {
    if (path === '') return { passed: 0, failed: 1, skipped: 0 };
    console.log(`${browserVersion(path)} at ${path}`);
    process.env['PLAYWRIGHT_JSON_OUTPUT_FILE'] = report;
    const folders = allBrowser ? [] : wantedBrowser.map((name) => `tests/${name}/`);
    const args = ['test', '--reporter=list,json', '--pass-with-no-tests', ...folders];
    const status = node(['node_modules/@playwright/test/cli.js', ...args]);
    return counted(report, status, ({ stats, errors }) => ({
      passed: stats.expected + stats.flaky,
      failed: Math.max(stats.unexpected, errors.length > 0 ? 1 : 0),
      skipped: stats.skipped,
    }));
  });
}

/** @param {string} report @param {number} status @param {(json: any) => Count} read @returns {Count} */
function counted(report, status, read) {
  if (!existsSync(report)) return { passed: 0, failed: 1, skipped: 0 };
  const count = read(JSON.parse(readFileSync(report, 'utf8')));
  return { ...count, failed: status === 0 ? count.failed : Math.max(count.failed, 1) };
}

/** @param {string} name @param {() => Count} run */
function step(name, run) {
  console.log(`\n== ${name}`);
  const start = performance.now();
  const count = run();
  results.push({ name, count, seconds: (performance.now() - start) / 1000 });
}

/** @param {string[]} args @returns {number} */
function node(args) {
  return spawnSync(process.execPath, args, { stdio: 'inherit' }).status ?? 1;
}

function summarize() {
  const total = { passed: 0, failed: 0, skipped: 0 };
  console.log('\n== summary');
  for (const { name, count, seconds } of results) {
    total.passed += count.passed;
    total.failed += count.failed;
    total.skipped += count.skipped;
    const verdict = count.failed > 0 ? 'FAILED' : 'ok';
    console.log(`${name.padEnd(12)}${verdict.padEnd(8)}${countLine(count)} in ${seconds.toFixed(1)} s`);
  }
  console.log(countLine(total));
  process.exit(total.failed > 0 ? 1 : 0);
}

/** @param {Count} count */
function countLine({ passed, failed, skipped }) {
  return `${passed} passed, ${failed} failed` + (skipped > 0 ? `, ${skipped} skipped` : '');
}
