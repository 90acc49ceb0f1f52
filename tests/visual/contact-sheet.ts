// The pictures of all viewers of a page, drawn small and side by side, held against a baseline.

import type { Page } from '@playwright/test';
import { expect } from '../support/test.js';

/**
 * @param name of the baseline in tests/visual/baselines: `playwright test --update-snapshots` writes
 * it anew
 */
export async function expectPictures(page: Page, name: string): Promise<void> {
  const png = await page.evaluate(async () => {
    const [width, height, columns] = [160, 120, 6];
    const viewers = [...document.querySelectorAll('phong-viewer')];
    const sheet = new OffscreenCanvas(
      width * Math.min(columns, viewers.length),
      height * Math.ceil(viewers.length / columns),
    );
    const context = sheet.getContext('2d')!;
    for (const [i, viewer] of viewers.entries()) {
      const tile = await createImageBitmap(await viewer.toBlob({ width, height }));
      context.drawImage(tile, width * (i % columns), height * Math.floor(i / columns));
    }
    return [...(await (await sheet.convertToBlob()).bytes())];
  });
  // Rasterization and rounding differ between machines: by two codes, or of few pixels.
  expect(Buffer.from(png)).toMatchSnapshot(`${name}.png`, {
    threshold: 0.008,
    maxDiffPixelRatio: 0.005,
  });
}
