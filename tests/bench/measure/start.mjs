// @ts-check
// How long pages take from navigation to their first picture, and what they keep in memory then: a
// fresh browser for each page, nothing cached, in turns.

import { inTurns } from '../statistics.mjs';

const SIZE = { width: 1280, height: 800 };
const PATIENCE_MS = 60_000;
/** From the first picture until the heap is read: what the page prepares by then is part of it. */
const REST_MS = 500;

/**
 * One launch of each page.
 * @param {import('../browser.mjs').Lab} lab @param {import('../subjects.mjs').StartSubject} subject
 * @param {number} launch
 * @param {Pick<import('./frames.mjs').Options, 'rounds' | 'add'>} options
 */
export async function measureStart(lab, { pages, pageSays = false }, launch, { rounds, add }) {
  for (let round = 0; round < rounds; round++) {
    await measureInTurns(
      pages,
      launch + round,
      (path) => startOf(lab, path, pageSays),
      MEASURES,
      add,
    );
  }
}

/** @type {Measures<Awaited<ReturnType<typeof startOf>>>} */
const MEASURES = [
  ['first picture', 'ms', 'ms'],
  ['heap', 'KiB', 'heap'],
];

/**
 * @template T
 * @typedef {readonly (readonly [measure: string, unit: string, key: keyof T])[]} Measures
 */

/**
 * Loads one page after the other, every other round backwards, and adds each figure that all of
 * them have.
 * @template {Record<keyof T, number>} T
 * @param {Readonly<Record<string, string>>} pages by side @param {number} round
 * @param {(path: string) => Promise<T>} load its figures are NaN where the system does not say
 * @param {Measures<T>} measures @param {import('./frames.mjs').Options['add']} add
 */
export async function measureInTurns(pages, round, load, measures, add) {
  const sides = Object.keys(pages);
  /** @type {Record<string, T>} */
  const loads = {};
  for (const side of inTurns(sides, round)) {
    loads[side] = await load(pages[side] ?? '');
  }
  for (const [measure, unit, key] of measures) {
    const values = sides.map((side) => /** @type {const} */ ([side, loads[side]?.[key] ?? NaN]));
    if (values.every(([, value]) => !Number.isNaN(value))) {
      add(measure, unit, Object.fromEntries(values));
    }
  }
}

/** @param {import('../browser.mjs').Lab} lab @param {string} path @param {boolean} pageSays */
async function startOf(lab, path, pageSays) {
  const browser = await lab.launch();
  await startGpuProcess(browser);
  const page = await browser.newPage({ viewport: SIZE });
  if (!pageSays) {
    await page.addInitScript(watchFirstPicture);
  }
  await page.goto(`${lab.origin}/${path}`, { waitUntil: 'commit' });
  const waiting = { polling: 20, timeout: PATIENCE_MS };
  await page.waitForFunction(() => window.firstPicture !== undefined, undefined, waiting);
  const ms = await page.evaluate(() => Number(window.firstPicture));
  await page.waitForTimeout(REST_MS);
  return { ms, heap: await heapOf(page) };
}

/**
 * It belongs to the browser's start, not to the page's. @param {import('playwright-core').Browser}
 * browser
 */
export async function startGpuProcess(browser) {
  const page = await browser.newPage();
  await page.evaluate(() => {
    const gl = document.createElement('canvas').getContext('webgl2');
    gl?.clear(gl.COLOR_BUFFER_BIT);
    gl?.finish();
  });
  await page.close();
}

/** In KiB. @param {import('playwright-core').Page} page */
async function heapOf(page) {
  const session = await page.context().newCDPSession(page);
  await session.send('HeapProfiler.collectGarbage');
  await session.send('HeapProfiler.collectGarbage'); // frees what the first one's finalizers released
  const { usedSize } = await session.send('Runtime.getHeapUsage');
  await session.detach();
  return usedSize / 1024;
}

/**
 * Runs in the page before its own scripts. Notes when a picture is there: after the task that
 * draws, a row of pixels near the canvas's centre is read back, and not all of it is transparent.
 */
function watchFirstPicture() {
  const prototype = WebGL2RenderingContext.prototype;
  const names = /** @type {const} */ ([
    'drawElements',
    'drawArrays',
    'drawElementsInstanced',
    'drawArraysInstanced',
  ]);
  const originals = names.map((name) => prototype[name]);
  let waiting = false;
  /** @param {WebGL2RenderingContext} gl */
  const look = (gl) => {
    waiting = false;
    const target = gl.getParameter(gl.READ_FRAMEBUFFER_BINDING);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, null);
    const row = new Uint8Array(4 * gl.drawingBufferWidth);
    const y = Math.round(0.55 * gl.drawingBufferHeight);
    gl.readPixels(0, y, gl.drawingBufferWidth, 1, gl.RGBA, gl.UNSIGNED_BYTE, row);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, target);
    if (row.every((channel) => channel === 0)) return;
    window.firstPicture = performance.now();
    names.forEach((name, i) => Object.assign(prototype, { [name]: originals[i] }));
  };
  names.forEach((name, i) =>
    Object.assign(prototype, {
      /** @this {WebGL2RenderingContext} @param {unknown[]} args */
      [name](...args) {
        if (!waiting) {
          queueMicrotask(() => look(this));
        }
        waiting = true;
        return Reflect.apply(
          /** @type {(...args: unknown[]) => void} */ (originals[i]),
          this,
          args,
        );
      },
    }),
  );
}
