// Pictures that keep being drawn: frames one after another, as motion makes them, until a viewer draws by a specialised program.
// Needs the page's log of WebGL (gl-log.ts).

import type { Locator, Page } from '@playwright/test';
import { drawnWith, glSpent, type GlProgram, isSpecialised, isLit } from './gl-log.js';
import type { PhongViewer } from './support.js';

/** Frames after which it is too late: many, for busy machines. */
const MOST_FRAMES = 400;

/** Draws all the page's viewers in this many frames, one after another, unchanged. */
export async function drawFrames(page: Page, frames: number): Promise<void> {
  await page.evaluate(async (count) => {
    for (let i = 0; i < count; i++) {
      for (const viewer of document.querySelectorAll<PhongViewer>('phong-viewer')) viewer.requestRender();
      await new Promise(requestAnimationFrame);
    }
    await new Promise(requestAnimationFrame);
  }, frames);
}

/**
 * Draws this many frames, in each of which every light has moved. In software the general program draws them.
 */
export const moveFor = (viewer: Locator, frames: number): Promise<void> =>
  viewer.evaluate(async (element: PhongViewer, count) => {
    for (let frame = 0; frame < count; frame++) {
      for (const light of element.lights) {
        const [x, y, z, w] = light.position;
        light.position = [x + 0.001, y, z - 0.001, w];
      }
      await element.ready;
      await new Promise(requestAnimationFrame);
    }
  }, frames);

/** Whether everything on the page was drawn by such programs in its last frame. */
async function allAre(page: Page, wanted: (one: GlProgram) => boolean): Promise<boolean> {
  await glSpent(page);
  await drawFrames(page, 1);
  const lit = (await drawnWith(page)).filter(isLit);
  return lit.length > 0 && lit.every(wanted);
}

/** Keeps drawing until everything on the page is drawn by programs of its own, or by such ones; says how many frames that took. */
export async function drawUntilSpecialised(
  page: Page,
  wanted: (one: GlProgram) => boolean = isSpecialised,
): Promise<number> {
  for (let frames = 0; frames < MOST_FRAMES; frames += 8) {
    if (await allAre(page, wanted)) return frames;
    await drawFrames(page, 7);
  }
  throw new Error(`No specialised programs after ${MOST_FRAMES} frames: ${await programsDrawnWith(page)}`);
}

async function programsDrawnWith(page: Page): Promise<string> {
  await glSpent(page);
  await drawFrames(page, 1);
  return (await drawnWith(page)).map((one) => (isSpecialised(one) ? 'specialised' : 'general')).join();
}
