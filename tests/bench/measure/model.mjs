// @ts-check
// How long a page takes from navigation to the first picture of a model, in three viewers that draw
// and show it each in their own way. So the picture is judged where all of them are alike: on the
// screen, in the frames that the browser's trace records.

import { readFileSync } from 'node:fs';
import { openPage, processesOf } from '../browser.mjs';
import { builtFrom } from '../build.mjs';
import { measureInTurns, startGpuProcess } from './start.mjs';

/** The element's size: the page shows nothing else. */
const SIZE = /** @type {const} */ ([400, 300]);
const PATIENCE_MS = 60_000;
/**
 * From the element's own word that the model is there until the screen is looked at: its picture
 * may come later.
 */
const REST_MS = 2000;
/** A fast line from home, and the way to a server in another country. */
const SLOW = { bitsPerSecond: 10e6, latencyMs: 40 };
const CATEGORIES = [
  'blink.user_timing',
  'disabled-by-default-devtools.timeline',
  'disabled-by-default-devtools.screenshot',
];

/**
 * @typedef {object} Load what one load of a page took
 * @property {number} ms until the first picture
 * @property {number} task the longest task of the page's main thread until it rests, ms
 * @property {number} memory peak of the page's process and the GPU's, MiB; NaN where the system
 * does not say
 */

/**
 * One load in each viewer.
 * @param {import('../browser.mjs').Lab} lab @param {import('../subjects.mjs').ModelSubject} subject
 * @param {number} launch
 * @param {Pick<import('./frames.mjs').Options, 'add'>} options
 */
export async function measureModel(lab, { file, pages, slow }, launch, { add }) {
  if (builtFrom(lab.folder).versions['model-viewer'] === undefined) {
    throw new Error('the other viewers were not installed when the pages were built');
  }
  const load = (/** @type {string} */ page) => loadOf(lab, `${page}?model=models/${file}`, slow);
  await measureInTurns(pages, launch, load, MEASURES, add);
}

/** @type {import('./start.mjs').Measures<Load>} */
const MEASURES = [
  ['first picture', 'ms', 'ms'],
  ['longest task', 'ms', 'task'],
  ['peak memory', 'MiB', 'memory'],
];

/**
 * @param {import('../browser.mjs').Lab} lab @param {string} path @param {boolean} slow @returns
 * {Promise<Load>}
 */
async function loadOf(lab, path, slow) {
  lab.compresses = slow;
  const browser = await lab.launch();
  await startGpuProcess(browser);
  const { page, check } = await openPage(browser, 'about:blank', SIZE);
  if (slow) {
    const session = await page.context().newCDPSession(page);
    const throughput = SLOW.bitsPerSecond / 8;
    await session.send('Network.enable');
    await session.send('Network.emulateNetworkConditions', {
      offline: false,
      latency: SLOW.latencyMs,
      downloadThroughput: throughput,
      uploadThroughput: throughput,
    });
  }
  await browser.startTracing(page, { screenshots: true, categories: CATEGORIES });
  await page.goto(`${lab.origin}/${path}`, { waitUntil: 'commit' });
  try {
    const waiting = { polling: 100, timeout: PATIENCE_MS };
    await page.waitForFunction(() => window.modelLoaded === true, undefined, waiting);
  } finally {
    check(); // says more than that time is over
  }
  let memory = NaN;
  const from = Date.now();
  do {
    await page.waitForTimeout(REST_MS);
    memory = await peakMemory(browser);
    if (Date.now() - from > PATIENCE_MS) throw new Error('the page shows no model');
  } while ((await sharesOfModel(browser, [(await page.screenshot()).toString('base64')]))[0] !== 1);
  const trace = readTrace(await browser.stopTracing());
  check();
  return { ms: await firstPicture(browser, trace.frames), task: trace.longestTask, memory };
}

/**
 * Sum of the largest resident sets that the page's process and the GPU's have had, in MiB. @param
 * {import('playwright-core').Browser} browser
 */
async function peakMemory(browser) {
  /** @param {number} id */
  const peak = (id) => {
    try {
      return (
        Number(/^VmHWM:\s*(\d+)/m.exec(readFileSync(`/proc/${id}/status`, 'utf8'))?.[1]) / 1024
      );
    } catch {
      return NaN; // no Linux
    }
  };
  const pages = (await processesOf(browser, 'renderer')).map(peak);
  const gpu = (await processesOf(browser, 'GPU')).map(peak);
  // The largest one shows the page; others wait for a next one.
  return Math.max(...pages) + Math.max(...gpu);
}

/**
 * @typedef {{ ms: number, jpeg: string }} Frame base64; milliseconds since navigation
 * @param {Buffer} file @returns {{ frames: Frame[], longestTask: number }}
 */
export function readTrace(file) {
  /**
   * @type {{ traceEvents: { name: string, pid: number, tid: number, ts: number, dur?: number, args:
   * Record<string, unknown> }[] }}
   */
  const { traceEvents } = JSON.parse(file.toString());
  const start = traceEvents.findLast(({ name, args }) => {
    const data = /** @type {{ documentLoaderURL?: string } | undefined} */ (args['data']);
    return name === 'navigationStart' && data?.documentLoaderURL?.startsWith('http') === true;
  });
  if (start === undefined) throw new Error('the trace holds no navigation');
  const after = traceEvents.filter(({ ts }) => ts >= start.ts);
  const { pid, tid } = start;
  const tasks = after.filter((one) => one.name === 'RunTask' && one.pid === pid && one.tid === tid);
  return {
    frames: after
      .filter(({ name }) => name === 'Screenshot')
      .map(({ ts, args }) => ({ ms: (ts - start.ts) / 1000, jpeg: String(args['snapshot']) })),
    longestTask: Math.max(0, ...tasks.map(({ dur = 0 }) => dur / 1000)),
  };
}

/**
 * When half of the model's pixels were there first. @param {import('playwright-core').Browser}
 * browser @param {Frame[]} frames
 */
async function firstPicture(browser, frames) {
  const pictures = frames.map(({ jpeg }) => jpeg);
  const shares = await sharesOfModel(browser, pictures);
  const first = frames[shares.findIndex((share) => share >= 0.5)];
  if (first === undefined) throw new Error('the page shows no model');
  return first.ms;
}

/**
 * The share of the model's pixels in each picture of the page, all 0 if the last one shows no
 * model.
 * @param {import('playwright-core').Browser} browser @param {string[]} pictures base64
 */
async function sharesOfModel(browser, pictures) {
  const page = await browser.newPage();
  const shares = await page.evaluate(compareWithLast, pictures);
  await page.close();
  return shares;
}

/**
 * Runs in a page. The model is where the last picture is not the background, in the middle:
 * progress bars and buttons are at the edges.
 * @param {string[]} pictures
 */
async function compareWithLast(pictures) {
  const BACKGROUND = [0, 96, 0]; // of the pages
  const DIFFERENT = 32; // more than JPEG's noise
  const covered = await Promise.all(
    pictures.map(async (picture) => {
      const bitmap = await createImageBitmap(
        await (await fetch(`data:image/png;base64,${picture}`)).blob(),
      );
      const { width, height } = bitmap;
      const context = new OffscreenCanvas(width, height).getContext('2d');
      if (context === null) throw new Error('no canvas');
      context.drawImage(bitmap, 0, 0);
      /** @param {Uint8ClampedArray} data */
      const differs = (data) =>
        Array.from({ length: data.length / 4 }, (_, i) =>
          BACKGROUND.some(
            (level, channel) => Math.abs((data[4 * i + channel] ?? 0) - level) > DIFFERENT,
          ),
        );
      const middle = context.getImageData(width >> 2, height >> 2, width >> 1, height >> 1).data;
      const corner = context.getImageData(0, height - 1, 1, 1).data;
      // The page is white before its first frame, the corner too.
      return differs(corner)[0] === true ? differs(middle).fill(false) : differs(middle);
    }),
  );
  const model = (covered.at(-1) ?? []).flatMap((shown, i) => (shown ? [i] : []));
  return covered.map((shown) => model.filter((i) => shown[i]).length / Math.max(1, model.length));
}
