// The package's ES modules: dist/index.js, core.js, reference.js and what they share, with three, Lit and lil-gui left
// as imports for the user's bundler. `npm run build` runs it first; the standalone file has a config of its own.

import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { dracoDecoder, dracoDecoderSpecifier } from './.ci/draco-decoder.js';
import { outputFolder } from './.ci/output-folder.mjs';
import { strippedGlsl } from './.ci/strip-glsl.js';

const source = (path: string): string => fileURLToPath(new URL(`src/${path}`, import.meta.url));

// Text imported with a query is ours to inline, and no bundler would find the Draco decoder's export.
function staysImport(specifier: string): boolean {
  if (specifier.includes('?') || specifier === dracoDecoderSpecifier) return false;
  return /^(three|lit|@lit\/[^/]+|lil-gui)(\/|$)/.test(specifier);
}

export default defineConfig({
  publicDir: false,
  plugins: [dracoDecoder(), strippedGlsl()],
  build: {
    outDir: outputFolder('dist'),
    emptyOutDir: true,
    target: 'es2022',
    sourcemap: true,
    minify: true,
    lib: {
      entry: {
        index: source('index.ts'),
        core: source('core.ts'),
        reference: source('reference/index.ts'),
      },
      formats: ['es'],
      fileName: (_format, name) => `${name}.js`,
    },
    rolldownOptions: {
      external: staysImport,
      output: { chunkFileNames: 'shared/[name].js', minify: true },
    },
  },
});
