// Builds one page of the bench, PHONG_VIEWER_BENCH_PAGE, into the folder PHONG_VIEWER_BENCH_OUT, as
// a user's bundler would: the package comes from dist/. Each page is built alone, since pages built
// together share chunks and load what others need.

import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { outputFolder } from '../../.ci/output-folder.mjs';
import { htmlOf } from './pages.mjs';

const pages = fileURLToPath(new URL('pages', import.meta.url));
const dist = outputFolder('dist');
const name = process.env['PHONG_VIEWER_BENCH_PAGE'] ?? '';
const page = join(pages, `${name}.html`);

export default defineConfig({
  root: pages,
  base: './',
  publicDir: false,
  plugins: [
    {
      name: 'bench-page',
      resolveId: (id) => (id === page ? page : undefined),
      load: (id) => (id === page ? htmlOf(name) : undefined),
    },
  ],
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
      input: page,
      // The standalone file and others' viewers are measured as they are.
      external: /(?:phong-viewer\.standalone|model-viewer\.min|babylon-viewer\.esm\.min)\.js$/,
    },
  },
});
