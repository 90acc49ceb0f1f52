// @ts-check
// How commands in plain JavaScript get at a browser and at a folder of built pages on a free port.
// What is not named is looked up in .ci/, which a machine without the repository has not.

import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';

/** By the end of a file's name. @type {Readonly<Record<string, string>>} */
export const TYPES = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.mjs': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.json': 'application/json',
  '.map': 'application/json',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.jpg': 'image/jpeg',
  '.webp': 'image/webp',
  '.glb': 'model/gltf-binary',
  '.gltf': 'model/gltf+json',
  '.wasm': 'application/wasm',
};

/**
 * The named Chromium with the named arguments, or this machine's own with software GL.
 * @param {string} browser @param {readonly string[]} args
 */
export async function launchOptions(browser, args) {
  const own = ['--no-sandbox', '--disable-background-networking', ...args];
  if (browser !== '' && args.length > 0) return { executablePath: browser, args: own };
  const { ensureBrowser, softwareGl } = await import('../../.ci/browser.mjs');
  return {
    executablePath: browser || (await ensureBrowser()),
    args: args.length > 0 ? own : softwareGl,
  };
}

/**
 * @param {string} folder
 * @param {() => boolean} [compresses] whether files that are kept in brotli too are sent so now, as
 * over a network
 */
export async function serveFolder(folder, compresses = () => false) {
  const server = createServer((request, response) => {
    const path = normalize(new URL(request.url ?? '/', 'http://localhost').pathname);
    const type = { 'content-type': TYPES[extname(path)] ?? 'application/octet-stream' };
    const plain = () =>
      readFile(join(folder, path)).then(
        (file) => response.writeHead(200, type).end(file),
        () => response.writeHead(404).end(),
      );
    if (!compresses()) return void plain();
    readFile(join(folder, `${path}.br`)).then(
      (file) => response.writeHead(200, { ...type, 'content-encoding': 'br' }).end(file),
      plain,
    );
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(undefined)));
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  return {
    origin: `http://localhost:${port}`,
    close() {
      server.closeAllConnections();
      server.close();
    },
  };
}
