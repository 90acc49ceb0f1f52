// @ts-check
// `npm run readme:picture`: draws the README's page with the built package and stores it as the
// README's picture. The picture shows exactly that markup; tests/visual/readme.spec.ts compares the
// two. Needs `npm run build` first.

import { createReadStream, existsSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { join, normalize } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { readCommandLine } from '../tests/support/command-line.mjs';
import { ensureBrowser, softwareGl } from './browser.mjs';
import { needBuilt, outputFolder } from './output-folder.mjs';

const repository = fileURLToPath(new URL('..', import.meta.url));

/** Relative to the repository. */
export const README_PICTURE = 'demo/assets/images/readme.webp';

/** Device pixels per CSS pixel of the picture. */
export const README_PICTURE_SCALE = 1.5;

/**
 * The page that follows the README's picture.
 * @returns {string}
 */
export function readmePage() {
  const text = readFileSync(join(repository, 'README.md'), 'utf8');
  const snippet = /!\[[^\]]+\]\(([^)]+)\)\n\n```html\n([^]*?)```/.exec(text);
  if (snippet?.[1] !== README_PICTURE || snippet[2] === undefined) {
    throw new Error(`README.md must show ${README_PICTURE}, followed by a block of HTML`);
  }
  return snippet[2];
}

/** The scene of that page. @returns {string} */
export const readmeSnippet = () =>
  /<phong-viewer[^]*<\/phong-viewer>/.exec(readmePage())?.[0] ?? '';

/**
 * As WebP, by the browser: a quarter of the PNG's bytes, which every copy of the package would hold.
 * The lowest quality that looks the same: 0.8 shows blocks on the teapot, enlarged three times.
 * @param {import('@playwright/test').Page} page
 * @param {Buffer} png
 * @returns {Promise<Buffer>}
 */
async function webpOf(page, png) {
  const base64 = await page.evaluate(
    async (source) => {
      const image = new Image();
      image.src = source;
      await image.decode();
      const canvas = document.createElement('canvas');
      canvas.width = image.naturalWidth;
      canvas.height = image.naturalHeight;
      canvas.getContext('2d')?.drawImage(image, 0, 0);
      return canvas.toDataURL('image/webp', 0.85).split(',')[1] ?? '';
    },
    `data:image/png;base64,${png.toString('base64')}`,
  );
  return Buffer.from(base64, 'base64');
}

async function draw() {
  readCommandLine(
    "npm run readme:picture: draws the README's page with the built package as its picture",
    {},
  );
  const dist = outputFolder('dist');
  needBuilt(join(dist, 'phong-viewer.classic.js'), 'npm run build');
  const server = createServer((request, response) => {
    const path = normalize(
      join(dist, decodeURIComponent(new URL(request.url ?? '/', 'http://x').pathname)),
    );
    if (request.url === '/') {
      response.setHeader('content-type', 'text/html').end(readmePage());
    } else if (path.startsWith(dist) && existsSync(path) && statSync(path).isFile()) {
      response.setHeader('content-type', 'text/javascript');
      createReadStream(path).pipe(response);
    } else {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, 'localhost', () => resolve(undefined)));
  const address = server.address();
  if (address === null || typeof address === 'string') throw new Error('the server has no port');
  const { chromium } = await import('@playwright/test');
  const browser = await chromium.launch({
    executablePath: await ensureBrowser(),
    args: softwareGl,
  });
  try {
    const page = await browser.newPage({
      viewport: { width: 900, height: 600 },
      deviceScaleFactor: README_PICTURE_SCALE,
    });
    await page.goto(`http://localhost:${String(address.port)}/`);
    const viewer = page.locator('phong-viewer');
    await viewer.evaluate(async (element) => {
      await customElements.whenDefined('phong-viewer');
      await /** @type {HTMLElement & { ready: Promise<void> }} */ (element).ready;
    });
    // The panel is fetched on its own, and the picture beside it converges anew.
    await viewer.getByText('copy HTML').waitFor();
    await page.waitForFunction(() => {
      const { samples, stats } =
        /** @type {HTMLElement & { samples: number, stats: { samples: number } }} */ (
          document.querySelector('phong-viewer')
        );
      return stats.samples === samples;
    });
    const file = join(repository, README_PICTURE);
    writeFileSync(file, await webpOf(page, await viewer.screenshot()));
    console.log(`${README_PICTURE}: ${String(Math.round(statSync(file).size / 1024))} KiB`);
  } finally {
    await browser.close();
    server.close();
  }
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) {
  await draw();
}
