// Builds dist/phong-viewer.classic.js: everything in one script that is no module, for pages opened
// from disk. Browsers refuse modules, and so chunks, on file:// pages. Runs after lib.config.ts,
// which empties dist/.

import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { licences } from '../licences/plugin.js';
import { basisTranscoder } from '../basis-transcoder.js';
import { decoderWorkers } from '../decoder-workers.js';
import { dracoDecoder } from '../draco-decoder.js';
import { gltfLoader } from '../gltf-loader.js';
import { nativeMath } from '../native-math.js';
import { outputFolder } from '../output-folder.mjs';
import { standaloneThree } from '../standalone-three/plugin.js';
import { strippedGlsl } from '../strip-glsl.js';
import { textKeys } from '../text-keys.js';
import { wasmFiles } from '../wasm-files.js';

export default defineConfig({
  publicDir: false,
  plugins: [
    dracoDecoder(),
    basisTranscoder(),
    wasmFiles({ file: false }),
    standaloneThree(),
    gltfLoader(),
    nativeMath(),
    strippedGlsl(),
    textKeys(),
    licences({ listed: false }),
    decoderWorkers({ files: false, plugins: () => [] }),
  ],
  define: { 'process.env.NODE_ENV': '"production"' },
  build: {
    outDir: outputFolder('dist'),
    emptyOutDir: false,
    target: 'es2022',
    chunkSizeWarningLimit: 2048,
    lib: {
      entry: {
        'phong-viewer.classic': fileURLToPath(
          new URL('../../src/viewer/classic.ts', import.meta.url),
        ),
      },
      formats: ['iife'],
      // Required, but unused: the entry exports nothing, so there is no global.
      name: 'phongViewer',
      fileName: (_format, name) => `${name}.js`,
    },
    rolldownOptions: {
      // A constant's value is shorter than its name, and repeated values compress well.
      optimization: { inlineConst: { mode: 'all' } },
      output: {
        codeSplitting: false,
        minify: true,
        // A script that is no module is read in the page's encoding, which need not be UTF-8.
        charset: 'ascii',
      },
    },
  },
});
