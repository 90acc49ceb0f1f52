// Builds the package's ES modules, one entry at a time (.ci/entries.mjs): each is a single file, which
// compresses better than several files with shared parts. Packages stay imports, for the user's
// bundler or Node. `npm run build` runs this first; the standalone and the classic file have configs
// of their own.

import { pathToFileURL } from 'node:url';
import { defineConfig, type Plugin } from 'vite';
import { licences } from '../licences/plugin.js';
import { basisTranscoder } from '../basis-transcoder.js';
import { decoderWorkers } from '../decoder-workers.js';
import { dracoDecoder, dracoDecoderSpecifier } from '../draco-decoder.js';
import { entries, sourcePath } from '../entries.mjs';
import { gltfLoader } from '../gltf-loader.js';
import { gltfThree, isOfGltfThree } from '../gltf-three.js';
import { inPage } from '../in-page.js';
import { modelChunks } from '../model-chunks.js';
import { nativeMath } from '../native-math.js';
import { outputFolder } from '../output-folder.mjs';
import { strippedGlsl } from '../strip-glsl.js';
import { textKeys } from '../text-keys.js';
import { wasmFiles } from '../wasm-files.js';

// Text imported with a query is inlined, and so are the Draco decoder and the Basis transcoder: a
// user's bundler would find no export.
function staysImport(specifier: string): boolean {
  if (
    specifier.includes('?') ||
    specifier === dracoDecoderSpecifier ||
    /libs\/basis/.test(specifier)
  ) {
    return false;
  }
  return /^(node:.*|three|lit|lil-gui|react|@playwright\/test|parse5|fflate|pngjs|jpeg-js)(\/|$)/.test(
    specifier,
  );
}

/**
 * The file beside an entry's that it imports in place of the elements, so that a page has one copy of
 * them.
 */
const elementsOf: Readonly<Record<string, string>> = {
  react: './index.js',
  'react-standalone': './phong-viewer.standalone.js',
  lazy: './index.js',
  'phong-viewer.lazy': './phong-viewer.standalone.js',
};

const elementsBeside = (id: string): Plugin => ({
  name: 'elements-beside',
  enforce: 'pre',
  resolveId: (specifier) =>
    specifier.endsWith('/viewer/index.js') ? { id, external: 'relative' } : null,
});

/**
 * dist/react-lazy.js knows the names of the attributes, and dist/lazy.js fetches the elements. The
 * names are those of dist/index.js, which was built before.
 */
const attributesAlone: Plugin = {
  name: 'attributes-alone',
  enforce: 'pre',
  resolveId: (specifier) =>
    specifier.endsWith('/viewer/index.js')
      ? '\0attributes'
      : specifier === './lazy.js'
        ? { id: specifier, external: 'relative', moduleSideEffects: true }
        : null,
  async load(id) {
    if (id !== '\0attributes') return null;
    const built = pathToFileURL(`${outputFolder('dist')}/index.js`).href;
    const elements = (await import(built)) as Record<string, { observedAttributes?: string[] }>;
    const lists = Object.entries(elements)
      .filter(([name]) => name.startsWith('Phong'))
      .map(
        ([name, { observedAttributes = [] }]) =>
          `export const ${name} = { observedAttributes: '${observedAttributes.join(' ')}'.split(' ') };`,
      );
    return `import './lazy.js';\n${lists.join('\n')}`;
  },
};

/**
 * Beside each entry for React is the file that React's servers import, under the condition
 * `react-server`: they look for its first line, of which bundlers would warn in every other build.
 */
const clientFile: Plugin = {
  name: 'client-file',
  generateBundle(_options, bundle) {
    for (const file of Object.values(bundle)) {
      if (file.type !== 'chunk' || !file.isEntry) continue;
      const source = `'use client';\nexport { ${file.exports.join(', ')} } from './${file.fileName}';\n`;
      this.emitFile({
        type: 'asset',
        fileName: file.fileName.replace('.js', '-client.js'),
        source,
      });
    }
  },
};

/**
 * dist/index.js imports dist/trusted-types.js before Lit. As part of index.js it would run after
 * Lit, which stays an import, and too late to report that Lit was refused.
 */
const beforeLit: Plugin = {
  name: 'before-lit',
  enforce: 'pre',
  resolveId: (specifier, importer) =>
    importer !== undefined && specifier.endsWith('/trusted-types.js')
      ? { id: './trusted-types.js', external: 'relative', moduleSideEffects: true }
      : null,
};

const workerPlugins = (): Plugin[] => [
  dracoDecoder(),
  basisTranscoder(),
  licences({ listed: false }),
];

/** Stills refuse what needs WebAssembly, and nothing is dropped on them: its code is left out. */
const withoutDecoders: Plugin = {
  name: 'without-decoders',
  enforce: 'pre',
  resolveId: (specifier) =>
    /^\.\.?\/(draco|ktx2-worker|meshopt|png\/open-scene)\.js$/.test(specifier) ? '\0none' : null,
  load: (id) => (id === '\0none' ? 'export {};' : null),
};

/** dist/cli.js imports dist/still.js. That and its worker import dist/still-threads.js. */
const besideStill: Plugin = {
  name: 'beside-still',
  enforce: 'pre',
  resolveId(specifier) {
    if (specifier === '../index.js') return { id: './still.js', external: 'relative' };
    if (specifier === './threads.js') return { id: './still-threads.js', external: 'relative' };
    return null;
  },
};

const isForNode = (mode: string): boolean => entryOf(mode).node === true;

/** `--mode` names the entry. `index` is built first and empties dist/. */
export default defineConfig(({ mode }) => ({
  publicDir: false,
  plugins: [
    dracoDecoder(),
    basisTranscoder(),
    wasmFiles({ file: mode !== 'still' }),
    isForNode(mode) ? null : nativeMath(),
    strippedGlsl(),
    textKeys(),
    inPage(),
    gltfLoader(),
    isForNode(mode) ? null : gltfThree(),
    decoderWorkers({ plugins: workerPlugins, files: mode !== 'still' }),
    beforeLit,
    mode in elementsOf ? elementsBeside(elementsOf[mode]!) : null,
    mode === 'react-lazy' ? attributesAlone : null,
    entryOf(mode).client === true ? clientFile : null,
    mode === 'still' ? withoutDecoders : null,
    /^(cli|still|still-worker)$/.test(mode) ? besideStill : null,
    licences({ listed: false }),
  ],
  build: {
    outDir: outputFolder('dist'),
    emptyOutDir: mode === 'index',
    target: 'es2022',
    // A map would be five times its file, and point to sources that are not in the package.
    sourcemap: false,
    // Node's entries run as they are: their stack traces keep the names of functions.
    minify: !isForNode(mode),
    lib: {
      entry: { [mode]: sourcePath(entryOf(mode).source) },
      formats: ['es'],
      fileName: (_format, name) => `${name}.js`,
    },
    rolldownOptions: {
      external: (specifier) =>
        staysImport(specifier) && (isForNode(mode) || !isOfGltfThree(specifier)),
      // As in the standalone file: the more alike its chunks are, the smaller is the package.
      optimization: { inlineConst: { mode: 'all' } },
      // Lets chunks import from the entry. Otherwise the code that they share with it would be a
      // second file that every page has to fetch. For the same reason all static imports of an
      // entry are one chunk.
      preserveEntrySignatures: 'allow-extension',
      output: {
        // A second entry's chunks import that entry: they are not the first one's.
        chunkFileNames: mode === 'still' ? 'still/[name].js' : 'shared/[name].js',
        minify: isForNode(mode) ? { mangle: { keepNames: true } } : true,
        // As in the standalone file.
        charset: 'ascii',
        // The command is one file as it is.
        ...(mode !== 'cli' && {
          codeSplitting: { groups: [{ name: mode, tags: ['$initial'] }, ...modelChunks] },
        }),
      },
    },
  },
}));

function entryOf(mode: string): (typeof entries)[number] {
  const entry = entries.find(({ name }) => name === mode);
  if (entry !== undefined) return entry;
  throw new Error(`--mode ${mode} names no entry: ${entries.map(({ name }) => name).join(', ')}`);
}
