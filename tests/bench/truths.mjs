// @ts-check
// The exact means of whole pictures: by the ray caster of the tests, from what a page's viewers draw.

import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { casterCode, castPicture } from '../support/caster/cast.mjs';

const SAMPLES = 1024;
const CASTER = 'caster.js';

/** Puts the ray caster beside the built pages. @param {string} folder */
export async function buildCaster(folder) {
  writeFileSync(join(folder, CASTER), await casterCode());
}

/**
 * r, g, b, a of each pixel, viewer by viewer: of the triangles that they show now, or of the shapes that these stand for.
 * @param {string} folder of the built pages @param {import('playwright-core').Page} page
 * @param {import('./pages/picture.js').Cell} cell @param {{ round?: boolean }} [options]
 * @returns {Promise<Float64Array>}
 */
export async function truthOf(folder, page, { width, height }, { round = false } = {}) {
  const code = readFileSync(join(folder, CASTER), 'utf8');
  const scenes = await page.evaluate((shapes) => window.picture.scenes(shapes), round);
  const means = new Float64Array(4 * width * height * scenes.length);
  for (const [i, scene] of scenes.entries())
    means.set(await castPicture(scene, { width, height, samples: SAMPLES }, code), 4 * width * height * i);
  return means;
}
