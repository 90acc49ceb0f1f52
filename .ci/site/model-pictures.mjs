// @ts-check
// `npm run site:models`: draws the models of the site's page of models with three.js, from the eye
// that each viewer there has chosen, and stores the pictures that the page shows beside its own.
// Needs `npm run build:site` before, and again after.

import { mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { readCommandLine } from '../../tests/support/command-line.mjs';
import { ensureBrowser, softwareGl } from '../browser.mjs';
import { needBuilt, outputFolder } from '../output-folder.mjs';

const repository = fileURLToPath(new URL('../..', import.meta.url));
const pictures = join(repository, 'demo/assets/images/models');
const SIZE = { width: 480, height: 360 };

/** @typedef {import('./three-picture.js')} ThreePicture */
/**
 * @typedef {object} Viewer what is used of `<phong-viewer>`
 * @property {string} src
 * @property {boolean} loaded
 * @property {number} fov
 * @property {{ eye: [number, number, number], target: [number, number, number], up: [number,
 * number, number], radius: number }} camera
 */

/** Address to folder, the longest first. */
const folders = /** @type {const} */ ([
  ['/three/', join(repository, 'node_modules/three')],
  ['/script/', fileURLToPath(new URL('.', import.meta.url))],
  ['/', outputFolder('site')],
]);
/** @type {Readonly<Record<string, string>>} */
const types = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
};
const imports = { three: '/three/build/three.module.js', 'three/addons/': '/three/examples/jsm/' };
const page = `<!doctype html><meta charset="utf-8"><title>three.js</title><link rel="icon" href="data:,">
<script type="importmap">${JSON.stringify({ imports })}</script>
<script type="module">import * as picture from '/script/three-picture.js'; self.picture = picture;</script>`;

readCommandLine("npm run site:models: draws by three.js what the site's page of models shows", {});
needBuilt(join(outputFolder('site'), 'models/index.html'), 'npm run build:site');

const server = createServer((request, response) => {
  const path = decodeURIComponent(new URL(request.url ?? '/', 'http://localhost').pathname);
  if (path === '/three') return void response.setHeader('content-type', 'text/html').end(page);
  const [start, folder] = folders.find(([prefix]) => path.startsWith(prefix)) ?? folders[2];
  let file = join(folder, normalize(`/${path.slice(start.length)}`));
  if (path.endsWith('/')) {
    file = join(file, 'index.html');
  }
  if (!statSync(file, { throwIfNoEntry: false })?.isFile()) {
    return void response.writeHead(404).end();
  }
  response.setHeader('content-type', types[extname(file)] ?? 'application/octet-stream');
  response.end(readFileSync(file));
});
await new Promise((resolve) => server.listen(0, 'localhost', () => resolve(undefined)));
const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
const origin = `http://localhost:${String(port)}`;
const { chromium } = await import('@playwright/test');
const browser = await chromium.launch({ executablePath: await ensureBrowser(), args: softwareGl });
try {
  const site = await browser.newPage();
  await site.goto(`${origin}/models/`);
  const three = await browser.newPage();
  await three.goto(`${origin}/three`);
  await three.waitForFunction(() => 'picture' in self);
  mkdirSync(pictures, { recursive: true });
  for (const item of await site.locator('.pairs > li').all()) {
    const element = item.locator('phong-viewer');
    await element.scrollIntoViewIfNeeded();
    const { url, view } = await element.evaluate(async (node) => {
      const viewer = /** @type {Viewer} */ (/** @type {unknown} */ (node));
      while (!viewer.loaded) {
        await new Promise((resolve) => requestAnimationFrame(resolve));
      }
      const { eye, target, up, radius } = viewer.camera;
      return {
        url: new URL(viewer.src, location.href).href,
        view: { eye, target, up, radius, fov: viewer.fov },
      };
    });
    const data = await three.evaluate(
      ([address, seen]) =>
        /** @type {{ picture: ThreePicture }} */ (/** @type {unknown} */ (self)).picture.pictureOf(
          address,
          seen,
        ),
      /** @type {const} */ ([url, { ...view, ...SIZE }]),
    );
    const file = `${String(await item.getAttribute('id'))}.webp`;
    const bytes = Buffer.from(data.slice(data.indexOf(',') + 1), 'base64');
    writeFileSync(join(pictures, file), bytes);
    console.log(`${file}: ${(bytes.length / 1024).toFixed(1)} KiB`);
  }
} finally {
  await browser.close();
  server.close();
}
