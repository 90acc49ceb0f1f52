// @ts-check
// One light more: how much longer than a still frame the frame takes that has it, for three.js and for the element.

import { failOnErrors } from '../session.mjs';
import { median } from '../statistics.mjs';
import { rowsOf } from './peer-row.mjs';
import { freshPage } from './start.mjs';

/** Lights before: few, as on most pages, and so many that a program's text is long. */
const LIGHTS = [3, 40];

const SUBJECTS = [
  { peer: 'element', name: '<phong-viewer>', from: 'revision' },
  { peer: 'mesh-phong', name: 'three.js MeshPhong', from: 'three' },
];

/** Each is a page of its own, whose programs nothing has made before. */
const MOST = 3;

/**
 * @param {import('../session.mjs').Session} session @param {import('./peers.mjs').PeerSettings} settings
 * @returns {AsyncGenerator<import('./peer-row.mjs').PeerRow>}
 */
export async function* relinks(session, { launches, rounds, seed }) {
  for (const lights of LIGHTS) {
    /** @type {import('../pages/relink.js').Relink[][]} */
    const samples = SUBJECTS.map(() => []);
    for (let round = 0; round < Math.min(MOST, launches * rounds); round++) {
      const order = round % 2 === 0 ? [0, 1] : [1, 0];
      for (const i of order) samples[i]?.push(await relinkOf(session, SUBJECTS[i]?.peer ?? '', lights, seed));
    }
    const nth = `${lights + 1}${lights + 1 === 41 ? 'st' : 'th'}`;
    const { versions } = session;
    const named = SUBJECTS.map(({ name, from }) => ({ name, version: versions[from] ?? 'unknown' }));
    for (const [key, frame] of /** @type {const} */ ([
      ['added', 'its frame, beyond a still one'],
      ['longest', 'the longest of 120 after'],
    ])) {
      const what = `adding a ${nth} light: ${frame}`;
      yield* rowsOf(named, what, 'ms', samples, (sample) => sample[key] - sample.still, {
        note: (list) => `a still frame takes ${median(list.map(({ still }) => still)).toFixed(1)} ms, 64×48`,
      });
    }
  }
}

/**
 * @param {import('../session.mjs').Session} session @param {string} peer @param {number} lights @param {number} seed
 * @returns {Promise<import('../pages/relink.js').Relink>}
 */
async function relinkOf(session, peer, lights, seed) {
  const { browser, page } = await freshPage(session);
  const failed = failOnErrors(page);
  await page.goto(`${session.origin}/relink.html?peer=${peer}&lights=${lights}&seed=${seed}`);
  await page.waitForFunction(() => window.relinkBench !== undefined, undefined, {
    polling: 50,
    timeout: 120_000,
  });
  const relink = await page.evaluate(() => {
    if (window.relinkBench === undefined) throw new Error('the page is not ready');
    return window.relinkBench();
  });
  failed();
  await browser.close();
  return relink;
}
