// What the screen shows of a still's scene: with many samples, nearly all of it within one code. And
// the colours of decoded images.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { decodeImage } from '../../../src/extras/still/images.js';
import { outputFolder } from '../../../.ci/output-folder.mjs';
import type * as stills from '../../../src/extras/still/index.js';
import { decodeInPage } from '../../support/picture.js';
import { fullOr } from '../../support/repeats.js';
import { expect, pixels, test } from '../../support/test.js';
import { modelScenes, siteScenes } from './scenes.js';

/** As it is built: Node cannot import the decoders of the source. */
const { still } = (await import(
  pathToFileURL(join(outputFolder('dist'), 'still.js')).href
)) as typeof stills;

const SITE = siteScenes(fullOr(Infinity, 3), fullOr(Infinity, 1));
const TEXTURED = modelScenes([
  '/fixtures/models/textured.glb',
  '/fixtures/models/mask.glb',
  '/fixtures/models/data-uris.gltf',
  '/fixtures/models/quads.obj',
]);

/** Share of shown pixels within one code, and the RMS error in codes. */
function likeness(truth: Uint8Array, drawn: Uint8Array) {
  let [shown, within, squares] = [0, 0, 0];
  for (let i = 0; i < truth.length; i += 4) {
    if (truth[i + 3] === 0 && drawn[i + 3] === 0) continue;
    shown += 1;
    // Premultiplied: where little is covered, colours are rounded away.
    const errors = [0, 1, 2].map(
      (k) => (truth[i + k]! * truth[i + 3]! - drawn[i + k]! * drawn[i + 3]!) / 255,
    );
    within += Number(errors.every((error) => Math.abs(error) <= 1.5));
    squares += errors.reduce((sum, error) => sum + error * error, 0);
  }
  return { share: within / shown, rmse: Math.sqrt(squares / (3 * shown)) };
}

for (const [what, scenes, size, leastShare, mostRmse] of [
  // Pictures this small are a third outline, where software GL rounds vertices to 1/16 of a pixel.
  ['nearly all of it', SITE, { width: 152, height: 84 }, 0.91, 1],
  ['textures larger than their texels', TEXTURED, { width: 380, height: 210 }, 0.98, 0.6],
] as const) {
  test(`the screen shows a still within one code: ${what}`, async ({ page, mount, site }) => {
    test.setTimeout(fullOr(1_200_000, 120_000));
    for (const { name, markup } of scenes) {
      const { pixels: truth } = await still(markup, { ...size, base: site.origin, threads: 1 });
      const resting = markup.replace(/ auto-rotate="[^"]*"/, '');
      await mount(resting.replace('<phong-viewer', '<phong-viewer loading="eager"'), {
        ...size,
        csp: '', // the site's scenes have inline styles
      });
      const { data } = await pixels(page.locator('phong-viewer').first(), {
        ...size,
        samples: fullOr(256, 128),
      });
      const { share, rmse } = likeness(truth, data);
      if (process.env['STILL_REPORT'] !== undefined) {
        console.log(name, share.toFixed(4), rmse.toFixed(3));
      }
      expect.soft(share, name).toBeGreaterThan(leastShare);
      expect.soft(rmse, name).toBeLessThan(mostRmse);
    }
  });
}

test('a JPEG has the colours that the browser decodes, within four codes', async ({
  page,
  mount,
}) => {
  await mount('<phong-viewer alt="" geometry="box"></phong-viewer>');
  for (const name of ['spider/SpiderTex.jpg', 'spider/drkwood2.jpg', 'spider/engineflare1.jpg']) {
    const file = new URL(`../../../demo/assets/models/real/${name}`, import.meta.url);
    const bytes = readFileSync(file);
    const { data } = await decodeImage({ bytes: Uint8Array.from(bytes), type: 'image/jpeg' });
    const { data: there } = await decodeInPage(page, bytes);
    let [most, within] = [0, 0];
    for (const [i, code] of there.entries()) {
      const error = Math.abs(code - data[i]!);
      most = Math.max(most, error);
      within += Number(error <= 1);
    }
    // Their transforms round differently. Chroma between its samples would be off by up to 77.
    expect(most, name).toBeLessThanOrEqual(4);
    expect(within / data.length, name).toBeGreaterThan(0.97);
  }
});
