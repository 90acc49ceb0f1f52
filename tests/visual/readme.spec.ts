// Does the README's picture show its snippet, the panel included?

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { README_PICTURE, README_PICTURE_SCALE, readmeSnippet } from '../../.ci/readme-picture.mjs';
import { decodeInPage, decodePng } from '../support/picture.js';
import { compare, expect, test, type Picture } from '../support/test.js';

const file = join(fileURLToPath(new URL('../..', import.meta.url)), README_PICTURE);

/** Device pixels of the picture beside the panel. */
const FREE_WIDTH = 681;

/** Device pixels of a cell's side: about a line of the panel's text. */
const CELL = 24;

/** The columns from `from` to `to`. */
function columns({ width, height, data }: Picture, from: number, to: number): Picture {
  const cut = new Uint8Array((to - from) * height * 4);
  for (let y = 0; y < height; y++) {
    const row = data.subarray(4 * (y * width + from), 4 * (y * width + to));
    cut.set(row, 4 * y * (to - from));
  }
  return { width: to - from, height, data: cut };
}

/** The mean of each cell: what is where, whatever the machine's fonts make of its letters. */
function cells({ width, height, data }: Picture): Picture {
  const [across, down] = [Math.floor(width / CELL), Math.floor(height / CELL)];
  const means = new Uint8Array(across * down * 4);
  for (let i = 0; i < means.length; i++) {
    const [column, row] = [(i >> 2) % across, Math.floor((i >> 2) / across)];
    let sum = 0;
    for (let y = 0; y < CELL; y++) {
      for (let x = 0; x < CELL; x++) {
        sum += data[4 * ((row * CELL + y) * width + column * CELL + x) + (i & 3)]!;
      }
    }
    means[i] = Math.round(sum / CELL ** 2);
  }
  return { width: across, height: down, data: means };
}

test.describe('at the scale of the picture', () => {
  test.use({ deviceScaleFactor: README_PICTURE_SCALE });

  test("the README's picture shows its snippet (`npm run readme:picture` draws it again)", async ({
    page,
    mount,
  }) => {
    const size = /(\d+)px, 100%\); height: (\d+)px/.exec(readmeSnippet());
    // Sixteen samples are enough to tell, and take a quarter of the time.
    const markup = readmeSnippet().replace(' antialias="full"', ' antialias="full" samples="16"');
    // Its style attribute is refused by the strict policy.
    const viewer = await mount(markup, {
      csp: '',
      width: Number(size?.[1]),
      height: Number(size?.[2]),
    });
    await viewer.getByText('add light').waitFor();
    await expect.poll(() => viewer.evaluate((element) => element.stats.samples)).toBe(16);
    const drawn = decodePng(await viewer.screenshot());
    const stored = await decodeInPage(page, readFileSync(file));
    const { width } = stored;
    const scene = (picture: Picture) => columns(picture, 0, FREE_WIDTH);
    // 0.0081 where it was stored. The file's compression alone changes 0.014 by more than four steps.
    expect(compare(scene(drawn), scene(stored), 6).share).toBeLessThan(0.015);
    const panel = (picture: Picture) => cells(columns(picture, FREE_WIDTH, width));
    expect(compare(panel(drawn), panel(stored), 16).share).toBeLessThan(0.05);
  });
});
