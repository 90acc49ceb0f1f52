// Makes modules of three's copies of the Draco decoder. They are CommonJS scripts in a package of
// ES modules, so bundlers find no export in them. This plugin adds one: the default export is the
// factory, in the dev server, in Node tests, in workers and in dist/.

import type { Plugin } from 'vite';
import { scriptAsModule } from './script-as-module.js';

/** The specifier of the plain JavaScript decoder: no WebAssembly, so it runs under a strict CSP. */
export const dracoDecoderSpecifier = 'three/examples/jsm/libs/draco/gltf/draco_decoder.js';

/** The script around the decoder in WebAssembly, for workers. */
const wrapperSpecifier = 'three/examples/jsm/libs/draco/gltf/draco_wasm_wrapper.js';

export function dracoDecoder(): Plugin {
  return {
    name: 'draco-decoder-as-module',
    enforce: 'pre',
    config: () => ({ optimizeDeps: { exclude: [dracoDecoderSpecifier, wrapperSpecifier] } }),
    transform(code, id) {
      if (!/\/libs\/draco\/gltf\/draco_(decoder|wasm_wrapper)\.js/.test(id)) return null;
      return scriptAsModule(code);
    },
  };
}
