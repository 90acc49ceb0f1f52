// Builds one page of the bench, PHONG_VIEWER_BENCH_PAGE, into the folder PHONG_VIEWER_BENCH_OUT, as a user's bundler would: the
// package comes from dist/. Each page is built alone, since pages built together share chunks and load what others need.

import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { outputFolder } from '../../.ci/output-folder.mjs';

const pages = fileURLToPath(new URL('pages', import.meta.url));
const dist = outputFolder('dist');

export default defineConfig({
  root: pages,
  base: './',
  publicDir: false,
  define: { 'process.env.NODE_ENV': '"production"' },
  resolve: {
    alias: [
      { find: /^phong-viewer$/, replacement: join(dist, 'index.js') },
      { find: /^phong-viewer\/(core|reference)$/, replacement: join(dist, '$1.js') },
    ],
  },
  build: {
    outDir: process.env['PHONG_VIEWER_BENCH_OUT'] ?? '',
    emptyOutDir: false, // it holds the other pages
    target: 'es2022',
    modulePreload: { polyfill: false },
    assetsInlineLimit: 0,
    chunkSizeWarningLimit: 2048,
    rolldownOptions: {
      input: join(pages, process.env['PHONG_VIEWER_BENCH_PAGE'] ?? ''),
      // The standalone file and others' viewers are measured as they are.
      external: /(?:phong-viewer\.standalone|model-viewer\.min|babylon-viewer\.esm\.min)\.js$/,
    },
  },
});
