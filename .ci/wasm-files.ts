// Puts the WebAssembly of three's decoders into dist/ as files beside the decoders' code, at
// addresses that users' bundlers know.

import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';
import { DECODER_FOLDER, fromChunk } from './decoder-workers.js';

const SPECIFIER = /^three\/.*\/([\w.]+\.wasm)\?url$/;
/**
 * Stands for a file's address until its chunk is known. No bundler takes the text for an address.
 */
const PLACEHOLDER = /wasm-file:([\w.]+):/g;

/**
 * `import address from '….wasm?url'` as Vite's own servers understand it, in a library: Vite would
 * put the bytes into the script.
 * @param file false: there is no file, and the address is empty. For scripts that are no modules.
 */
export function wasmFiles({ file = true } = {}): Plugin {
  /** Paths by file name. */
  const sources = new Map<string, string>();
  return {
    name: 'wasm-files',
    enforce: 'pre',
    resolveId: (specifier) => (SPECIFIER.test(specifier) ? `\0${specifier}` : null),
    load(id) {
      const [specifier = '', name = ''] = SPECIFIER.exec(id.slice(1)) ?? [];
      if (name === '') return null;
      sources.set(name, fileURLToPath(import.meta.resolve(specifier.replace('?url', ''))));
      // The sum hides it from Vite, and is one text after minification.
      return `export default ${file ? `new URL('' + 'wasm-file:${name}:', import.meta.url).href` : "''"};`;
    },
    generateBundle(_options, bundle) {
      for (const chunk of Object.values(bundle)) {
        if (chunk.type !== 'chunk') continue;
        chunk.code = chunk.code.replace(PLACEHOLDER, (_, name: string) => {
          const fileName = `${DECODER_FOLDER}/${name}`;
          this.emitFile({
            type: 'asset',
            fileName,
            source: readFileSync(sources.get(name) ?? ''),
          });
          return fromChunk(chunk.fileName, fileName);
        });
      }
    },
  };
}
