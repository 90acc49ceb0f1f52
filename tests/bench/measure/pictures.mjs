// @ts-check
// Whole pictures: their error against the exact mean over each pixel, and the time from a change to
// them. Each side has a page of its own in one fresh browser. Times are by the clock, with frames
// back to back and each one finished by reading a pixel back.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { castPicture } from '../../support/cast.mjs';
import { openPage } from '../browser.mjs';
import { CASTER } from '../build.mjs';
import { CODES, FULL, full, PLAIN, RMSE, TIME, WITHIN } from '../pictures.mjs';
import { interleaved } from '../statistics.mjs';

/** Samples per pixel of the exact pictures. */
const TRUTH_SAMPLES = 1024;
/** The one method of the element's pages. */
const OURS = 'element';
/** A page of its own for each. */
const SIDES = [...FULL.map(full), 'multisampled', 'passes', PLAIN];
/** The side that shows the triangles of the samples. */
const FINE = full(FULL[0] ?? NaN);
/** Those that draw the triangles of the plain picture; the others draw those of the samples. */
const DRAW_PLAIN = [PLAIN, 'multisampled'];

/**
 * @typedef {import('playwright-core').Page} Page
 * @typedef {{ side: string, name: string, steps: number, page: Page }} Method
 * @typedef {import('./frames.mjs').Options} Options
 */

/**
 * One launch of a picture.
 * @param {import('../browser.mjs').Lab} lab @param {import('../subjects.mjs').PictureSubject}
 * subject @param {number} launch @param {Options} options
 */
export async function measurePicture(
  lab,
  { scene, round: hasRound },
  launch,
  { size, rounds, add },
) {
  const { methods, cell, check } = await openSides(lab, scene, size);
  if (launch === 0) {
    await addErrors(methods, await truthsOf(lab, methods, cell, hasRound), add);
  }
  const timed = methods.filter(({ name }) => !name.endsWith(CODES));
  for (const method of timed) {
    if (method.name !== OURS) {
      await time(method);
    } // the first one compiles and allocates
  }
  const samples = await interleaved(timed, rounds, async (method) =>
    labelled(method, await time(method)),
  );
  check();
  for (let round = 0; round < rounds; round++) {
    add(TIME, 'ms', baseLast(Object.assign({}, ...samples.map((ofMethod) => ofMethod[round]))));
  }
}

/**
 * @param {import('../browser.mjs').Lab} lab @param {string} scene @param {readonly [number,
 * number]} size
 */
async function openSides(lab, scene, size) {
  const browser = await lab.launch();
  /** @type {Method[]} */
  const methods = [];
  /** @type {(() => void)[]} */
  const checks = [];
  let cell = { width: size[0], height: size[1] };
  for (const side of SIDES) {
    const query = new URLSearchParams({
      scene,
      side,
      width: String(size[0]),
      height: String(size[1]),
    });
    const { page, check } = await openPage(browser, `${lab.origin}/picture.html?${query}`, size);
    const facts = await page.evaluate(() => window.openPicture());
    check();
    checks.push(check);
    cell = facts.cell;
    for (const [name, { steps }] of Object.entries(facts.methods)) {
      methods.push({ side, name, steps, page });
    }
  }
  return { methods, cell, check: () => checks.forEach((check) => check()) };
}

/**
 * @param {import('../browser.mjs').Lab} lab @param {readonly Method[]} methods @param
 * {import('../pages/picture.js').Cell} cell @param {boolean} round
 */
async function truthsOf({ folder }, methods, cell, round) {
  /** @param {string} side */
  const pageOf = (side) => /** @type {Method} */ (methods.find((one) => one.side === side)).page;
  return {
    plain: await truthOf(folder, pageOf(PLAIN), cell),
    fine: await truthOf(folder, pageOf(FINE), cell),
    shape: round ? await truthOf(folder, pageOf(PLAIN), cell, round) : undefined,
  };
}

/**
 * r, g, b, a of each pixel, viewer by viewer: the exact means of the triangles that they show now,
 * or of the round shapes that these stand for.
 * @param {string} folder of the built pages @param {Page} page @param
 * {import('../pages/picture.js').Cell} cell @param {boolean} [round]
 */
async function truthOf(folder, page, { width, height }, round = false) {
  const code = readFileSync(join(folder, CASTER), 'utf8');
  const scenes = await page.evaluate((shapes) => window.picture.scenes(shapes), round);
  const means = new Float64Array(4 * width * height * scenes.length);
  const samples = TRUTH_SAMPLES;
  for (const [i, scene] of scenes.entries()) {
    means.set(await castPicture(scene, { width, height, samples }, code), 4 * width * height * i);
  }
  return means;
}

/** @param {Method} method @returns {Promise<number[]>} */
const time = ({ page, name }) => page.evaluate((method) => window.picture.time(method), name);

/**
 * A value for each picture of a method, by the side's name in results. @param {Method} method
 * @param {readonly number[]} values
 */
const labelled = ({ side, name, steps }, values) =>
  Object.fromEntries(values.map((value, k) => [sideName(side, name, steps, k), value]));

/**
 * Such as `TAARenderPass, 7`: after so many accumulations. @param {string} side @param {string}
 * name @param {number} steps @param {number} k
 */
function sideName(side, name, steps, k) {
  if (name === OURS) return side;
  if (steps === 1) return name;
  return name.endsWith(CODES) ? `${name.slice(0, -CODES.length)}, ${k}${CODES}` : `${name}, ${k}`;
}

/** @param {Record<string, number>} values */
const baseLast = ({ [PLAIN]: base = NaN, ...others }) => ({ ...others, [PLAIN]: base });

/**
 * Compares every picture with its triangles', and with the round shape's where there is one.
 * @param {readonly Method[]} methods @param {Awaited<ReturnType<typeof truthsOf>>} truths @param
 * {Options['add']} add
 */
async function addErrors(methods, { plain, fine, shape }, add) {
  /** @type {Record<string, Record<string, number>>} */
  const found = { [RMSE.triangles]: {}, [WITHIN]: {}, [RMSE.round]: {} };
  for (const method of methods) {
    const { side, name, steps, page } = method;
    const truth = DRAW_PLAIN.includes(side) ? plain : fine;
    for (let step = 0; step < steps; step++) {
      const codes = await page.evaluate(
        ([way, k]) => window.picture.codes(way, k),
        /** @type {const} */ ([name, step]),
      );
      const label = sideName(side, name, steps, step);
      const { rmse, within } = pictureError(codes, truth);
      Object.assign(found[RMSE.triangles] ?? {}, { [label]: rmse });
      Object.assign(found[WITHIN] ?? {}, { [label]: 100 * within });
      if (shape) {
        Object.assign(found[RMSE.round] ?? {}, { [label]: pictureError(codes, shape).rmse });
      }
    }
  }
  for (const [measure, values] of Object.entries(found)) {
    if (Object.keys(values).length > 0) {
      add(measure, measure === WITHIN ? '%' : 'codes', baseLast(values));
    }
  }
}

/**
 * The root of the mean square over r, g, b, and the share of pixels whose channels are all within
 * one code. In codes.
 * @param {Uint8Array} codes r, g, b of each pixel @param {Float64Array} means r, g, b, a of each
 * pixel, not rounded; premultiplied as the codes
 * @returns {{ rmse: number, within: number }} `within` 0–1
 */
function pictureError(codes, means) {
  if (codes.length / 3 !== means.length / 4) {
    throw new RangeError(`${codes.length / 3} pixels cannot be compared with ${means.length / 4}`);
  }
  let squares = 0;
  let within = 0;
  for (let pixel = 0; pixel < codes.length / 3; pixel++) {
    let largest = 0;
    for (let channel = 0; channel < 3; channel++) {
      const error = Math.abs(
        (codes[3 * pixel + channel] ?? NaN) - (means[4 * pixel + channel] ?? NaN),
      );
      squares += error * error;
      largest = Math.max(largest, error);
    }
    if (largest <= 1) {
      within += 1;
    }
  }
  return { rmse: Math.sqrt(squares / codes.length), within: within / (codes.length / 3) };
}
