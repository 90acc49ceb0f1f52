// Builds dist/phong-viewer.standalone.js for pages without a bundler. three and Lit are inside.
// Panel, loaders and decoders are in dist/chunks, fetched on first use relative to the file itself.
// Runs after lib.config.ts, which empties dist/.

import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { licences } from '../licences/plugin.js';
import { basisTranscoder } from '../basis-transcoder.js';
import { decoderWorkers } from '../decoder-workers.js';
import { dracoDecoder } from '../draco-decoder.js';
import { gltfLoader } from '../gltf-loader.js';
import { minifiedAgain } from '../minified-again.js';
import { modelChunks } from '../model-chunks.js';
import { nativeMath } from '../native-math.js';
import { outputFolder } from '../output-folder.mjs';
import { retriedImports } from '../retried-imports.js';
import { standaloneThree } from '../standalone-three/plugin.js';
import { strippedGlsl } from '../strip-glsl.js';
import { textKeys } from '../text-keys.js';
import { wasmFiles } from '../wasm-files.js';

export default defineConfig({
  base: './',
  publicDir: false,
  plugins: [
    dracoDecoder(),
    basisTranscoder(),
    wasmFiles(),
    standaloneThree(),
    gltfLoader(),
    nativeMath(),
    strippedGlsl(),
    textKeys(),
    licences(),
    retriedImports(),
    minifiedAgain(),
    decoderWorkers({
      plugins: () => [dracoDecoder(), basisTranscoder(), licences({ listed: false })],
    }),
  ],
  define: { 'process.env.NODE_ENV': '"production"' },
  build: {
    outDir: outputFolder('dist'),
    emptyOutDir: false,
    target: 'es2022',
    chunkSizeWarningLimit: 1024,
    lib: {
      entry: {
        'phong-viewer.standalone': fileURLToPath(
          new URL('../../src/viewer/index.ts', import.meta.url),
        ),
      },
      formats: ['es'],
      fileName: (_format, name) => `${name}.js`,
    },
    rolldownOptions: {
      // Lets chunks import from the entry. Otherwise the code that they share with it (most of
      // three) would be a second file that every page has to fetch. For the same reason all static
      // imports are one chunk.
      preserveEntrySignatures: 'allow-extension',
      // A constant's value is shorter than its name, and repeated values compress well.
      optimization: { inlineConst: { mode: 'all' } },
      output: {
        // npm sorts files by name and compresses them in a row. With the full stop and the 0, each
        // chunk comes just before that of the same name among the ES modules. Where it came after,
        // by the letter its hash began with, equal code was too far apart: 5 kB more.
        chunkFileNames: 'chunks/[name].0[hash:7].js',
        minify: true,
        // Browsers keep a script's text: one byte for each character, or two where one character is
        // beyond Latin-1.
        charset: 'ascii',
        // Only annotations for another bundler's tree shaking are left to drop; the licences are
        // added later.
        comments: false,
        codeSplitting: {
          groups: [{ name: 'phong-viewer.standalone', tags: ['$initial'] }, ...modelChunks],
        },
      },
    },
  },
});
