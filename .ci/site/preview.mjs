// @ts-check
// `npm run site:picture`: draws the start page's scene as the picture that link previews show, in
// their size. Needs `npm run build` first.

import { readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { readCommandLine } from '../../tests/support/command-line.mjs';
import { ensureBrowser, softwareGl } from '../browser.mjs';
import { needBuilt, outputFolder } from '../output-folder.mjs';
import { readmeSnippet } from '../readme-picture.mjs';

const repository = fileURLToPath(new URL('../..', import.meta.url));
const picture = 'demo/assets/images/preview.png';
// The README's, which the start page shows too, as large as the picture.
const scene = readmeSnippet()
  .replace(/ style="[^"]*"/, '')
  .replace(/ gui\b/, '');
const html = `<!doctype html><html lang="en"><meta charset="utf-8"><title>Preview</title>
<style>body { margin: 0 } phong-viewer { display: block; width: 1200px; height: 630px; background: linear-gradient(#f7f9fc, #dfe5ec) }
h1 { position: absolute; left: 48px; top: 32px; margin: 0; color: #15171a; font: 600 34px monospace }</style>
<script type="module" src="/phong-viewer.standalone.js"></script>
<body>${scene}<h1>&lt;phong-viewer&gt;</h1></body>`;

readCommandLine(
  "npm run site:picture: draws the start page's scene as the picture of link previews",
  {},
);
const dist = outputFolder('dist');
needBuilt(join(dist, 'phong-viewer.standalone.js'), 'npm run build');
const server = createServer((request, response) => {
  const path = normalize(new URL(request.url ?? '/', 'http://localhost').pathname);
  if (path === '/') {
    response.setHeader('content-type', 'text/html').end(html);
  } else if (statSync(join(dist, path), { throwIfNoEntry: false })?.isFile()) {
    response.setHeader('content-type', 'text/javascript').end(readFileSync(join(dist, path)));
  } else {
    response.writeHead(404).end();
  }
});
await new Promise((resolve) => server.listen(0, 'localhost', () => resolve(undefined)));
const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
const { chromium } = await import('@playwright/test');
const browser = await chromium.launch({ executablePath: await ensureBrowser(), args: softwareGl });
try {
  const page = await browser.newPage({ viewport: { width: 1200, height: 630 } });
  await page.goto(`http://localhost:${String(port)}/`);
  await page.locator('phong-viewer').evaluate(async (element) => {
    await customElements.whenDefined('phong-viewer');
    await /** @type {HTMLElement & { ready: Promise<void> }} */ (element).ready;
  });
  await page.screenshot({ path: join(repository, picture) });
  console.log(
    `${picture}: ${String(Math.round(statSync(join(repository, picture)).size / 1024))} KiB`,
  );
} finally {
  await browser.close();
  server.close();
}
