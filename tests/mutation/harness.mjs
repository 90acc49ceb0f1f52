// @ts-check
// The stress harness in a real browser against one mutant: the first sentence of its verdict that no longer holds.

import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { build } from 'vite';
import { ensureBrowser, softwareGl } from '../../.ci/browser.mjs';
import { serveFolder } from '../stress/serve-folder.mjs';
import { mutantPlugin } from './vite-mutant.mjs';

/** @typedef {import('../glsl/page/page.js').Report} Report */
/** @typedef {import('../glsl/worst-driver.js').Driver} Driver */

const repository = fileURLToPath(new URL('../..', import.meta.url));
const SEED = 1;

const DRIVERS = /** @type {const} */ (['shipped', 'either', 'up', 'down']);

/**
 * Most mutants are dead after few cases on the browser's own driver; the others meet the worst ones, and then many cases.
 * @type {readonly { driver: Driver, cases: number }[]}
 */
export const RUNGS = [
  { driver: 'shipped', cases: 4e3 },
  ...[2e4, 2e5].flatMap((cases) => DRIVERS.map((driver) => ({ driver, cases }))),
];

/** @typedef {{ sentence: string, driver: Driver, cases: number }} Broken */

/** @param {boolean} quick few cases alone */
export async function startHarness(quick = false) {
  const rungs = quick ? RUNGS.slice(0, 5) : RUNGS;
  const browser = await chromium.launch({
    executablePath: await ensureBrowser(),
    args: softwareGl,
  });
  const page = await browser.newPage();
  // A page is loaded once its first passes have been drawn: on a busy machine that takes a while.
  page.setDefaultNavigationTimeout(0);
  const scratch = mkdtempSync(join(tmpdir(), 'phong-viewer-mutation-'));
  const shipped = await serveFolder(await built(join(scratch, 'shipped'), null));

  return {
    /**
     * Runs a GLSL mutant through the shipped harness.
     * @param {import('./mutants.mjs').Mutant | null} mutant
     */
    glsl: (mutant) => climb(shipped.origin, mutant === null ? null : { from: mutant.from, to: mutant.to }),
    /**
     * Runs a TypeScript mutant through a harness built with it.
     * @param {import('./mutants.mjs').Mutant} mutant
     */
    async typescript(mutant) {
      const site = await serveFolder(await built(join(scratch, 'mutant'), mutant));
      const broken = await climb(site.origin, null);
      site.close();
      return broken;
    },
    async close() {
      await browser.close();
      shipped.close();
      rmSync(scratch, { recursive: true });
    },
  };

  /**
   * @param {string} origin
   * @param {{ from: string, to: string } | null} edit
   * @returns {Promise<Broken | null>}
   */
  async function climb(origin, edit) {
    for (const { driver, cases } of rungs) {
      const query = new URLSearchParams({ driver, cases: String(cases), seed: String(SEED) });
      if (edit !== null) query.set('edit', JSON.stringify(edit));
      await page.goto(`${origin}/index.html?${query}`);
      const { error, broken } = /** @type {Report} */ (await page.evaluate(() => window.finished));
      // The worst drivers do not know every built-in that an edit may bring; the browser's own has to.
      if (error !== null && driver !== 'shipped' && error.startsWith('no allowance')) return null;
      if (error !== null) throw new Error(error);
      if (broken[0] !== undefined) return { sentence: withoutNumbers(broken[0]), driver, cases };
    }
    return null;
  }
}

/** What is measured differs from machine to machine in its last digits. @param {string} sentence */
function withoutNumbers(sentence) {
  const at = sentence.lastIndexOf(': ');
  const [title, verdict] = [sentence.slice(0, at), sentence.slice(at + 2)];
  if (verdict.includes('not finite')) return `${title}: not finite`;
  if (verdict.includes('exact')) return `${title}: inexact codes`;
  return `${title}: error above its bound`;
}

/** @param {string} folder @param {import('./mutants.mjs').Mutant | null} mutant */
async function built(folder, mutant) {
  await build({
    configFile: join(repository, 'vite.harness.config.ts'),
    logLevel: 'error',
    build: { outDir: folder, minify: false },
    plugins: mutant === null ? [] : [mutantPlugin(mutant)],
  });
  return folder;
}
