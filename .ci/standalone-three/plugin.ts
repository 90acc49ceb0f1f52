// Which three.js is inside the standalone file? Its own sources, unchanged, without a few whole
// modules that nothing here can reach: those in absent.js stand in for them. The sources are taken
// one by one instead of three's built file: three declares them free of side effects, so a bundler
// skips the index that stamps `window.__THREE__` and warns about a second copy.

import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';

/**
 * The modules that are replaced, as paths below three/src. Each saves 1 to 20 kB of the file;
 * absent.js says why it can go. A replacement below 1 kB is not worth its line here.
 */
const replaced: ReadonlySet<string> = new Set([
  'math/FrustumArray.js',
  'renderers/shaders/DFGLUTData.js',
  'renderers/shaders/ShaderChunk.js',
  'renderers/shaders/ShaderLib.js',
  'renderers/webgl/WebGLClipping.js',
  'renderers/webgl/WebGLEnvironments.js',
  'renderers/webgl/WebGLLights.js',
  'renderers/webgl/WebGLMaterials.js',
  'renderers/webgl/WebGLMorphtargets.js',
  'renderers/webgl/WebGLOutput.js',
  'renderers/webgl/WebGLShadowMap.js',
  'renderers/webgl/WebGLUniformsGroups.js',
  'renderers/webxr/WebXRManager.js',
]);

const absent = fileURLToPath(new URL('absent.js', import.meta.url));
const threeForGltf = fileURLToPath(new URL('three-for-gltf.js', import.meta.url));
const sources = '/node_modules/three/src/';
const gltfLoader = '/node_modules/three/examples/jsm/loaders/GLTFLoader.js';

export function standaloneThree(): Plugin {
  const missing = new Set(replaced);
  return {
    name: 'standalone-three',
    enforce: 'pre',
    config: () => ({
      resolve: { alias: [{ find: /^three$/, replacement: 'three/src/Three.js' }] },
    }),
    async resolveId(specifier, importer, options) {
      if (importer?.endsWith(gltfLoader) && specifier === 'three/src/Three.js') {
        const used = readFileSync(importer, 'utf8').match(/(?<=\bMathUtils\.)\w+/g) ?? [];
        if (used.join() !== 'radToDeg') {
          this.error(`three-for-gltf.js lacks MathUtils.${used.join()}.`);
        }
        return threeForGltf;
      }
      if (importer === undefined || !importer.includes(sources)) return null;
      const resolved = await this.resolve(specifier, importer, { ...options, skipSelf: true });
      const path = resolved?.id.split(sources)[1];
      if (path === undefined || !replaced.has(path)) return resolved;
      missing.delete(path);
      return absent;
    },
    buildEnd(error) {
      if (error === undefined && missing.size > 0) {
        this.error(`This three.js release has no ${[...missing].join(', ')}.`);
      }
    },
  };
}
