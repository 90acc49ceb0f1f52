// How does three's copy of the Draco decoder become a module? The file is a CommonJS script in a package of ES modules, so
// bundlers find no export in it. This plugin adds one: the default export of `import('…/draco_decoder.js')` is the
// factory, in the dev server, in Node tests and in dist/.

import type { Plugin } from 'vite';

/** The specifier of the plain JavaScript decoder: no WebAssembly, so it runs under a strict CSP. */
export const dracoDecoderSpecifier = 'three/examples/jsm/libs/draco/gltf/draco_decoder.js';

// What a CommonJS script expects around it. Its `require` is called only where `process` exists; defining it here keeps
// bundlers from resolving the calls.
const prologue = `
const module = { exports: {} };
const exports = module.exports;
const __dirname = '';
const require = (name) => globalThis.process.getBuiltinModule(name);
`;

export function dracoDecoder(): Plugin {
  return {
    name: 'draco-decoder-as-module',
    enforce: 'pre',
    config: () => ({ optimizeDeps: { exclude: [dracoDecoderSpecifier] } }),
    transform(code, id) {
      if (!id.includes('/libs/draco/gltf/draco_decoder.js')) return null;
      // No source map: the file is a compiler's output, and its map would be three times its size.
      return {
        code: `${prologue}${code}\nexport default module.exports;\n`,
        map: { mappings: '' },
      };
    },
  };
}
