// The same bytes in Node and in a page, and what the screen shows within one code. Scenes of the
// site; without textures. A release run takes all of them.
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { build, type Rolldown } from 'vite';
import { decodeImage } from '../../../src/extras/still/images.js';
import { still } from '../../../src/extras/still/index.js';
import { firstOf, fullOr } from '../../support/repeats.js';
import { expect, pixels, test } from '../../support/test.js';

/** Pixels of a scene: small, so that the slow ones among them take a second. */
const SIZE = { width: 152, height: 84 };

interface SiteScene {
  readonly name: string;
  readonly markup: string;
  readonly base: URL;
}

/** The viewers of a page of the site, without models. Each begins a line. */
function scenesOf(path: string): SiteScene[] {
  const file = fileURLToPath(new URL(`../../../demo/${path}`, import.meta.url));
  const found = readFileSync(file, 'utf8').match(/^ *<phong-viewer\b[^]*?<\/phong-viewer>/gm) ?? [];
  return found
    .filter((markup) => !/ src=|<script|view="triangles"/.test(markup))
    .map((markup, i) => ({ name: `${path} ${i}`, markup, base: pathToFileURL(file) }));
}

const PAGES = [
  'scenes/spot.html',
  'scenes/exponents.html',
  'scenes/room.html',
  'scenes/colours.html',
  'guide/see.md',
  'guide/light.md',
  'guide/models.md',
  'guide/reference.md',
  'guide/camera.md',
  'scenes/lesson.html',
  'scenes/product.html',
  'scenes/compare.html',
  'scenes/lamp.html',
  'scenes/sun.html',
  'scenes/camera-light.html',
];
const SCENES = firstOf(PAGES, 5).flatMap((path) => scenesOf(path).slice(0, fullOr(30, 2)));

/** The code of stills as one script for a page: the same source. */
async function pageCode(): Promise<string> {
  const result = await build({
    configFile: false,
    logLevel: 'error',
    plugins: [
      {
        name: 'without-decoders',
        enforce: 'pre',
        resolveId: (name) => (/^\.\/(draco|ktx2-worker|meshopt)\.js$/.test(name) ? '\0none' : null),
        load: (id) => (id === '\0none' ? 'export {};' : null),
      },
    ],
    build: {
      write: false,
      target: 'es2022',
      minify: false,
      lib: {
        entry: fileURLToPath(new URL('../../../src/extras/still/index.ts', import.meta.url)),
        formats: ['es'],
      },
      rolldownOptions: {
        external: /^(node:|pngjs|jpeg-js)/,
        output: { codeSplitting: false },
      },
    },
  });
  const [{ output }] = [result].flat() as Rolldown.RolldownOutput[] as [Rolldown.RolldownOutput];
  return output[0].code.replace(/export \{ still \};?\s*$/, 'globalThis.still = still;');
}

/** Lets the test's own script run. */
const OPEN = "script-src 'self' 'unsafe-inline'";

const sha = (bytes: Uint8Array): string => createHash('sha256').update(bytes).digest('hex');

test('a still has the same bytes in Node and in a page', async ({ page, mount }) => {
  test.setTimeout(fullOr(1_200_000, 120_000));
  await mount('<phong-viewer alt="" geometry="box"></phong-viewer>', { csp: OPEN });
  await page.addScriptTag({ type: 'module', content: await pageCode() });
  await page.waitForFunction(() => 'still' in globalThis);
  for (const { name, markup, base } of SCENES) {
    const here = await still(markup, { ...SIZE, base, threads: 1 });
    const there = await page.evaluate(
      async ([text, size, address]) => {
        const draw = (globalThis as unknown as { still: typeof still }).still;
        const { pixels: found, png } = await draw(text, { ...size, base: address });
        return [[...found], [...png]];
      },
      [markup, SIZE, base.href] as const,
    );
    expect(sha(Uint8Array.from(there[0]!)), name).toBe(sha(here.pixels));
    expect(sha(Uint8Array.from(there[1]!)), name).toBe(sha(here.png));
  }
});

test('the screen shows a still, nearly all of it within one code', async ({ page, mount }) => {
  test.setTimeout(fullOr(1_200_000, 120_000));
  for (const { name, markup, base } of SCENES) {
    const { pixels: truth } = await still(markup, { ...SIZE, base, threads: 1 });
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
      return [...context.getImageData(0, 0, image.width, image.height).data];
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
