// How three's copy of the Draco decoder becomes a module. The file is a CommonJS script inside a package marked as
// ES modules, so no bundler finds an export in it. Written as `import('…/draco_decoder.js')`, its default export is
// the factory, in the dev server, in Node tests and in dist/ alike.

import type { Plugin } from 'vite';

/** The specifier of the plain JavaScript decoder: no WebAssembly, so it runs under a strict CSP. */
export const dracoDecoderSpecifier = 'three/examples/jsm/libs/draco/gltf/draco_decoder.js';

// The script's Node branch runs only where `process` exists; named here, its `require` is no bundler's business.
const prologue = `
const __dirname = '';
const require = (name) => globalThis.process.getBuiltinModule(name);
`;

const commonJsTail = "if (typeof exports === 'object' && typeof module === 'object')";

export function dracoDecoder(): Plugin {
  return {
    name: 'draco-decoder-as-module',
    enforce: 'pre',
    config: () => ({ optimizeDeps: { exclude: [dracoDecoderSpecifier] } }),
    transform(code, id) {
      if (!id.includes('/libs/draco/gltf/draco_decoder.js')) return null;
      const end = code.lastIndexOf(commonJsTail);
      if (end < 0) throw new Error(`The Draco decoder of this three.js release has another ending: ${id}`);
      // No source map: the file is a compiler's output, and its map would be three times its size.
      return {
        code: `${prologue}${code.slice(0, end)}\nexport default DracoDecoderModule;\n`,
        map: { mappings: '' },
      };
    },
  };
}
