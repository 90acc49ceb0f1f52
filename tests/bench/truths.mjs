// @ts-check
// The exact means of whole pictures: by the ray caster of the tests, from what a page's viewers draw.

import { castPicture, sceneInPage, toScene, trueShape } from '../support/caster/cast.mjs';

const SAMPLES = 1024;

/**
 * r, g, b, a of each pixel, viewer by viewer: of the triangles that they show now, or of the shapes that these stand for.
 * @param {import('playwright-core').Page} page @param {import('./pages/picture.js').Cell} cell @param {{ round?: boolean }} [options]
 * @returns {Promise<Float64Array>}
 */
export async function truthOf(page, { width, height }, { round = false } = {}) {
  const viewers = await page.locator('phong-viewer').all();
  const means = new Float64Array(4 * width * height * viewers.length);
  for (const [i, viewer] of viewers.entries()) {
    const scene = toScene(await viewer.evaluate(sceneInPage));
    const shown = round ? trueShape(scene) : scene;
    means.set(await castPicture(shown, { width, height, samples: SAMPLES }), 4 * width * height * i);
  }
  return means;
}
