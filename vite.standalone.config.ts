// dist/phong-viewer.standalone.js for pages without a bundler: three and Lit inside; panel, loaders and decoders in
// dist/chunks, fetched on first use by addresses relative to the file itself. Runs after vite.lib.config.ts, which
// empties dist/.

import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { licences } from './.ci/licences/plugin.js';
import { dracoDecoder } from './.ci/draco-decoder.js';
import { outputFolder } from './.ci/output-folder.mjs';
import { standaloneThree } from './.ci/standalone-three/plugin.js';
import { strippedGlsl } from './.ci/strip-glsl.js';

export default defineConfig({
  base: './',
  publicDir: false,
  plugins: [dracoDecoder(), standaloneThree(), strippedGlsl(), licences()],
  define: { 'process.env.NODE_ENV': '"production"' },
  build: {
    outDir: outputFolder('dist'),
    emptyOutDir: false,
    target: 'es2022',
    chunkSizeWarningLimit: 1024,
    lib: {
      entry: { 'phong-viewer.standalone': fileURLToPath(new URL('src/index.ts', import.meta.url)) },
      formats: ['es'],
      fileName: (_format, name) => `${name}.js`,
    },
    rolldownOptions: {
      // Chunks may import from the entry itself; else what they share with it (most of three) would move out into
      // further files that every page has to fetch first. For the same reason all that it begins with is one chunk.
      preserveEntrySignatures: 'allow-extension',
      output: {
        chunkFileNames: 'chunks/[name]-[hash].js',
        minify: true,
        codeSplitting: { groups: [{ name: 'phong-viewer.standalone', tags: ['$initial'] }] },
      },
    },
  },
});
