// @ts-check
// The exact means of whole pictures: by the ray caster of the tests, from what a page's viewers draw. Kept beside the built
// pages, so that a machine that cannot build the ray caster finds them there.

import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { serialize } from 'node:v8';

const SAMPLES = 1024;

/**
 * r, g, b, a of each pixel, viewer by viewer: of the triangles that they show now, or of the shapes that these stand for.
 * @param {string} folder of the built pages @param {import('playwright-core').Page} page
 * @param {import('./pages/picture.js').Cell} cell @param {{ round?: boolean }} [options]
 * @returns {Promise<Float64Array>}
 */
export async function truthOf(folder, page, { width, height }, { round = false } = {}) {
  const scenes = await page.evaluate((shapes) => window.picture.scenes(shapes), round);
  const means = new Float64Array(4 * width * height * scenes.length);
  for (const [i, scene] of scenes.entries()) {
    const truth = await kept(join(folder, 'truths'), scene, { width, height, samples: SAMPLES });
    means.set(truth, 4 * width * height * i);
  }
  return means;
}

/**
 * @param {string} folder @param {import('../support/caster/scene.js').CastScene} scene
 * @param {import('../support/caster/scene.js').CastOptions} options @returns {Promise<Float64Array>}
 */
async function kept(folder, scene, options) {
  const key = createHash('sha256')
    .update(serialize([scene, options]))
    .digest('hex');
  const file = join(folder, key.slice(0, 32));
  if (existsSync(file)) return new Float64Array(new Uint8Array(readFileSync(file)).buffer);
  const { castPicture } = await import('../support/caster/cast.mjs');
  const truth = await castPicture(scene, options);
  mkdirSync(folder, { recursive: true });
  writeFileSync(file, truth);
  return truth;
}
