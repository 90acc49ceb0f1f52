// Do published models look as in another renderer? On the site's page of twenty models, both must
// cover the same pixels in similar colours. The lighting differs, so colours are compared coarsely.
// Captions name features that are not supported.

import { readFileSync } from 'node:fs';
import type { ModelEntries } from '../../.ci/site/models.js';
import type { ViewerLike } from '../support/picture.js';
import { expect, test } from '../support/test.js';

const { models } = JSON.parse(
  readFileSync(new URL('../../demo/models/models.json', import.meta.url), 'utf8'),
) as ModelEntries;

/** Least share of covered pixels that both pictures cover. Edges may differ. */
const COVERED = 0.98;

/** Largest distance of the mean colours, in codes per channel. Today's largest is 41. */
const COLOUR = 50;

test('there are twenty models, of all four formats', () => {
  const formats = models.map(({ file }) => file.slice(file.lastIndexOf('.') + 1));
  expect(formats).toHaveLength(20);
  expect([...new Set(formats)].sort()).toEqual(['glb', 'gltf', 'obj', 'ply', 'stl']);
});

test('@release each model covers the pixels of the other picture, in like colours', async ({
  page,
  consoleGuard,
}) => {
  test.setTimeout(300_000);
  const warnings = consoleGuard.allow(/^warning: .* is shown without /);
  await page.goto('/demo/models/');
  const found: string[] = [];
  for (const { id } of models) {
    const item = page.locator(`#${id}`);
    const viewer = item.locator('phong-viewer');
    await viewer.scrollIntoViewIfNeeded();
    await expect
      .poll(() => viewer.evaluate((v) => (v as ViewerLike & { loaded?: boolean }).loaded))
      .toBe(true);
    const { covered, colours } = await item.evaluate(compared);
    if (!(covered >= COVERED)) {
      found.push(`${id}: ${covered.toFixed(3)} of the pixels are covered in both`);
    }
    const distance = Math.max(...colours[0].map((c, i) => Math.abs(c - colours[1][i]!)));
    if (!(distance <= COLOUR)) {
      found.push(`${id}: mean colours ${colours.map(String).join(' and ')}`);
    }
  }
  expect(found).toEqual([]);
  const expected = models
    .filter(({ dropped }) => dropped.length > 0)
    .map(
      ({ file, dropped }) => `${file.replace(/^.*\//, '')} is shown without ${dropped.join(', ')}.`,
    );
  expect(warnings.map((text) => text.replace(/^warning: /, '')).sort()).toEqual(expected.sort());
});

/**
 * Runs in the page: the viewer's picture and the one beside it. The share of covered pixels that
 * both cover, and the mean colours of these.
 */
async function compared(item: Element) {
  const image = item.querySelector('img')!;
  image.loading = 'eager';
  await image.decode();
  const size = { width: image.naturalWidth, height: image.naturalHeight };
  const texels = (source: CanvasImageSource): Uint8ClampedArray => {
    const context = new OffscreenCanvas(size.width, size.height).getContext('2d')!;
    context.drawImage(source, 0, 0);
    return context.getImageData(0, 0, size.width, size.height).data;
  };
  const blob = await (item.querySelector('phong-viewer') as ViewerLike).toBlob(size);
  const pictures = [texels(await createImageBitmap(blob)), texels(image)] as const;
  let [both, either] = [0, 0];
  const sums = [[0, 0, 0], [0, 0, 0]] as const satisfies readonly number[][]; // oxfmt-ignore
  for (let i = 3; i < pictures[0].length; i += 4) {
    const [ours, other] = pictures.map((data) => data[i]! > 127) as [boolean, boolean];
    if (ours || other) {
      either += 1;
    }
    if (!(ours && other)) continue;
    both += 1;
    pictures.forEach((data, k) => [0, 1, 2].forEach((c) => (sums[k]![c]! += data[i - 3 + c]!)));
  }
  const mean = (sum: readonly number[]) => sum.map((c) => Math.round(c / both));
  return { covered: both / either, colours: [mean(sums[0]), mean(sums[1])] as const };
}
