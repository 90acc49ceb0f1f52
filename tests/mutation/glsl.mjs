// @ts-check
// Runs mutants of the shader chunks in browsers, one mutant at a time in each. A mutant that hangs
// or loses the context costs its browser, and counts as killed.

import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout } from 'node:timers/promises';
import { launchOptions } from '../support/built-pages.mjs';
import { glslMutants } from './glsl-mutants.mjs';
import { drawn } from './sample.mjs';
import { repository } from '../support/repository.mjs';

/** @typedef {import('./typescript.mjs').Result} Result */
/** @typedef {{ name: string, from: string, to: string }} Mutant */

/** Enough that the shipped chunks pass whatever the seed, and few enough for a mutant a second. */
const EXTENT = { seed: 1, checks: 1024, cases: 20_000 };
/** A survivor takes a tenth of it. */
const LONGEST_MS = 180_000;

/** Every chunk's file name and text: the one place that lists them. */
export const chunks = () =>
  readdirSync(join(repository, 'shaders'))
    .filter((name) => name.endsWith('.glsl'))
    .map((name) => ({ name, text: readFileSync(join(repository, 'shaders', name), 'utf8') }));

/** All mutants of a chunk. @param {{ name: string, text: string }} chunk @returns {Mutant[]} */
export function mutantsOf({ name, text }) {
  return glslMutants(text).map(({ line, what, before, after, text: to }, i) => ({
    name: `shaders/${name}:${line} #${i} ${what}: ${JSON.stringify(before)} -> ${JSON.stringify(after)}`,
    from: text,
    to,
  }));
}

/**
 * @param {{ sample: number, seed: number, jobs: number, only: string, onResult: (name: string,
 * done: number, total: number) => void }} options sample: how many mutants, all where it is 0;
 * only: a part of their names
 * @returns {Promise<{ results: Result[], notRun: string[] }>} notRun: chunks that the harness has
 * no program for
 */
export async function runGlsl({ sample, seed, jobs, only, onResult }) {
  const { createServer } = await import('vite');
  const server = await createServer({
    configFile: false,
    root: join(repository, 'tests/mutation/page'),
    logLevel: 'warn',
    server: { host: '127.0.0.1', port: 0, hmr: false, watch: null, fs: { allow: [repository] } },
  });
  await server.listen();
  const address = /** @type {import('node:net').AddressInfo} */ (server.httpServer?.address());
  const open = () => openPage(`http://127.0.0.1:${address.port}/index.html`);

  const first = await open();
  /** @type {string[]} */
  const notRun = [];
  /** @type {Mutant[]} */
  let mutants = [];
  for (const chunk of chunks()) {
    if (await first.page.evaluate((text) => window.isRun(text), chunk.text)) {
      mutants.push(...mutantsOf(chunk));
    } else {
      notRun.push(chunk.name);
    }
  }
  mutants = mutants.filter(({ name }) => name.includes(only));
  if (sample > 0) {
    mutants = mutants.sort((a, b) => drawn(a.name, seed) - drawn(b.name, seed)).slice(0, sample);
  }

  /** @type {Result[]} */
  const results = [];
  let next = 0;
  /** @param {Awaited<ReturnType<typeof openPage>>} browser */
  const work = async (browser) => {
    for (let mutant = mutants[next++]; mutant; mutant = mutants[next++]) {
      const outcome = await browser.run(mutant);
      if (outcome === null) {
        browser = await open();
      }
      const { status, by } = outcome ?? { status: 'killed', by: 'hangs or loses the context' };
      results.push({ name: mutant.name, status, by });
      onResult(mutant.name, results.length, mutants.length);
    }
    await browser.close();
  };
  const others = Array.from({ length: Math.min(jobs, mutants.length) - 1 }, async () =>
    work(await open()),
  );
  await Promise.all([work(first), ...others]);
  await server.close();
  return { results, notRun };
}

/** A browser of its own with the page in it, prepared. @param {string} address */
async function openPage(address) {
  const { chromium } = await import('playwright-core');
  const browser = await chromium.launch(await launchOptions('', []));
  const page = await browser.newPage();
  await page.goto(address);
  await page.waitForFunction(() => 'tryMutant' in window);
  await page.evaluate((extent) => window.prepare(extent), EXTENT);
  return {
    page,
    close: () => browser.close(),
    /** Null where the page did not survive. @param {Mutant} mutant */
    async run({ from, to }) {
      const late = setTimeout(LONGEST_MS, null, { ref: false });
      const given = { edit: { from, to }, extent: EXTENT };
      const tried = page
        .evaluate(({ edit, extent }) => window.tryMutant(edit, extent), given)
        .catch(() => null);
      const outcome = /** @type {Omit<Result, 'name'> | null} */ (
        await Promise.race([tried, late])
      );
      if (outcome === null) {
        await browser.close();
      }
      return outcome;
    },
  };
}
