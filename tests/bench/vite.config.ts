// The bench's pages, minified as a user's bundler would, to the folder PHONG_VIEWER_BENCH_OUT. The product's sources are
// those of PHONG_VIEWER_BENCH_SOURCE: this repository, or another revision's checkout.

import { existsSync, readdirSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { dracoDecoder } from '../../.ci/draco-decoder.js';
import { strippedGlsl } from '../../.ci/strip-glsl.js';

const pages = fileURLToPath(new URL('pages', import.meta.url));
const repository = fileURLToPath(new URL('../..', import.meta.url));
const source = resolve(process.env['PHONG_VIEWER_BENCH_SOURCE'] || repository, 'src');
const hasModelViewer = existsSync(
  fileURLToPath(new URL('peers/model-viewer/node_modules/@google/model-viewer', import.meta.url)),
);

export default defineConfig({
  root: pages,
  base: './',
  publicDir: false,
  plugins: [dracoDecoder(), strippedGlsl()],
  define: { 'process.env.NODE_ENV': '"production"' },
  resolve: {
    alias: [
      { find: /^phong-viewer$/, replacement: join(source, 'index.ts') },
      { find: /^phong-viewer\/core$/, replacement: join(source, 'core.ts') },
    ],
  },
  build: {
    outDir: process.env['PHONG_VIEWER_BENCH_OUT'] ?? '',
    emptyOutDir: true,
    target: 'es2022',
    modulePreload: { polyfill: false },
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 2048,
    // For profiles, whose functions are to have names.
    minify: process.env['PHONG_VIEWER_BENCH_NAMES'] === undefined,
    rolldownOptions: {
      input: readdirSync(pages)
        .filter((name) => name.endsWith('.html') && (hasModelViewer || !name.includes('model-viewer')))
        .map((name) => join(pages, name)),
    },
  },
});
