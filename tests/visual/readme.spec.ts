// Does the README's picture show its snippet? Compared left of the panel, whose text depends on the
// machine's fonts.

import { readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { PNG } from 'pngjs';
import { README_PICTURE, README_PICTURE_SCALE, readmeSnippet } from '../../.ci/readme-picture.mjs';
import { compare, expect, pixels, test, type Picture } from '../support/test.js';

const file = join(fileURLToPath(new URL('../..', import.meta.url)), README_PICTURE);

/** Device pixels of the picture beside the panel. */
const FREE_WIDTH = 681;

/** The picture on white paper, cut to its left part. */
function leftOnWhite({ width, height, data }: Picture): Picture {
  const left = new Uint8Array(FREE_WIDTH * height * 4);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < FREE_WIDTH; x++) {
      const from = 4 * (y * width + x);
      const to = 4 * (y * FREE_WIDTH + x);
      const alpha = data[from + 3]! / 255;
      for (let c = 0; c < 3; c++) {
        left[to + c] = Math.round(255 + (data[from + c]! - 255) * alpha);
      }
      left[to + 3] = 255;
    }
  }
  return { width: FREE_WIDTH, height, data: left };
}

test("the README's picture shows its snippet (`npm run readme:picture` draws it again)", async ({
  mount,
}) => {
  const size = /style="width: (\d+)px; height: (\d+)px"/.exec(readmeSnippet());
  const width = Number(size?.[1]);
  const height = Number(size?.[2]);
  // Four samples are enough to tell, and take a sixteenth of the time.
  const markup = readmeSnippet().replace(' antialias="full"', '');
  // Its style attribute is refused by the strict policy.
  const viewer = await mount(markup, { csp: '', width, height });
  const drawn = await pixels(viewer, {
    width: FREE_WIDTH,
    height: height * README_PICTURE_SCALE,
    samples: 4,
  });
  const { width: across, height: down, data } = PNG.sync.read(readFileSync(file));
  const stored = { width: across, height: down, data: new Uint8Array(data) };
  const { share } = compare(leftOnWhite(drawn), leftOnWhite(stored), 4);
  expect(share).toBeLessThan(0.01);
});

test("the README's picture has fewer than 150 kB", () => {
  expect(statSync(file).size).toBeLessThan(150_000);
});
