// The site: served from demo/ by `npm start`, built to site/ by `npm run build:site`. Every page is
// an entry and links are relative, so the folder can be copied anywhere.

import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { licences } from './.ci/licences/plugin.js';
import { basisTranscoder } from './.ci/basis-transcoder.js';
import { dracoDecoder } from './.ci/draco-decoder.js';
import { outputFolder } from './.ci/output-folder.mjs';
import { packageAliases } from './.ci/package-aliases.js';
import { elementData, pageFiles, sitePages } from './.ci/site/plugin.js';
import { strippedGlsl } from './.ci/strip-glsl.js';
import { textKeys } from './.ci/text-keys.js';

const repository = fileURLToPath(new URL('.', import.meta.url));
const demo = join(repository, 'demo');

export default defineConfig({
  root: demo,
  base: './',
  // A missing page is an error, not the first page.
  appType: 'mpa',
  publicDir: false,
  plugins: [
    dracoDecoder(),
    basisTranscoder(),
    strippedGlsl(),
    textKeys(),
    licences(),
    elementData(),
    sitePages(),
  ],
  resolve: {
    alias: packageAliases,
    // Lit's development build would log a warning on every page.
    conditions: ['module', 'browser', 'production'],
  },
  optimizeDeps: {
    // Named here because Vite would find the lazy ones late, reload the page and load a second
    // three.
    include: [
      'three',
      'three/addons/loaders/GLTFLoader.js',
      'three/addons/geometries/TeapotGeometry.js',
      'three/addons/libs/meshopt_decoder.module.js',
      'lit',
      'lil-gui',
      'minisearch',
    ],
  },
  server: { fs: { allow: [repository] } },
  // Workers are modules of their own, built by Vite as a user's are.
  worker: { format: 'es', plugins: () => [dracoDecoder(), basisTranscoder()] },
  build: {
    outDir: outputFolder('site'),
    emptyOutDir: true,
    target: 'es2022',
    assetsDir: 'built',
    // A strict CSP does not allow data: URLs.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 1024,
    rolldownOptions: { input: pageFiles() },
  },
});
