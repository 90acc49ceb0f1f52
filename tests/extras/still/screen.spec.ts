// What the screen shows of a still's scene: with 256 samples, nearly all of it within one code. And
// the colours of decoded images.
import { readFileSync } from 'node:fs';
import { decodeImage } from '../../../src/extras/still/images.js';
import { still } from '../../../src/extras/still/index.js';
import { fullOr } from '../../support/repeats.js';
import { expect, pixels, test } from '../../support/test.js';
import { siteScenes } from './scenes.js';

/** Pixels of a scene: small, so that the slow ones among them take a second. */
const SIZE = { width: 152, height: 84 };

const SCENES = siteScenes(fullOr(Infinity, 5), fullOr(Infinity, 1));
test('the screen shows a still, nearly all of it within one code', async ({ page, mount }) => {
  test.setTimeout(fullOr(1_200_000, 120_000));
  for (const { name, markup } of SCENES) {
    const { pixels: truth } = await still(markup, { ...SIZE, threads: 1 });
    const resting = markup.replace(/ auto-rotate="[^"]*"/, '');
    await mount(resting.replace('<phong-viewer', '<phong-viewer loading="eager"'), SIZE);
    const drawn = await pixels(page.locator('phong-viewer').first(), { ...SIZE, samples: 256 });
    let [shown, within, squares] = [0, 0, 0];
    for (let i = 0; i < truth.length; i += 4) {
      if (truth[i + 3] === 0 && drawn.data[i + 3] === 0) continue;
      shown += 1;
      // Premultiplied: where little is covered, colours are rounded away.
      const errors = [0, 1, 2].map(
        (k) => (truth[i + k]! * truth[i + 3]! - drawn.data[i + k]! * drawn.data[i + 3]!) / 255,
      );
      within += Number(errors.every((error) => Math.abs(error) <= 1.5));
      squares += errors.reduce((sum, error) => sum + error * error, 0);
    }
    const share = within / shown;
    const rmse = Math.sqrt(squares / (3 * shown));
    if (process.env['STILL_REPORT'] !== undefined) {
      console.log(name, share.toFixed(4), rmse.toFixed(3));
    }
    // Pictures this small are a third outline, where both have errors of a code.
    expect.soft(share, name).toBeGreaterThan(0.91);
    expect.soft(rmse, name).toBeLessThan(1);
  }
});

test('a JPEG has the colours that the browser decodes, within four codes', async ({
  page,
  mount,
}) => {
  await mount('<phong-viewer alt="" geometry="box"></phong-viewer>');
  for (const name of ['spider/SpiderTex.jpg', 'spider/drkwood2.jpg', 'spider/engineflare1.jpg']) {
    const file = new URL(`../../../demo/assets/models/real/${name}`, import.meta.url);
    const bytes = readFileSync(file);
    const { data } = await decodeImage({ bytes: Uint8Array.from(bytes), type: 'image/jpeg' });
    const there = await page.evaluate(async (text) => {
      const file = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
      const image = await createImageBitmap(new Blob([file]), { colorSpaceConversion: 'none' });
      const context = new OffscreenCanvas(image.width, image.height).getContext('2d')!;
      context.drawImage(image, 0, 0);
      return new Uint8Array(context.getImageData(0, 0, image.width, image.height).data);
    }, bytes.toString('base64'));
    const errors = there.map((code, i) => Math.abs(code - data[i]!));
    // Their transforms round differently. Chroma between its samples would be off by up to 77.
    expect(
      errors.reduce((most, error) => Math.max(most, error), 0),
      name,
    ).toBeLessThanOrEqual(4);
    const within = errors.filter((error) => error <= 1).length / errors.length;
    expect(within, name).toBeGreaterThan(0.97);
  }
});
