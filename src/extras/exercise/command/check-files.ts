// `npx phong-viewer check PAGE FILES`: runs learners' functions in the exercise of a page, with the
// installed Playwright and its browser, one page for all.
import { readFileSync, statSync } from 'node:fs';
import { dirname, relative, resolve, sep } from 'node:path';
// Takes 50%.png as it is, where decodeURIComponent throws.
import { unescape as decoded } from 'node:querystring';
import { setTimeout as after } from 'node:timers/promises';
import { parseArgs } from 'node:util';
import type { Browser, Locator } from '@playwright/test';
import type { Outcome } from '../check.js';

export const HELP = `Usage: phong-viewer check PAGE.html FILES.glsl [options]

Runs each function in the <phong-exercise> of the page, and writes a line for each: right, or
its mistakes, the share of right pixels, and the worst pixel with both colours (255 is full).
It uses the installed @playwright/test and its browser.

  --csv             comma-separated, with a heading
  --exercise ID     the exercise with this id; without it, the page's first
  --browser PATH    another browser of Chromium's kind

Status: 0 if all are right, 1 if one is not, 2 for wrong options or a page without an exercise.`;

interface Result extends Outcome {
  /** Why there is no verdict; empty where there is one. */
  readonly fault: string;
}

const say = (line: string) => process.stdout.write(`${line}\n`);

/** The status of the command. */
export const run = (args: readonly string[]): Promise<number> =>
  checkFiles(args).catch((error: unknown) => {
    // Playwright says what to install, and adds pages of logs.
    const [words] = (error as Error).message.split(/\n\w+ logs?:/);
    process.stderr.write(`${words!} See phong-viewer check --help.\n`);
    return 2;
  });

async function checkFiles(args: readonly string[]): Promise<number> {
  const { values, positionals } = parseArgs({
    args: [...args],
    allowPositionals: true,
    options: {
      csv: { type: 'boolean' },
      exercise: { type: 'string' },
      browser: { type: 'string' },
      help: { type: 'boolean', short: 'h' },
    },
  });
  if (values.help) {
    say(HELP);
    return 0;
  }
  const [page, ...files] = positionals;
  if (page === undefined || files.length === 0) throw new Error('Name a page and files.');
  for (const file of positionals) {
    if (!isFile(file)) throw new Error(`There is no file ${file}.`);
  }
  // An id may be a number.
  const id = values.exercise === undefined ? '' : `[id=${JSON.stringify(values.exercise)}]`;
  const selector = `phong-exercise${id}`;
  const browser = await launch(values.browser);
  let isWell = true;
  try {
    let exercise = await openExercise(browser, page, selector);
    if (values.csv) {
      say('file,right,mistakes,share,x,y,found,exact,fault');
    }
    for (const file of files) {
      const result = await Promise.race([
        exercise.evaluate(runInPage, readFileSync(file, 'utf8')),
        after(60_000, NO_ANSWER, { ref: false }), // for one function, its picture included
      ]).catch(() => NO_ANSWER);
      if (result === NO_ANSWER) {
        // The function may have taken the page with it.
        await exercise.page().close();
        exercise = await openExercise(browser, page, selector);
      }
      isWell &&= result.right;
      say(values.csv ? csvLine(file, result) : line(file, result));
    }
  } finally {
    await browser.close();
  }
  return isWell ? 0 : 1;
}

const NO_ANSWER: Result = {
  right: false,
  mistakes: [],
  share: 0,
  pixel: null,
  fault: 'the page did not answer',
};

async function launch(executablePath: string | undefined): Promise<Browser> {
  const playwright = await import('@playwright/test').catch(() => {
    throw new Error('check needs @playwright/test: npm install @playwright/test.');
  });
  return playwright.chromium.launch({
    // Machines for marking have no GPU.
    args: ['--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'],
    ...(executablePath !== undefined && { executablePath }),
  });
}

/** Of the page and what lies beside and below: modules do not load from disk. */
const ORIGIN = 'http://localhost';

const isFile = (path: string) => statSync(path, { throwIfNoEntry: false })?.isFile() === true;

async function openExercise(browser: Browser, file: string, selector: string): Promise<Locator> {
  const root = resolve(file).startsWith(resolve() + sep) ? resolve() : dirname(resolve(file));
  const page = await browser.newPage();
  const missing: string[] = [];
  await page.route(`${ORIGIN}/**`, async (route) => {
    const { pathname } = new URL(route.request().url());
    const path = resolve(root, `.${decoded(pathname)}`);
    const isThere = path.startsWith(root + sep) && isFile(path);
    if (!isThere) {
      missing.push(` There is no file ${path}.`);
    }
    await route.fulfill(isThere ? { path } : { status: 404 });
  });
  await page.goto(`${ORIGIN}/${relative(root, file).split(sep).map(encodeURIComponent).join('/')}`);
  const exercise = page.locator(selector).first();
  try {
    // It may be in a part of the page that is closed.
    await exercise.locator('textarea').waitFor({ state: 'attached', timeout: 20_000 });
  } catch {
    throw new Error(`The page shows no ${selector}.${missing[0] ?? ''}`);
  }
  return exercise;
}

/** Sent into the page, so it uses nothing from outside. */
async function runInPage(element: Element, source: string): Promise<Result> {
  const exercise = element as HTMLElement & { value: string };
  exercise.value = source;
  const root = exercise.shadowRoot!;
  const checked = new Promise<CustomEvent<Outcome>>((resolve) => {
    exercise.addEventListener('check', (event) => resolve(event as never), { once: true });
  });
  root.querySelector('button')!.click();
  const { detail } = await checked;
  // The sentences follow the event.
  await new Promise((resolve) => setTimeout(resolve));
  const fault = root.querySelector('#faults')!.textContent.replace(/\s+/g, ' ').trim();
  return { ...detail, fault };
}

function line(file: string, { right, mistakes, share, fault, pixel }: Result): string {
  if (fault !== '') return `${file}: ${fault}`;
  const where = pixel
    ? `; pixel ${pixel.x}, ${pixel.y}: ${pixel.found.join(' ')} for ${pixel.exact.join(' ')}`
    : '';
  const what = right ? 'right' : mistakes.join(' + ') || 'wrong in another way';
  return `${file}: ${what}; ${(100 * share).toFixed(1)} % of the pixels${where}`;
}

function csvLine(file: string, { right, mistakes, share, fault, pixel }: Result): string {
  const colors = [pixel?.found, pixel?.exact].map((color) => color?.join(' '));
  return [file, right, mistakes.join(' '), share.toFixed(4), pixel?.x, pixel?.y, ...colors, fault]
    .map((cell = '') => {
      // A spreadsheet would run what begins so.
      const text = String(cell).replace(/^(?=[=+@\t\r-])/, "'");
      return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
    })
    .join(',');
}
