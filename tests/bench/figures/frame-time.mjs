// @ts-check
// Frame time of the element against peers that draw the same mesh under the same lights, each on a page of its own in one
// browser, in turns. In software the time is the CPU time of the browser's GPU process, on a GPU its own timer's.

import { cpuSeconds } from '../processes.mjs';
import { isSoftware } from '../sampling.mjs';
import { failOnErrors, gpuProcess } from '../session.mjs';
import { interleaved } from '../statistics.mjs';

/**
 * @typedef {object} Scene
 * @property {string} name
 * @property {number} lights declared
 * @property {number} active
 * @property {'mixed' | 'directional' | 'point' | 'spot'} kind
 *
 * @typedef {object} Subject
 * @property {string} name
 * @property {string} peer a peer's name; `raw` draws what the first subject draws, without any library
 * @property {1} [samples] a pixel, where the page chooses; else multisampled, as the element is
 * @property {Scene} [scene] where it differs from the others' scene
 *
 * @typedef {object} FrameOptions
 * @property {number} launches
 * @property {number} rounds
 * @property {number} width
 * @property {number} height
 * @property {number} seed
 * @property {number} sampleMs least time of a sample of the fastest subject
 *
 * @typedef {{ frames: number, programs: number, most: number }} Settled
 * @typedef {{ name: string, ms: number[], settled: Settled[] }} SubjectTimes milliseconds a frame
 */

/**
 * @param {import('../session.mjs').Session} session
 * @param {Scene} scene @param {readonly Subject[]} subjects @param {FrameOptions} options
 * @returns {Promise<SubjectTimes[]>}
 */
export async function frameTimes(session, scene, subjects, options) {
  /** @type {SubjectTimes[]} */
  const times = subjects.map(({ name }) => ({ name, ms: [], settled: [] }));
  for (let launch = 0; launch < options.launches; launch++) {
    const browser = await session.launch();
    /** @type {OpenPeer[]} */
    const open = [];
    for (const subject of subjects) {
      const peer = await openPeer(session, browser, subject, scene, options, open[0]);
      open.push(peer);
      times[open.length - 1]?.settled.push(peer.settled);
    }
    const samples = await timeInTurns(open, await gpuProcess(browser), options);
    samples.forEach((ms, i) => times[i]?.ms.push(...ms));
    open.forEach(({ check }) => check());
    await browser.close();
  }
  return times;
}

/** @typedef {{ page: import('playwright-core').Page, settled: Settled, check: () => void }} OpenPeer */

/**
 * @param {import('../session.mjs').Session} session @param {import('playwright-core').Browser} browser
 * @param {Subject} subject @param {Scene} common @param {FrameOptions} options @param {OpenPeer | undefined} first
 * @returns {Promise<OpenPeer>}
 */
async function openPeer(session, browser, subject, common, { width, height, seed }, first) {
  const { lights, active, kind } = subject.scene ?? common;
  const page = await browser.newPage({ viewport: { width, height } });
  const check = failOnErrors(page);
  const query = { peer: subject.peer, lights, active, kind, seed, samples: subject.samples ?? '' };
  await page.goto(
    `${session.origin}/frame.html?${new URLSearchParams(Object.entries(query).map(([k, v]) => [k, String(v)]))}`,
  );
  const capture =
    subject.peer === 'raw' ? await first?.page.evaluate(() => window.frameBench.capture()) : undefined;
  await page.evaluate((c) => window.openPeer(c), capture);
  const settled = await page.evaluate(() => window.frameBench.settle());
  await page.evaluate(([w, h]) => window.frameBench.resize(w, h), /** @type {const} */ ([width, height]));
  // In software slow frames have programs compiled that fast ones have not; three.js has one from the start.
  if ((await drawsInSoftware(page)) && ['element', 'core'].includes(subject.peer))
    await page.evaluate(() => window.frameBench.settleAtSize());
  const lit = await page.evaluate(() => window.frameBench.lit());
  if (lit < 1) throw new Error(`${subject.name}, ${lights} lights: only ${lit} of the picture is lit`);
  check();
  return { page, settled, check };
}

/** @param {import('playwright-core').Page} page */
const drawsInSoftware = async (page) => isSoftware(await page.evaluate(() => window.frameBench.renderer));

/** @param {readonly OpenPeer[]} peers @param {number | null} gpu @param {FrameOptions} options */
async function timeInTurns(peers, gpu, { rounds, sampleMs }) {
  const first = /** @type {OpenPeer} */ (peers[0]).page;
  const software = await drawsInSoftware(first);
  if (software && gpu === null) throw new Error('this system does not tell the CPU time of processes');
  /** @param {OpenPeer} peer @param {number} frames @returns {Promise<number>} milliseconds */
  const sample = async ({ page }, frames) => {
    if (!software) return page.evaluate((n) => window.frameBench.time(n), frames);
    const before = cpuSeconds(Number(gpu));
    await page.evaluate((n) => window.frameBench.draw(n), frames);
    return (cpuSeconds(Number(gpu)) - before) * 1000;
  };
  // So many frames that the fastest one's sample is long enough; the same number for all, for what a sample costs besides.
  let frames = 1;
  for (;;) {
    let least = Infinity;
    for (const peer of peers) least = Math.min(least, await sample(peer, frames));
    if (least >= sampleMs) break;
    frames = Math.ceil(frames * Math.min(8, (1.2 * sampleMs) / Math.max(least, 0.1)));
  }
  const samples = await interleaved(peers, rounds, (peer) => sample(peer, frames));
  return samples.map((ms) => ms.map((total) => total / frames));
}
