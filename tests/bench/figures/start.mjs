// @ts-check
// How long a page takes to its first picture, and what it keeps in memory then: fresh browser, fresh context, nothing
// cached, in turns. Wall time from navigation, and CPU time of the page's and the GPU's process, which a busy machine disturbs less.

import { cpuSeconds, processesOf, tellsCpuTime } from '../processes.mjs';
import { failOnErrors } from '../session.mjs';

/** No program of an earlier page is found compiled, no timer is coarse. */
const FLAGS = ['--disable-gpu-program-cache', '--disable-gpu-shader-disk-cache'];

/** @typedef {{ ms: number, pageMs: number, gpuMs: number, heap: number, bytes: number }} Start CPU time of the page's process and of the GPU's, heap and bytes in KiB; bytes as fetched */

/**
 * @param {import('../session.mjs').Session} session @param {string} path
 * @param {{ check?: (page: import('playwright-core').Page) => Promise<void> }} [more]
 * @returns {Promise<Start>}
 */
export async function startOf(session, path, { check } = {}) {
  const { browser, page } = await freshPage(session);
  const failed = failOnErrors(page);
  const before = await busySeconds(browser);
  await page.goto(`${session.origin}/${path}`, { waitUntil: 'commit' });
  await page.waitForFunction(() => window.firstPicture !== undefined, undefined, {
    polling: 20,
    timeout: 120_000,
  });
  const after = await busySeconds(browser);
  const { ms, bytes } = await page.evaluate(() => ({
    ms: Number(window.firstPicture),
    bytes: performance
      .getEntriesByType('resource')
      .reduce((sum, entry) => sum + /** @type {PerformanceResourceTiming} */ (entry).encodedBodySize, 0),
  }));
  const heap = await heapOf(page);
  failed();
  await check?.(page);
  await browser.close();
  return {
    ms,
    pageMs: (after.page - before.page) * 1000,
    gpuMs: (after.gpu - before.gpu) * 1000,
    heap,
    bytes: bytes / 1024,
  };
}

/** @param {import('../session.mjs').Session} session @param {string[]} [more] the browser's arguments */
export async function freshPage(session, more = []) {
  const browser = await session.launch([...FLAGS, ...more]);
  // The GPU process is up before: it is the browser's start, not the page's.
  const warm = await browser.newPage();
  await warm.evaluate(() => {
    const gl = document.createElement('canvas').getContext('webgl2');
    gl?.clear(gl.COLOR_BUFFER_BIT);
    gl?.finish();
  });
  await warm.close();
  return { browser, page: await browser.newPage({ viewport: { width: 1280, height: 800 } }) };
}

/** What the page keeps, in KiB. @param {import('playwright-core').Page} page */
export async function heapOf(page) {
  const debug = await page.context().newCDPSession(page);
  await debug.send('HeapProfiler.collectGarbage');
  await debug.send('HeapProfiler.collectGarbage'); // what the first one's finalizers let go of
  const { usedSize } = await debug.send('Runtime.getHeapUsage');
  await debug.detach();
  return usedSize / 1024;
}

/** CPU time of all pages and of the GPU process. @param {import('playwright-core').Browser} browser */
export async function busySeconds(browser) {
  if (!tellsCpuTime()) return { page: NaN, gpu: NaN };
  /** @param {string} type */
  const of = async (type) =>
    (await processesOf(browser, type)).reduce((sum, process) => sum + cpuSeconds(process), 0);
  return { page: await of('renderer'), gpu: await of('GPU') };
}

/**
 * All of a tag's elements show something at their centre.
 * @param {import('playwright-core').Page} page @param {string} tag @param {number} count
 */
export async function allShown(page, tag, count) {
  const colors = await middlesOf(page, tag);
  const shown = colors.filter((color) => color.some((channel) => channel < 255)).length; // not the page's white
  if (shown !== count) throw new Error(`${shown} of ${count} ${tag} show something`);
}

/**
 * What all of a tag's elements show at their centre, by a screenshot that the page itself decodes.
 * @param {import('playwright-core').Page} page @param {string} tag
 */
export async function middlesOf(page, tag) {
  const picture = (await page.screenshot()).toString('base64');
  return page.evaluate(async ([data, name]) => {
    const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = canvas.getContext('2d');
    context?.drawImage(bitmap, 0, 0);
    return [...document.querySelectorAll(name)].map((element) => {
      const { left, top, width, height } = element.getBoundingClientRect();
      const [r = 255, g = 255, b = 255] =
        context?.getImageData(left + width / 2, top + height / 2, 1, 1).data ?? [];
      return /** @type {const} */ ([r, g, b]);
    });
  }, /** @type {const} */ ([picture, tag]));
}
