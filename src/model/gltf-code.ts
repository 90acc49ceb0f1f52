// The code that reads glTF. It is fetched beside a file whose name says glTF, not after it: most models are, and on a
// slow line each request that waits for another is a delay that the reader sees.
import { FORMAT_NAMES } from './format-names.js';
import { lazyCode } from './lazy-code.js';

export const gltfCode = /* @__PURE__ */ lazyCode(() => import('./gltf/read-gltf.js'), 'glTF models');

/** Whether a path's extension says glTF. The content decides what is read. */
export const isNamedGltf = (path: string): boolean =>
  FORMAT_NAMES.gltf.extensions.some((extension) => path.toLowerCase().endsWith(`.${extension}`));
