// The demo: served from source by `npm start`, built to dist-demo/ by `npm run demo:build`.
// Every page is an entry and links are relative. Files in demo/assets keep their names, because Vite does not follow the `src`
// of a custom element.

import { cpSync, existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';
import { licences } from './.ci/licences/plugin.js';
import { dracoDecoder } from './.ci/draco-decoder.js';
import { outputFolder } from './.ci/output-folder.mjs';
import { packageAliases } from './.ci/package-aliases.js';
import { strippedGlsl } from './.ci/strip-glsl.js';

const repository = fileURLToPath(new URL('.', import.meta.url));
const demo = join(repository, 'demo');
const output = outputFolder('dist-demo');

function pages(): string[] {
  return readdirSync(demo, { recursive: true, encoding: 'utf8' })
    .filter((path) => path.endsWith('.html'))
    .map((path) => join(demo, path));
}

function copiedAssets(): Plugin {
  const assets = join(demo, 'assets');
  return {
    name: 'copied-assets',
    apply: 'build',
    writeBundle() {
      if (existsSync(assets)) cpSync(assets, join(output, 'assets'), { recursive: true });
    },
  };
}

export default defineConfig({
  root: demo,
  base: './',
  // A missing page is an error, not the first page.
  appType: 'mpa',
  publicDir: false,
  plugins: [dracoDecoder(), strippedGlsl(), licences(), copiedAssets()],
  resolve: {
    alias: packageAliases,
    // Lit's development build would log a warning on every page.
    conditions: ['module', 'browser', 'production'],
  },
  optimizeDeps: {
    // Named here because Vite would find the lazy ones late, reload the page and load a second three.
    include: [
      'three',
      'three/addons/loaders/GLTFLoader.js',
      'three/addons/geometries/TeapotGeometry.js',
      'three/addons/libs/meshopt_decoder.module.js',
      '@lit/reactive-element',
      'lil-gui',
    ],
  },
  server: { fs: { allow: [repository] } },
  build: {
    outDir: output,
    emptyOutDir: true,
    target: 'es2022',
    assetsDir: 'built',
    // A strict CSP does not allow data: URLs.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    chunkSizeWarningLimit: 1024,
    rolldownOptions: { input: pages() },
  },
});
