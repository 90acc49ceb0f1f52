// @ts-check
// One peer's page opened in a fresh browser and watched from outside: when all its viewers are lit, at what cost, and what it
// does afterwards. No page may ask another host for anything: names are not even looked up.

import { readFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { failOnErrors } from '../session.mjs';
import { litCount } from './peer-row.mjs';
import { busySeconds, freshPage, heapOf, middlesOf } from './start.mjs';
import { watchContexts, watchWork } from './watch.mjs';

const NO_OTHER_HOST = '--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE localhost';

/** Longer than any peer took where all its viewers were lit in the end. */
const LONGEST_MS = 60_000;
/** Where contexts were lost, and as many viewers have come as there are contexts left, no other comes after so long. */
const LAST_MS = 4_000;
/** A page whose contexts are lost goes blank after it has said that all is there. */
const BLANK_MS = 500;
/** After the first picture: fades, prompts and programs from the background have ended. */
const SETTLED_MS = 3_000;

/**
 * @typedef {object} PeerPage
 * @property {string} name as its users call it
 * @property {string} page pages/peer-PAGE.html
 * @property {string} tag of its viewers
 * @property {string} from which of the versions that the pages were built from is its
 *
 * @typedef {{ frames: number, draws: number, timers: number }} Work callbacks and calls
 *
 * @typedef {object} Opened
 * @property {number} ms from navigation until all were there by the page's own account; NaN where it never said so
 * @property {readonly import('./peer-row.mjs').Rgb[]} middles what each viewer shows in its middle
 * @property {number} pageMs CPU time of the page's process
 * @property {number} gpuMs CPU time of the GPU's
 * @property {number} heap KiB after garbage collection
 * @property {number} bytes KiB of all answers, as this server sends them: uncompressed
 * @property {number} gzipped KiB of the same, those that are text or programs compressed
 * @property {number} contexts that the page holds and that are not lost
 * @property {number} lost contexts
 * @property {Work} idle a second's, long after the picture; NaN where it was not asked for
 */

/**
 * @param {import('../session.mjs').Session} session @param {PeerPage} peer
 * @param {{ count?: number, idle?: boolean }} [how] so many small viewers, or one large one; whether to watch it idle too
 * @returns {Promise<Opened>}
 */
export async function openPeer(session, peer, { count, idle = false } = {}) {
  const { browser, page } = await freshPage(session, [NO_OTHER_HOST]);
  // A page that loses its contexts may say so as an error: for many viewers it is a finding, not a failure.
  const failed = count === undefined || idle ? failOnErrors(page) : () => {};
  const requests = requestsOf(page, session.origin);
  await page.addInitScript(watchContexts);
  if (idle) await page.addInitScript(watchWork);
  const before = await busySeconds(browser);
  const query = count === undefined ? '' : `?count=${count}`;
  await page.goto(`${session.origin}/peer-${peer.page}.html${query}`, { waitUntil: 'commit' });
  const ms = await untilShown(page);
  const after = await busySeconds(browser);
  const heap = await heapOf(page);
  await page.waitForTimeout(idle ? SETTLED_MS : BLANK_MS);
  const second = idle ? await idleSecond(page) : { frames: NaN, draws: NaN, timers: NaN };
  const middles = await middlesOf(page, peer.tag);
  const { held, lost } = await contextsOf(page);
  failed();
  const { bytes, gzipped } = requests.total(session.folder);
  await browser.close();
  if (count === undefined && litCount(middles, middles[0] ?? WHITE) !== 1)
    throw new Error(`${peer.name} shows nothing`);
  return {
    ...{ ms, middles, heap, bytes, gzipped, idle: second },
    pageMs: (after.page - before.page) * 1000,
    gpuMs: (after.gpu - before.gpu) * 1000,
    ...{ contexts: held, lost },
  };
}

/** @type {import('./peer-row.mjs').Rgb} */
const WHITE = [255, 255, 255];

/** What a page does in a second in which nothing changes. @param {import('playwright-core').Page} page @returns {Promise<Work>} */
async function idleSecond(page) {
  const start = await page.evaluate(() => ({ ...window.work, now: performance.now() }));
  await page.waitForTimeout(1000);
  const end = await page.evaluate(() => ({ ...window.work, now: performance.now() }));
  const seconds = (end.now - start.now) / 1000;
  return {
    frames: (end.frames - start.frames) / seconds,
    draws: (end.draws - start.draws) / seconds,
    timers: (end.timers - start.timers) / seconds,
  };
}

/** Milliseconds from navigation; NaN where the page will not say so any more. @param {import('playwright-core').Page} page */
async function untilShown(page) {
  const begin = Date.now();
  let last = { loaded: 0, at: begin };
  while (Date.now() - begin < LONGEST_MS) {
    const { ms, loaded } = await page.evaluate(() => ({
      ms: window.firstPicture,
      loaded: window.loadedViewers,
    }));
    if (ms !== undefined) return ms;
    if (loaded !== last.loaded) last = { loaded, at: Date.now() };
    const { held, lost } = await contextsOf(page);
    if (lost > 0 && loaded >= held && Date.now() - last.at > LAST_MS) break;
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
  return NaN;
}

/** @param {import('playwright-core').Page} page */
const contextsOf = (page) =>
  page.evaluate(() => ({
    held: window.contextsMade?.filter((context) => context.deref()?.isContextLost() === false).length ?? 0,
    lost: window.contextsLost,
  }));

/** Text and programs; pictures and fonts are compressed already. */
const COMPRESSED = new Set(['', '.html', '.css', '.js', '.svg', '.wasm', '.glb']);

/** Notes all that a page asks its server for. @param {import('playwright-core').Page} page @param {string} origin */
function requestsOf(page, origin) {
  /** @type {Set<string>} */
  const paths = new Set();
  /** @type {string[]} */
  const elsewhere = [];
  page.on('request', (request) => {
    const url = request.url();
    if (/^(data|blob):/.test(url)) return;
    if (url.startsWith(`${origin}/`)) paths.add(new URL(url).pathname);
    else elsewhere.push(url);
  });
  return {
    /** KiB as sent, and as a server that compresses would send them. @param {string} folder of the pages */
    total(folder) {
      if (elsewhere.length > 0) throw new Error(`asked another host: ${elsewhere.join(' ')}`);
      const sizes = [...paths].map((path) => {
        const file = readFileSync(join(folder, path));
        return {
          bytes: file.length,
          gzipped: COMPRESSED.has(extname(path)) ? gzipSync(file).length : file.length,
        };
      });
      return {
        bytes: sizes.reduce((sum, { bytes }) => sum + bytes, 0) / 1024,
        gzipped: sizes.reduce((sum, { gzipped }) => sum + gzipped, 0) / 1024,
      };
    },
  };
}
