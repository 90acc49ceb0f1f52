// @ts-check
// `npm test`: every check as a named step, all of them run even where one fails, and a count as the last line. Steps of one
// thread run in two rows beside each other, and say what they have to say when they end; the others have all cores.
// Arguments choose steps or test folders: `npm test -- unit element`; `--release` adds the slow tests.

import { spawn } from 'node:child_process';
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

const vite = ['node_modules/vite/bin/vite.js', 'build', '--logLevel', 'warn'];
const building = anyBrowser || chosen.includes('build');
await Promise.all([
  row([[all || chosen.includes('lint'), 'lint', ['node_modules/eslint/bin/eslint.js', '.']]]),
  row([
    [all || chosen.includes('types'), 'types', ['node_modules/typescript/bin/tsc', '--noEmit']],
    [building, 'build', ['.ci/build.mjs']],
    [building, 'demo build', vite],
    [building, 'harness', [...vite, '--config', 'vite.harness.config.ts']],
    [all || chosen.includes('format'), 'format', ['node_modules/prettier/bin/prettier.cjs', '--check', '.']],
  ]),
]);
if (all || wantedNode.length > 0) await unit();
if (anyBrowser) await browser();

rmSync(reports, { recursive: true, force: true });
summarize();

/**
 * Steps that only say yes or no, one after the other; each counts as one.
 * @param {[wanted: boolean, name: string, args: string[]][]} steps
 */
async function row(steps) {
  for (const [wanted, name, args] of steps) {
    if (!wanted) continue;
    const start = performance.now();
    const { status, said } = await node(args, 'kept');
    console.log(`${heading(name, start)}\n${said.trim()}`);
    const ok = status === 0;
    results.push({
      name,
      count: { passed: ok ? 1 : 0, failed: ok ? 0 : 1, skipped: 0 },
      seconds: since(start),
    });
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
  const { browserVersion, ensureBrowser } = await import('./browser.mjs');
  let path = '';
  try {
    path = await ensureBrowser();
  } catch (error) {
    console.error(String(error));
  }
  await step('browser', async () => {
    if (path === '') return { passed: 0, failed: 1, skipped: 0 };
    console.log(`${browserVersion(path)} at ${path}`);
    process.env['PLAYWRIGHT_JSON_OUTPUT_FILE'] = report;
    const folders = allBrowser ? [] : wantedBrowser.map((name) => `tests/${name}/`);
    const args = ['test', '--reporter=list,json', '--pass-with-no-tests', ...folders];
    const { status } = await node(['node_modules/@playwright/test/cli.js', ...args]);
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

/** @param {string} name @param {() => Promise<Count>} run */
async function step(name, run) {
  const start = performance.now();
  console.log(heading(name, start));
  const count = await run();
  results.push({ name, count, seconds: since(start) });
}

/** Seconds. @param {number} start as performance.now() gave it */
function since(start) {
  return (performance.now() - start) / 1000;
}

/** @param {string} name @param {number} start milliseconds since this command's own */
function heading(name, start) {
  return `\n== ${name} (after ${(start / 1000).toFixed(0)} s)`;
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
    for (const stream of [child.stdout, child.stderr]) stream?.on('data', (part) => parts.push(part));
    child.on('error', (error) => resolve({ status: 1, said: String(error) }));
    child.on('close', (code) => resolve({ status: code ?? 1, said: Buffer.concat(parts).toString() }));
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
    console.log(`${name.padEnd(12)}${verdict.padEnd(8)}${countLine(count)} in ${seconds.toFixed(1)} s`);
  }
  console.log(countLine(total));
  process.exit(total.failed > 0 ? 1 : 0);
}

/** @param {Count} count */
function countLine({ passed, failed, skipped }) {
  return `${passed} passed, ${failed} failed` + (skipped > 0 ? `, ${skipped} skipped` : '');
}
