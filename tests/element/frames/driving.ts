// Draws frame after frame, as motion does, until viewers use specialised programs. Needs the page's
// log of WebGL (gl-log.ts).

import type { ViewerLocator } from '../../support/test.js';
import type { Page } from '@playwright/test';
import { drawnWith, glSpent, isSpecialised, isLit } from '../support/gl-log.js';
import type { PhongViewer } from '../support/viewer.js';

/** Frames to wait for a specialised program: many, for busy machines. */
const MOST_FRAMES = 400;

/** Draws all viewers of the page, unchanged, for this many frames. */
export async function drawFrames(page: Page, frames: number): Promise<void> {
  await page.evaluate(async (count) => {
    for (let i = 0; i < count; i++) {
      for (const viewer of document.querySelectorAll<PhongViewer>('phong-viewer')) {
        viewer.requestRender();
      }
      await new Promise(requestAnimationFrame);
    }
    await new Promise(requestAnimationFrame);
  }, frames);
}

/** Moves every light in each of this many frames. In software the general program draws them. */
export const moveFor = (viewer: ViewerLocator, frames: number): Promise<void> =>
  viewer.evaluate(async (element, count) => {
    for (let frame = 0; frame < count; frame++) {
      for (const light of element.lights) {
        const [x, y, z, w] = light.position;
        light.position = [x + 0.001, y, z - 0.001, w];
      }
      await element.ready;
      await new Promise(requestAnimationFrame);
    }
  }, frames);

/** Draws until all lit draws use specialised programs. */
export async function drawUntilSpecialised(page: Page): Promise<void> {
  for (let frames = 0; frames < MOST_FRAMES; frames += 8) {
    await glSpent(page);
    await drawFrames(page, 1);
    const lit = (await drawnWith(page)).filter(isLit);
    if (lit.length > 0 && lit.every(isSpecialised)) return;
    await drawFrames(page, 7);
  }
  throw new Error(`No specialised programs after ${MOST_FRAMES} frames`);
}
