// Records which files of dist/ a page fetches, and how large they are as sent. The package is used
// in two ways: as the standalone file, and as ES modules through an import map.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { brotliCompressSync } from 'node:zlib';
import type { Page } from '@playwright/test';
import { outputFolder } from '../../.ci/output-folder.mjs';
import type { PageOptions } from '../support/site.js';

const imports = {
  'phong-viewer': '/dist/index.js',
  'phong-viewer/core': '/dist/core.js',
  'phong-viewer/reference': '/dist/reference.js',
  three: '/node_modules/three/build/three.module.js',
  'three/addons/': '/node_modules/three/examples/jsm/',
  lit: '/node_modules/lit/index.js',
  'lit/': '/node_modules/lit/',
  'lit-html': '/node_modules/lit-html/lit-html.js',
  'lit-html/': '/node_modules/lit-html/',
  'lit-element/': '/node_modules/lit-element/',
  '@lit/reactive-element': '/node_modules/@lit/reactive-element/reactive-element.js',
  '@lit/reactive-element/': '/node_modules/@lit/reactive-element/',
  'lil-gui': '/node_modules/lil-gui/dist/lil-gui.esm.js',
};

const css = 'phong-viewer { display: block; width: 600px; height: 400px }';
const importMap = `<script type="importmap">${JSON.stringify({ imports })}</script>`;

/**
 * Options of a page for each way. An import map is an inline script, which the strict policy
 * forbids.
 */
export const usages: Readonly<Record<'standalone' | 'modules', PageOptions>> = {
  standalone: {
    css,
    head: '<script type="module" src="/dist/phong-viewer.standalone.js"></script>',
  },
  modules: {
    css,
    csp: '',
    head: `${importMap}<script type="module" src="/dist/index.js"></script>`,
  },
};

export class Requests {
  readonly #paths: string[] = [];

  constructor(page: Page) {
    page.on('request', (request) => this.#paths.push(new URL(request.url()).pathname));
  }

  /** Paths below dist/ that were requested since the last call. */
  take(): string[] {
    return this.#paths
      .splice(0)
      .flatMap((path) => (path.startsWith('/dist/') ? [path.slice(6)] : []));
  }
}

/** `shared/panel.js` and `chunks/panel.D3adBeef.js` are both the chunk `panel`. */
export const chunkName = (path: string): string =>
  path
    .replace(/^shared\/(.*)\.js$/, '$1')
    .replace(/^chunks\/(.*)[-.][\w-]{8}\.js$/, '$1')
    .replace(/^chunks\/(.*\.wasm)$/, '$1');

/** Bytes of this text as a server sends it, compressed by Brotli at its highest level. */
export const brotliSize = (text: string | Buffer): number => brotliCompressSync(text).length;

/** Bytes of these files of dist/, each compressed for itself. */
export const sentSize = (paths: readonly string[]): number =>
  paths.reduce((sum, path) => sum + brotliSize(readFileSync(join(outputFolder('dist'), path))), 0);
