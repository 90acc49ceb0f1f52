// The package's ES modules: dist/index.js, core.js and reference.js, with three, Lit and lil-gui left as imports for the
// user's bundler. `npm run build` runs it first; the standalone file has a config of its own.

import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { licences } from './.ci/licences/plugin.js';
import { dracoDecoder, dracoDecoderSpecifier } from './.ci/draco-decoder.js';
import { outputFolder } from './.ci/output-folder.mjs';
import { strippedGlsl } from './.ci/strip-glsl.js';

const source = (path: string): string => fileURLToPath(new URL(`src/${path}`, import.meta.url));

// Text imported with a query is ours to inline, and no bundler would find the Draco decoder's export.
function staysImport(specifier: string): boolean {
  if (specifier.includes('?') || specifier === dracoDecoderSpecifier) return false;
  return /^(three|lit|@lit\/[^/]+|lil-gui)(\/|$)/.test(specifier);
}

/** Built each for itself: who imports one fetches one file, which compresses better than several that share. */
const entries: Readonly<Record<string, string>> = {
  index: source('index.ts'),
  core: source('core.ts'),
  reference: source('reference/index.ts'),
};

/** `--mode` names the entry; `index`, built first, empties dist/. */
export default defineConfig(({ mode }) => ({
  publicDir: false,
  plugins: [dracoDecoder(), strippedGlsl(), licences({ listed: false })],
  build: {
    outDir: outputFolder('dist'),
    emptyOutDir: mode === 'index',
    target: 'es2022',
    sourcemap: true,
    minify: true,
    lib: {
      entry: { [mode]: entries[mode] ?? missing(mode) },
      formats: ['es'],
      fileName: (_format, name) => `${name}.js`,
    },
    rolldownOptions: {
      external: staysImport,
      // Chunks may import from the entry itself; else what they share with it would be a further file of every page. For the
      // same reason all that an entry begins with is one chunk.
      preserveEntrySignatures: 'allow-extension',
      output: {
        chunkFileNames: 'shared/[name].js',
        minify: true,
        codeSplitting: { groups: [{ name: mode, tags: ['$initial'] }] },
      },
    },
  },
}));

function missing(mode: string): never {
  throw new Error(`--mode ${mode} names no entry: ${Object.keys(entries).join(', ')}`);
}
