// Which three.js is inside the standalone file? Its own sources, without what nothing here can
// reach: a few modules are replaced as a whole by those in absent.js, and a few functions lose
// their bodies. The sources are taken one by one instead of three's built file: three declares them
// free of side effects, so a bundler skips the index that stamps `window.__THREE__` and warns about
// a second copy.

import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { parseSync, Visitor, type ESTree, type Plugin } from 'vite';

/**
 * The modules that are replaced, as paths below three/src. Each saves 1 to 20 kB of the file;
 * absent.js says why it can go. A replacement below 1 kB is not worth its line here.
 */
const replaced: ReadonlySet<string> = new Set([
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

/**
 * Functions that lose their bodies, as file below three/src and names: nothing here calls them, and
 * together they are 7 kB of the compressed file. A page that calls one gets an error with its name.
 * A name that a release of three.js no longer has is skipped.
 */
const emptied: Readonly<Record<string, readonly string[]>> = {
  'core/BufferGeometry.js': ['computeTangents', 'toJSON'],
  'core/Object3D.js': ['toJSON'],
  'math/Vector4.js': ['setAxisAngleFromRotationMatrix'],
  'materials/Material.js': ['toJSON', 'fromJSON'],
  'materials/ShaderMaterial.js': ['toJSON', 'fromJSON'],
  'textures/Texture.js': ['toJSON'],
  'renderers/WebGLRenderer.js': [
    'compileAsync',
    'copyFramebufferToTexture',
    'copyTextureToTexture',
    'readRenderTargetPixels',
    'readRenderTargetPixelsAsync',
    'renderTransmissionPass',
    'setRenderTargetFramebuffer',
    'setRenderTargetTextures',
  ],
  'renderers/webgl/WebGLTextures.js': ['uploadCubeTexture', 'setupDepthTexture'],
};

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
    transform(code, id) {
      const names = emptied[id.split(sources)[1] ?? ''];
      return names === undefined ? null : { code: withoutBodies(code, names), map: null };
    },
    buildEnd(error) {
      if (error === undefined && missing.size > 0) {
        this.error(`This three.js release has no ${[...missing].join(', ')}.`);
      }
    },
  };
}

/** The module's text, in which functions with these names throw an error with their name. */
function withoutBodies(code: string, names: readonly string[]): string {
  const bodies: { name: string; start: number; end: number }[] = [];
  const collect = (key: ESTree.Node | null, body: ESTree.FunctionBody | null): void => {
    if (key?.type !== 'Identifier' || body === null || !names.includes(key.name)) return;
    bodies.push({ name: key.name, start: body.start, end: body.end });
  };
  new Visitor({
    MethodDefinition: ({ key, value }) => collect(key, value.body),
    FunctionDeclaration: ({ id, body }) => collect(id, body),
    AssignmentExpression: ({ left, right }) => {
      if (left.type === 'MemberExpression' && right.type === 'FunctionExpression') {
        collect(left.property, right.body);
      }
    },
  }).visit(parseSync('three.js', code).program);
  return bodies.reduceRight(
    (text, { name, start, end }) =>
      `${text.slice(0, start)}{ refuse('${name}'); }${text.slice(end)}`,
    `${code}\nimport { refuse } from ${JSON.stringify(absent)};`,
  );
}
