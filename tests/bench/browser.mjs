// @ts-check
// Fresh launches of one Chromium on the built pages, and the CPU time that its processes use:
// steady where wall time is not, because it leaves out waiting for other programs. Knows no
// subject.

import { readdirSync, readFileSync } from 'node:fs';
import { cpus, release } from 'node:os';
import { serveFolder } from '../support/built-pages.mjs';
import { builtFrom } from './build.mjs';

/**
 * @typedef {import('playwright-core').Browser} Browser @typedef {import('playwright-core').Page}
 * Page
 */

/** No launch finds programs that an earlier one compiled. */
const FLAGS = ['--disable-gpu-program-cache', '--disable-gpu-shader-disk-cache'];

/**
 * A CPU draws: a GPU's timer says nothing there. @param {string} renderer the driver's name for
 * itself
 */
export const isSoftware = (renderer) =>
  /SwiftShader|llvmpipe|Software|Basic Render/i.test(renderer);

export class Lab {
  /** @type {import('playwright-core').LaunchOptions} */
  #options;
  /** @type {Awaited<ReturnType<typeof serveFolder>> | undefined} */
  #site;
  /** @type {Browser | null} */
  #browser = null;
  /** Folder of built pages. */
  folder;
  /** Whether files that are kept in brotli too are sent so, as over a network. */
  compresses = false;

  /** @param {string} folder @param {import('playwright-core').LaunchOptions} options */
  constructor(folder, options) {
    this.folder = folder;
    this.#options = options;
  }

  async open() {
    this.#site = await serveFolder(this.folder, () => this.compresses);
  }

  get origin() {
    return this.#site?.origin ?? '';
  }

  /** A fresh browser; the one before is closed. @returns {Promise<Browser>} */
  async launch() {
    await this.#browser?.close();
    const args = [...(this.#options.args ?? []), ...FLAGS];
    const { chromium } = await import('playwright-core');
    this.#browser = await chromium.launch({ ...this.#options, args });
    return this.#browser;
  }

  async close() {
    await this.#browser?.close();
    this.#site?.close();
  }

  /** Where a result was measured. */
  async machine() {
    const browser = await this.launch();
    const page = await browser.newPage();
    const renderer = await page.evaluate(() => {
      const gl = document.createElement('canvas').getContext('webgl2');
      const info = gl?.getExtension('WEBGL_debug_renderer_info');
      return String(info && gl?.getParameter(info.UNMASKED_RENDERER_WEBGL));
    });
    return {
      renderer,
      browser: `Chromium ${browser.version()}`,
      cpu: `${cpus().length} × ${cpus()[0]?.model ?? 'unknown'}`,
      system: `${process.platform} ${release()}`,
      ...builtFrom(this.folder).versions,
    };
  }
}

/**
 * A page whose errors make the measurement fail: the time of a broken page means nothing.
 * @param {Browser} browser @param {string} url @param {readonly [number, number]} size @param
 * {number} [ratio] device pixels per CSS pixel
 * @returns {Promise<{ page: Page, check: () => void }>}
 */
export async function openPage(browser, url, [width, height], ratio = 1) {
  const page = await browser.newPage({ viewport: { width, height }, deviceScaleFactor: ratio });
  /** @type {string[]} */
  const errors = [];
  page.on('console', (message) => {
    if (message.type() === 'error') {
      errors.push(message.text());
    }
  });
  page.on('pageerror', (error) => errors.push(String(error)));
  await page.goto(url);
  return {
    page,
    check() {
      if (errors.length > 0) throw new Error(errors.join('; '));
    },
  };
}

/** Seconds on a CPU, over all threads of a process. @param {number} id */
export function cpuSeconds(id) {
  const folder = `/proc/${id}/task`;
  return readdirSync(folder).reduce((sum, thread) => sum + threadSeconds(`${folder}/${thread}`), 0);
}

/** @param {string} folder */
function threadSeconds(folder) {
  try {
    return Number(readFileSync(`${folder}/schedstat`, 'utf8').split(' ')[0]) / 1e9;
  } catch {
    return 0; // the thread has just ended
  }
}

/** Whether this system says how much CPU time a thread has used. */
function hasCpuTime() {
  try {
    readFileSync('/proc/self/schedstat');
    return true;
  } catch {
    return false;
  }
}

/**
 * Ids of a browser's processes of one type. @param {Browser} browser @param {'GPU' | 'renderer'}
 * type
 */
export async function processesOf(browser, type) {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  await session.detach();
  return processInfo.filter((info) => info.type === type).map(({ id }) => id);
}

/** The GPU process; null where CPU time is unknown. @param {Browser} browser */
export const gpuProcess = async (browser) =>
  hasCpuTime() ? ((await processesOf(browser, 'GPU'))[0] ?? null) : null;

/**
 * Milliseconds that frames take: the GPU's own, or where a CPU draws the CPU time of the GPU
 * process.
 * @param {string} renderer @param {number | null} gpu see {@link gpuProcess}
 * @param {() => Promise<number>} time by the GPU's timer @param {() => Promise<number>} draw by the
 * clock
 */
export async function frameTime(renderer, gpu, time, draw) {
  if (!isSoftware(renderer)) return time();
  if (gpu === null) return draw();
  const before = cpuSeconds(gpu);
  await draw();
  return (cpuSeconds(gpu) - before) * 1000;
}

/**
 * Reads the CPU time of a page's main thread so far, in milliseconds, from the browser's own
 * counters.
 * @param {Page} page @returns {Promise<() => Promise<number>>}
 */
export async function mainThreadTime(page) {
  const session = await page.context().newCDPSession(page);
  await session.send('Performance.enable', { timeDomain: 'threadTicks' });
  return async () => {
    const { metrics } = await session.send('Performance.getMetrics');
    return 1000 * (metrics.find(({ name }) => name === 'TaskDuration')?.value ?? NaN);
  };
}
