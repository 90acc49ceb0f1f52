// @ts-check
// Measures of whole pages: the frame rate of many viewers against one, connecting many lights, and bytes to download.

import { builtFrom } from '../build.mjs';
import { openPage } from '../browser.mjs';

/** @typedef {Pick<import('./frames.mjs').Options, 'size' | 'rounds' | 'add'>} Options */

const RATE_MS = 2000;
const WARM = { frames: 60, atMost: 24_000 };
const LIGHTS = 5000;

/** Pictures a second, 60 at most, of twenty turning viewers and of one with as many pixels, on pages of one size. @param {import('../browser.mjs').Lab} lab @param {Options} options */
export async function measureViewers(lab, { size, rounds, add }) {
  const browser = await lab.launch();
  for (let round = 0; round < rounds; round++) {
    /** @type {number[]} */
    const rates = [];
    for (const query of ['columns=5&rows=4', 'columns=1&rows=1']) {
      // So many pixels that no frame rate reaches the display's.
      const large = /** @type {const} */ ([2 * size[0], 2 * size[1]]);
      const { page, check } = await openPage(browser, `${lab.origin}/viewers.html?${query}`, large);
      await page.evaluate(() => window.viewersReady);
      // Until specialised programs have taken over.
      for (let [frames, ms] = [0, 0]; frames < WARM.frames && ms < WARM.atMost; ms += RATE_MS)
        frames += ((await page.evaluate((time) => window.frameRate(time), RATE_MS)) * RATE_MS) / 1000;
      rates.push(await page.evaluate((ms) => window.frameRate(ms), RATE_MS));
      check();
      await page.close();
    }
    const [twenty = NaN, one = NaN] = rates;
    add('frame rate', 'frames/s', { twenty, one });
  }
}

/** @param {import('../browser.mjs').Lab} lab @param {Options} options */
export async function measureConnect(lab, { rounds, add }) {
  const browser = await lab.launch();
  for (let round = 0; round < rounds; round++) {
    const { page, check } = await openPage(browser, `${lab.origin}/connect.html`, [300, 200]);
    add('time', 'ms', { element: await page.evaluate((count) => window.connectLights(count), LIGHTS) });
    check();
    await page.close();
  }
}

/** Brotli sizes. @param {import('../browser.mjs').Lab} lab @param {Options} options */
export function measureBytes(lab, { add }) {
  const { standalone = NaN, bundled = NaN, three = NaN } = builtFrom(lab.folder).bytes;
  add('brotli', 'kB', { standalone: standalone / 1000, bundled: bundled / 1000, three: three / 1000 });
}
