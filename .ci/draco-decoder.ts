// How does three's copy of the Draco decoder become a module? The file is a CommonJS script in a package of ES modules, so
// bundlers find no export in it. This plugin adds one: the default export of `import('…/draco_decoder.js')` is the
// factory, in the dev server, in Node tests and in dist/.

import type { Plugin } from 'vite';
import { scriptAsModule } from './script-as-module.js';

/** The specifier of the plain JavaScript decoder: no WebAssembly, so it runs under a strict CSP. */
export const dracoDecoderSpecifier = 'three/examples/jsm/libs/draco/gltf/draco_decoder.js';

export function dracoDecoder(): Plugin {
  return {
    name: 'draco-decoder-as-module',
    enforce: 'pre',
    config: () => ({ optimizeDeps: { exclude: [dracoDecoderSpecifier] } }),
    transform(code, id) {
      if (!id.includes('/libs/draco/gltf/draco_decoder.js')) return null;
      return scriptAsModule(code);
    },
  };
}
