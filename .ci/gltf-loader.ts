// Leaves the extensions that three's GLTFLoader registers by itself out of it: the document that it
// gets (src/extras/models/gltf/document.ts) names none of them. They are a quarter of its code, and
// bring lights, instances and physical materials with them.

import type { Plugin } from 'vite';

const REGISTERED = /this\.register\( function \( parser \) \{\s*return new \w+\([^)]*\);\s*\} \);/g;

export const gltfLoader = (): Plugin => ({
  name: 'gltf-loader',
  enforce: 'pre',
  transform(code, id) {
    if (!id.endsWith('/three/examples/jsm/loaders/GLTFLoader.js')) return null;
    const short = code.replace(REGISTERED, '');
    if (short.includes('this.register(')) {
      this.error('This three.js release registers extensions in another way.');
    }
    return short;
  },
});
