// @ts-check
// Time of the light loop now against the one of another revision, interleaved in one browser, over fresh launches:
//   node tests/bench/loops.mjs --before v0.1.0 [--launches 5] [--browser … --arg=…] [--page folder --texts file]
// `--texts` writes or reads the two programs' texts, for a machine without the repository.

import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { chromium } from 'playwright-core';
import { launchOptions } from '../stress/launch-options.mjs';
import { serveFolder } from '../stress/serve-folder.mjs';

const { values: options } = parseArgs({
  options: {
    before: { type: 'string', default: 'HEAD~1' },
    launches: { type: 'string', default: '5' },
    rounds: { type: 'string', default: '20' },
    size: { type: 'string', default: '512' },
    draws: { type: 'string', default: '2' },
    lights: { type: 'string', default: '1,8,32' },
    browser: { type: 'string', default: '' },
    arg: { type: 'string', multiple: true, default: [] },
    page: { type: 'string', default: '' },
    texts: { type: 'string', default: '' },
  },
});

const repository = fileURLToPath(new URL('../..', import.meta.url));

/** As a fragment is shaded: by the whole equation where the text has it, else by its parts. @param {string} glsl */
const mainOf = (glsl) =>
  glsl.includes('surfaceColor(')
    ? 'color = surfaceColor(p, normal, eye, vec3(0.2), vec3(0.8), vec3(0.5), 32.0);'
    : 'LightSums sums = lightSums(p, unitOrZero(normal), unitOrZero(eye - p), 32.0);' +
      'color = 0.2 * sums.ambient + 0.8 * sums.diffuse + 0.5 * sums.specular;';

const loops = await texts();
const site = await serveFolder(options.page || (await builtPage()));
const launch = await launchOptions(options.browser, options.arg);
/** What is compared, of each text but the first, which is what it is compared with. @type {Map<string, { ratios: number[], first: number[] }>} */
const results = new Map();
let renderer = '';
for (let round = 0; round < Number(options.launches); round++) {
  const browser = await chromium.launch(launch);
  for (const blinn of [false, true]) {
    for (const lights of options.lights.split(',').map(Number)) {
      const page = await browser.newPage();
      await page.goto(`${site.origin}/index.html`);
      const timing = { loops, lights, blinn, size: Number(options.size), rounds: Number(options.rounds) };
      const times = await page.evaluate((o) => window.timeLoops(o), {
        ...timing,
        draws: Number(options.draws),
      });
      await page.close();
      renderer = times.renderer;
      const [first = [], ...others] = times.samples;
      for (const [i, samples] of others.entries()) {
        const name = `${blinn ? 'Blinn–Phong' : 'Phong'}, ${lights} lights: ${loops[i + 1].name}`;
        const kept = results.get(name) ?? { ratios: [], first: [] };
        results.set(name, kept);
        samples.forEach((time, k) => kept.ratios.push(time / (first[k] ?? NaN)));
        kept.first.push(...first);
      }
    }
  }
  await browser.close();
}
site.close();
console.log(renderer);
for (const [name, { ratios, first }] of results) {
  const [low, middle, high] = [0.25, 0.5, 0.75].map((share) => quantile(ratios, share).toFixed(3));
  const base = `${loops[0].name} ${quantile(first, 0.5).toFixed(3)} ms`;
  console.log(`${name.padEnd(36)} ${middle} (${low}–${high}) of ${base}`);
}

/** @param {readonly number[]} numbers @param {number} share */
function quantile(numbers, share) {
  const sorted = [...numbers].sort((a, b) => a - b);
  return sorted[Math.floor(share * (sorted.length - 1))] ?? NaN;
}

/** Before and after. */
async function texts() {
  if (options.texts !== '' && existsSync(options.texts))
    return JSON.parse(readFileSync(options.texts, 'utf8'));
  const folder = join(mkdtempSync(join(tmpdir(), 'phong-viewer-')), 'before');
  execFileSync('git', ['worktree', 'add', '--detach', folder, options.before], {
    cwd: repository,
    stdio: 'ignore',
  });
  try {
    const both = [];
    for (const { name, root } of [
      { name: 'before', root: folder },
      { name: 'after', root: repository },
    ]) {
      const glsl = await loopText(root);
      both.push({ name, glsl, main: mainOf(glsl) });
    }
    if (options.texts !== '') writeFileSync(options.texts, JSON.stringify(both));
    return both;
  } finally {
    execFileSync('git', ['worktree', 'remove', '--force', folder], { cwd: repository });
  }
}

/** @param {string} root @returns {Promise<string>} */
async function loopText(root) {
  const { createServer } = await import('vite');
  const server = await createServer({
    root,
    configFile: false,
    logLevel: 'error',
    optimizeDeps: { noDiscovery: true },
    server: { middlewareMode: true, watch: null },
  });
  const { LIGHT_LOOP_GLSL } = await server.ssrLoadModule('/src/material/light-loop-glsl.ts');
  await server.close();
  return LIGHT_LOOP_GLSL;
}

async function builtPage() {
  const { build } = await import('vite');
  const outDir = mkdtempSync(join(tmpdir(), 'phong-viewer-'));
  await build({
    root: join(repository, 'tests/bench/page'),
    configFile: false,
    base: './',
    logLevel: 'warn',
    build: { outDir, emptyOutDir: true, target: 'es2022', modulePreload: { polyfill: false } },
  });
  return outDir;
}
