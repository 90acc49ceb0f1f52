// One page of the bench, PHONG_VIEWER_BENCH_PAGE, minified as a user's bundler would, into the folder PHONG_VIEWER_BENCH_OUT. Each
// is built alone: pages built together share chunks, and would load what only others need. The elements are imported from the
// built package, PHONG_VIEWER_BENCH_PACKAGE, as their users do; what benches alone import comes from the sources of
// PHONG_VIEWER_BENCH_SOURCE: this repository, or another revision's checkout.

import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { dracoDecoder } from '../../.ci/draco-decoder.js';
import { strippedGlsl } from '../../.ci/strip-glsl.js';

const pages = fileURLToPath(new URL('pages', import.meta.url));
const repository = fileURLToPath(new URL('../..', import.meta.url));
const source = resolve(process.env['PHONG_VIEWER_BENCH_SOURCE'] || repository, 'src');
export default defineConfig({
  root: pages,
  base: './',
  publicDir: false,
  plugins: [dracoDecoder(), strippedGlsl()],
  define: { 'process.env.NODE_ENV': '"production"' },
  resolve: {
    alias: [
      {
        find: /^phong-viewer$/,
        replacement: process.env['PHONG_VIEWER_BENCH_PACKAGE'] || join(source, 'index.ts'),
      },
      { find: /^phong-viewer\/core$/, replacement: join(source, 'core.ts') },
    ],
  },
  build: {
    outDir: process.env['PHONG_VIEWER_BENCH_OUT'] ?? '',
    emptyOutDir: false, // it holds the other pages
    target: 'es2022',
    modulePreload: { polyfill: false },
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 2048,
    // For profiles, whose functions are to have names.
    minify: process.env['PHONG_VIEWER_BENCH_NAMES'] === undefined,
    rolldownOptions: { input: join(pages, process.env['PHONG_VIEWER_BENCH_PAGE'] ?? '') },
  },
});
