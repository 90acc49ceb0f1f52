// @ts-check
// Measures what accuracy costs in a browser, by the site's own page, into one JSON for each stack.
// Needs the built site and playwright-core alone, so that it runs on any machine with a browser.

import { existsSync, writeFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { launchOptions, serveFolder } from '../support/built-pages.mjs';
import { numberOption, readCommandLine, refuse } from '../support/command-line.mjs';
import { accuracySentence } from './accuracy-words.mjs';

const USAGE = `
node tests/bench/accuracy.mjs [options]: what does accuracy cost in this browser?
  --out FILE       writes the result, such as tests/bench/accuracy/NAME.json; then npm run bench:report
  --seconds N      for each of three exponents; default 20
  --browser PATH   another Chromium, with its own --arg=--use-angle=vulkan --arg=...; default software GL
  --pages DIR      the built site; default site
  --help`;

const { values: options } = readCommandLine(USAGE, {
  out: { type: 'string', default: '' },
  seconds: { type: 'string', default: '20' },
  browser: { type: 'string', default: '' },
  arg: { type: 'string', multiple: true, default: [] },
  pages: { type: 'string', default: 'site' },
});
const seconds = numberOption('seconds', options.seconds, 0.1);
if (!existsSync(join(options.pages, 'bench/index.html'))) {
  refuse(`There is no built site in ${options.pages}: run \`npm run build:site\``);
}

const { chromium } = await import('playwright-core');
const site = await serveFolder(options.pages);
const browser = await chromium.launch(await launchOptions(options.browser, options.arg));
const page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
await page.goto(`${site.origin}/bench/index.html?seconds=${seconds}`);
await page.getByRole('button', { name: 'Measure' }).click();
const state = page.locator('#state').filter({ hasText: /^(Done|It ended|Nothing can)/ });
await state.waitFor({ timeout: 1000 * (120 + 30 * seconds) });
const said = await state.textContent();
const json = await page.locator('#json').inputValue();
await browser.close();
site.close();
if (json === '') {
  throw new Error(said?.split('\n')[0]);
}
/** @type {import('./accuracy-words.mjs').Accuracy} */
const accuracy = JSON.parse(json);
console.log(accuracy.renderer);
console.log(accuracySentence(accuracy));
for (const { way, exponent, ms, time, error } of accuracy.points) {
  console.log(
    `${way.padEnd(10)} n ${String(exponent).padStart(6)}: ${ms.toFixed(3)} ms, ${time.toFixed(2)} of plain, error ${error}`,
  );
}
if (options.out !== '') {
  writeFileSync(options.out, `${JSON.stringify(accuracy, null, 1)}\n`);
  console.log(basename(options.out));
}
