// @ts-check
// CPU time that a browser's processes have used, from Linux's scheduler: steady where wall time is not, because it does
// not count waiting for other programs. Knows nothing of pages.

import { readdirSync, readFileSync } from 'node:fs';

/** Seconds on a CPU since the start, over all threads. @param {number} process its id */
export function cpuSeconds(process) {
  const folder = `/proc/${process}/task`;
  return readdirSync(folder).reduce((sum, thread) => sum + threadSeconds(`${folder}/${thread}`), 0);
}

/** The same of a process's first thread alone: in a page's process the one that runs its JavaScript. @param {number} process */
export const mainThreadSeconds = (process) => threadSeconds(`/proc/${process}/task/${process}`);

/** @param {string} folder */
function threadSeconds(folder) {
  try {
    return Number(readFileSync(`${folder}/schedstat`, 'utf8').split(' ')[0]) / 1e9;
  } catch {
    return 0; // the thread has just ended
  }
}

/** Whether this system tells. */
export function tellsCpuTime() {
  try {
    readFileSync('/proc/self/schedstat');
    return true;
  } catch {
    return false;
  }
}

/**
 * Ids of a browser's processes of one type: `GPU`, `renderer` (pages), `browser`.
 * @param {import('playwright-core').Browser} browser @param {string} type
 * @returns {Promise<number[]>}
 */
export async function processesOf(browser, type) {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  await session.detach();
  return processInfo.filter((info) => info.type === type).map(({ id }) => id);
}

/**
 * The process whose first thread runs this page: the one that works while the page does.
 * @param {import('playwright-core').Browser} browser @param {import('playwright-core').Page} page
 */
export async function processOfPage(browser, page) {
  const pages = await processesOf(browser, 'renderer');
  const before = pages.map(mainThreadSeconds);
  await page.evaluate(() => {
    const end = performance.now() + 100;
    while (performance.now() < end);
  });
  const used = pages.map((id, i) => mainThreadSeconds(id) - (before[i] ?? 0));
  const busiest = pages[used.indexOf(Math.max(...used))];
  if (busiest === undefined) throw new Error('the browser names no process of a page');
  return busiest;
}
