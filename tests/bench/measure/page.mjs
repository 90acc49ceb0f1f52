// @ts-check
// Measures of whole pages: the frame rate of many viewers against one, a still picture's samples,
// and bytes to download.

import { readFileSync } from 'node:fs';
import { builtFrom } from '../build.mjs';
import { cpuSeconds, gpuProcess, isSoftware, openPage } from '../browser.mjs';

/** @typedef {import('../pages/element-side.js').Viewer} Viewer */
/** @typedef {Pick<import('./frames.mjs').Options, 'size' | 'rounds' | 'add'>} Options */

const RATE_MS = 2000;
const WARM = { frames: 60, atMost: 24_000 };
/** Changes until the code is there, and the levels of round shapes. */
const WARM_CHANGES = 2;

/**
 * Pictures a second, 60 at most, of twenty turning viewers and of one with as many pixels, on pages
 * of one size. @param {import('../browser.mjs').Lab} lab @param {Options} options
 */
export async function measureViewers(lab, { size, add }) {
  const browser = await lab.launch();
  /** @type {number[]} */
  const rates = [];
  for (const query of ['columns=5&rows=4', 'columns=1&rows=1']) {
    // So many pixels that no frame rate reaches the display's.
    const large = /** @type {const} */ ([2 * size[0], 2 * size[1]]);
    const { page, check } = await openPage(browser, `${lab.origin}/viewers.html?${query}`, large);
    const rate = () => page.evaluate((ms) => window.frameRate(ms), RATE_MS);
    await page.evaluate(() => window.viewersReady);
    // Until specialised programs have taken over.
    for (let [frames, ms] = [0, 0]; frames < WARM.frames && ms < WARM.atMost; ms += RATE_MS) {
      frames += ((await rate()) * RATE_MS) / 1000;
    }
    rates.push(await rate());
    check();
    await page.close();
  }
  const [twenty = NaN, one = NaN] = rates;
  add('frame rate', 'frames/s', { twenty, one });
}

/**
 * The time from a change to the converged picture of `antialias="full"`, with the page's own
 * animation frames, and to the plain one.
 * @param {import('../browser.mjs').Lab} lab @param {import('../subjects.mjs').StillSubject} subject
 * @param {Options} options
 */
export async function measureStill(lab, { geometry }, { size, rounds, add }) {
  const browser = await lab.launch();
  const { page, check } = await openPage(browser, `${lab.origin}/start-standalone.html`, size);
  const viewer = page.locator('phong-viewer');
  await viewer.evaluate(fillPage);
  await viewer.evaluate((element, shape) => element.setAttribute('geometry', shape), geometry);
  /** @param {'full' | 'edges'} antialias */
  const time = (antialias) =>
    viewer.evaluate(async (/** @type {Viewer} */ element, mode) => {
      element.antialias = mode;
      await element.ready;
      await new Promise((resolve) => setTimeout(resolve, 100));
      const start = performance.now();
      element.theta += 1;
      await element.ready;
      return performance.now() - start;
    }, antialias);
  for (let round = -WARM_CHANGES; round < rounds; round++) {
    const values = { 'full, 64 samples': await time('full'), edges: await time('edges') };
    if (round >= 0) {
      add('change to picture', 'ms', values);
    }
  }
  check();
}

/** Runs in the page. @param {HTMLElement | SVGElement} viewer */
function fillPage(viewer) {
  Object.assign(document.body.style, { margin: '0' });
  Object.assign(viewer.style, { width: '100vw', height: '100vh' });
}

/** As README shows its scene. */
const README_SIZE = /** @type {const} */ ([760, 420]);

/**
 * Lights of the picture that moves, its pictures until programs are compiled for it, its pictures
 * before a sample, and those of one.
 */
const MOVING = { lights: 25, warm: 30, first: 5, pictures: 10 };

/**
 * CPU time of the GPU process for a picture while the camera turns, after the first ones: as the
 * element chooses the pixels, and with all of them. Only where a processor draws.
 * @param {import('../browser.mjs').Lab} lab @param {import('../subjects.mjs').MovingSubject}
 * subject @param {import('../results.mjs').BenchResult} result @param {Options} options
 */
export async function measureMoving(lab, { scene, ratio }, { machine }, { size, rounds, add }) {
  if (!isSoftware(machine['renderer'] ?? '')) return;
  const browser = await lab.launch();
  const url = `${lab.origin}/start-standalone.html`;
  const shown = scene === 'shapes' ? README_SIZE : size;
  const { page, check } = await openPage(browser, url, shown, ratio);
  const viewer = page.locator('phong-viewer');
  if (scene === 'shapes') {
    await page.evaluate((html) => (document.body.innerHTML = html), readmeScene());
  } else {
    const lights = Array.from({ length: MOVING.lights }, (_, i) => {
      const place = [3 * Math.sin(i), 1 + (i % 5), 3 * Math.cos(i), 1].join(' ');
      return `<phong-light position="${place}" diffuse="20 18 16"></phong-light>`;
    });
    const html = lights.join('');
    await viewer.evaluate((element, more) => element.insertAdjacentHTML('beforeend', more), html);
  }
  await viewer.evaluate(fillPage);
  await viewer.evaluate((/** @type {Viewer} */ element) => element.ready);
  const gpu = await gpuProcess(browser); // it starts with the first picture
  if (gpu === null) return;
  /** @param {number} pictures @param {number | 'auto'} [pixelRatio] */
  const turn = (pictures, pixelRatio) =>
    viewer.evaluate(
      async (/** @type {Viewer} */ element, [count, most]) => {
        element.pixelRatio = most ?? element.pixelRatio;
        element.autoRotate = 30;
        for (let i = 0; i < count; i++) {
          await new Promise((resolve) =>
            element.addEventListener('render', resolve, { once: true }),
          );
        }
        return element.stats.frames;
      },
      /** @type {const} */ ([pictures, pixelRatio]),
    );
  /** @param {number | 'auto'} pixelRatio */
  const time = async (pixelRatio) => {
    const first = await turn(MOVING.first, pixelRatio);
    const before = cpuSeconds(gpu);
    const pictures = (await turn(MOVING.pictures)) - first; // it goes on turning between the calls
    return (1000 * (cpuSeconds(gpu) - before)) / pictures;
  };
  await turn(MOVING.warm, ratio / 4);
  for (let round = 0; round < rounds; round++) {
    add('CPU of a picture', 'ms', { auto: await time('auto'), 'all pixels': await time(ratio) });
  }
  check();
}

function readmeScene() {
  const text = readFileSync(new URL('../../../README.md', import.meta.url), 'utf8');
  const [html] = /<phong-viewer alt=[^]*?<\/phong-viewer>/.exec(text) ?? [];
  if (html === undefined) throw new Error('README.md shows no scene');
  return html.replace(' gui>', '>'); // the panel would be drawn as well
}

/** Brotli sizes. @param {import('../browser.mjs').Lab} lab @param {Options} options */
export function measureBytes(lab, { add }) {
  const sizes = Object.entries(builtFrom(lab.folder).bytes).map(([side, bytes]) => [
    side,
    bytes / 1000,
  ]);
  add('brotli', 'kB', Object.fromEntries(sizes));
}
