// The server behind the browser tests: folders under fixed addresses, pages from memory, every page
// under a Content-Security-Policy. Listens on a free port, so that several runs can share a
// machine. Knows no test.

import { createReadStream, statSync } from 'node:fs';
import { createServer, type ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import { extname, join, normalize } from 'node:path';
import { outputFolder } from '../../.ci/output-folder.mjs';
import { TYPES } from './built-pages.mjs';
import { repository } from './repository.mjs';

/** The strict policy: no inline code or style, no eval, no `blob:` worker. */
export const strictPolicy =
  "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self'";

/** The same for models that need WebAssembly. */
export const wasmPolicy = strictPolicy.replace(
  "script-src 'self'",
  "script-src 'self' 'wasm-unsafe-eval'",
);

export interface PageOptions {
  /** Content-Security-Policy; default strict; empty for none. */
  readonly csp?: string;
  /** Rules of the page's one style sheet (inline styles are refused by the strict policy). */
  readonly css?: string;
  /**
   * true: viewers without a name keep none, and the package warns. Default: they get an `alt`,
   * because most tests are about other things.
   */
  readonly nameless?: boolean;
  /** What goes into the head after the style sheet, such as a `<script type="module" src="…">`. */
  readonly head?: string;
}

export interface Site {
  /** Such as `http://localhost:40123`, no slash at the end. */
  readonly origin: string;
  /** Keeps a page with this body in memory and gives its address. */
  page(body: string, options?: PageOptions): string;
  /**
   * Keeps a file in memory and gives its address; a later file takes its place. `gzip`: its bytes
   * are compressed.
   */
  file(bytes: Uint8Array, gzip?: boolean): string;
  close(): Promise<void>;
}

interface Stored {
  readonly type: string;
  readonly text: string | Uint8Array;
  readonly csp: string;
  readonly gzip?: boolean;
}

/** Address prefix to folder, for the tests of this repository. */
export const testMounts: Readonly<Record<string, string>> = {
  '/dist/': outputFolder('dist'),
  '/demo/': outputFolder('site'),
  '/harness/': outputFolder('dist-harness'),
  '/fixtures/': join(repository, 'tests/fixtures'),
  '/assets/': join(repository, 'demo/assets'),
  '/node_modules/': join(repository, 'node_modules'),
};

/** @param policy the Content-Security-Policy of files; pages from memory have their own. */
export async function startSite(
  mounts: Readonly<Record<string, string>>,
  policy = strictPolicy,
): Promise<Site> {
  const stored = new Map<string, Stored>();
  const server = createServer((request, response) => {
    const path = decodeURIComponent(new URL(request.url ?? '/', 'http://localhost').pathname);
    const page = stored.get(path);
    if (page) {
      sendText(response, page);
    } else if (path === '/favicon.ico') {
      response.writeHead(204).end();
    } else {
      sendFile(response, fileUnder(mounts, path), policy);
    }
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  const { port } = server.address() as AddressInfo;
  const origin = `http://localhost:${port}`;
  return {
    origin,
    page(body, { csp = strictPolicy, css = '', head = '', nameless = false } = {}) {
      const path = `/page/${stored.size}`;
      const text =
        `<!doctype html>\n<html lang="en">\n<head><meta charset="utf-8"><title>Test page</title>\n` +
        `<link rel="stylesheet" href="${path}.css">${head}</head>\n<body>${nameless ? body : named(body)}\n</body>\n</html>\n`;
      stored.set(path, { type: '.html', text, csp });
      stored.set(`${path}.css`, { type: '.css', text: css, csp });
      return origin + path;
    },
    file(bytes, gzip = false) {
      stored.set('/file', { type: '', text: bytes, csp: strictPolicy, gzip });
      return `${origin}/file`;
    },
    close() {
      server.closeAllConnections();
      return new Promise((resolve) => server.close(() => resolve()));
    },
  };
}

/**
 * Gives each viewer of this markup an `alt`, unless it has a name or is hidden from assistive
 * technology.
 */
export const named = (markup: string): string =>
  markup.replace(
    /<phong-viewer(?=[\s>])(?![^>]*\s(?:alt\b|aria-label\b|aria-labelledby\b|aria-hidden\b|role="(?:none|presentation)))/g,
    '<phong-viewer alt="A test scene"',
  );

// Browsers keep compiled code only of scripts that they may cache: a sixth of the CPU time of a
// small page. An hour outlives a run. Each server has a port of its own, so that no run meets the
// scripts of another.
const kept = { 'cache-control': 'max-age=3600' } as const;
const keptTypes: ReadonlySet<string> = new Set(['.js', '.mjs']);

function fileUnder(mounts: Readonly<Record<string, string>>, path: string) {
  const prefix = Object.keys(mounts).find((start) => path.startsWith(start));
  if (prefix === undefined) return undefined;
  const inside = normalize(`/${path.slice(prefix.length)}`);
  const file = join(mounts[prefix]!, inside);
  const stats = statSync(file, { throwIfNoEntry: false });
  if (stats?.isDirectory()) return path.endsWith('/') ? join(file, 'index.html') : undefined;
  return stats === undefined ? undefined : file;
}

function sendText(response: ServerResponse, { type, text, csp, gzip = false }: Stored) {
  response
    .writeHead(200, { ...headers(type, csp), ...(gzip ? { 'content-encoding': 'gzip' } : {}) })
    .end(text);
}

function sendFile(response: ServerResponse, file: string | undefined, policy: string) {
  if (file === undefined) {
    response.writeHead(404, { 'content-type': 'text/plain' }).end('Not found');
    return;
  }
  const type = extname(file);
  response.writeHead(200, { ...headers(type, policy), ...(keptTypes.has(type) ? kept : {}) });
  createReadStream(file)
    .on('error', () => response.destroy())
    .pipe(response);
}

function headers(type: string, csp: string): Record<string, string> {
  return {
    'content-type': TYPES[type] ?? 'application/octet-stream',
    'cache-control': 'no-store',
    ...(csp === '' ? {} : { 'content-security-policy': csp }),
  };
}
