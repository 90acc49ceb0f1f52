// Builds the page that tests the shipped GLSL against float64 in a browser: tests/glsl/page to
// dist-harness/.

import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { outputFolder } from '../output-folder.mjs';

const page = (name: string): string =>
  fileURLToPath(new URL(`../../tests/glsl/page/${name}.html`, import.meta.url));

export default defineConfig({
  root: fileURLToPath(new URL('../../tests/glsl/page', import.meta.url)),
  base: './',
  publicDir: false,
  build: {
    outDir: outputFolder('dist-harness'),
    emptyOutDir: true,
    target: 'es2022',
    modulePreload: { polyfill: false },
    assetsInlineLimit: 0,
    rolldownOptions: { input: [page('index'), page('core')] },
  },
});
