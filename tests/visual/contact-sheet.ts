// The pictures of all viewers of a page, drawn small and side by side, held against a baseline.

import type { Page } from '@playwright/test';
import { compare, expect, expectPicture, pixels, type Picture } from '../support/test.js';

const TILE = { width: 160, height: 120 };
const COLUMNS = 6;

function contactSheet(tiles: readonly Picture[]): Picture {
  const width = TILE.width * Math.min(COLUMNS, tiles.length);
  const height = TILE.height * Math.ceil(tiles.length / COLUMNS);
  const data = new Uint8Array(width * height * 4);
  tiles.forEach((tile, i) => {
    const left = (i % COLUMNS) * TILE.width;
    const top = Math.floor(i / COLUMNS) * TILE.height;
    for (let y = 0; y < TILE.height; y++) {
      const row = tile.data.subarray(y * TILE.width * 4, (y + 1) * TILE.width * 4);
      data.set(row, ((top + y) * width + left) * 4);
    }
  });
  return { width, height, data };
}

/** @param name of the baseline */
export async function expectPictures(page: Page, name: string): Promise<void> {
  const tiles: Picture[] = [];
  for (const viewer of await page.locator('phong-viewer').all()) {
    tiles.push(await pixels(viewer, TILE));
  }
  expect(tiles.length).toBeGreaterThan(0);
  const blank = { ...TILE, data: new Uint8Array(TILE.width * TILE.height * 4) };
  for (const tile of tiles) {
    expect(compare(tile, blank).max, 'something is drawn').toBeGreaterThan(100);
  }
  expectPicture(name, contactSheet(tiles));
}
