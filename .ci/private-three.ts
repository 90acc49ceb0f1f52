// The copy of three.js inside the standalone file. It is private: three leaves its version on `window` and warns when it finds
// one there, and a page that also uses three.js itself would get that warning for a copy it never sees. And it is lean: what
// no ShaderMaterial on a canvas can reach is left out, or replaced by the modules of lean-three/, one for one by file name. It
// is taken from three's sources, module by module, so that what only the loaders use goes with them.

import { existsSync } from 'node:fs';
import { basename } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';
import { withoutUnsetParameters } from './lean-programs.js';

const announcement =
  /if \( typeof window !== 'undefined' \) \{\s*if \( window\.__THREE__ \) \{[^}]*\} else \{[^}]*\}\s*\}/;

/** Modules that lean-three/ may replace. */
const replaceable = /\/three\/src\/(?:extras|math|renderers\/(?:webgl|webxr|shaders))\/[^/]+\.js$/;

/**
 * Functions and methods that are left out: JSON, for which no loader is here; tangents, which only three's own shaders read;
 * what only the renderer's owner would call; drawing into anything but the canvas, reading back from it, passes over it; cube
 * maps; colours as text or by hue, for the colours here are the renderer's and the loaders' own, which are numbers.
 */
const leftOut: Readonly<Record<string, readonly string[]>> = {
  'Box3.js': ['fromJSON', 'toJSON'],
  'BoxGeometry.js': ['fromJSON'],
  'BufferAttribute.js': ['toJSON'],
  'BufferGeometry.js': ['computeTangents', 'toJSON'],
  'Color.js': [
    ...['NAMES', 'getHSL', 'getHexString', 'getStyle', 'lerpHSL', 'offsetHSL', 'setColorName', 'setHSL'],
    ...['setStyle', 'toJSON'],
  ],
  'DepthTexture.js': ['toJSON'],
  'ImageUtils.js': ['getDataURL'],
  'Material.js': ['fromJSON', 'toJSON'],
  'Object3D.js': ['toJSON'],
  'PerspectiveCamera.js': ['toJSON'],
  'Plane.js': ['fromJSON', 'toJSON'],
  'PlaneGeometry.js': ['fromJSON'],
  'Quaternion.js': ['toJSON'],
  'Scene.js': ['toJSON'],
  'ShaderMaterial.js': ['fromJSON', 'toJSON'],
  'Sphere.js': ['fromJSON', 'toJSON'],
  'SphereGeometry.js': ['fromJSON'],
  'Texture.js': ['toJSON'],
  'TextureSource.js': ['serializeImage', 'toJSON'],
  'Vector4.js': ['setAxisAngleFromQuaternion', 'setAxisAngleFromRotationMatrix'],
  'WebGLRenderer.js': [
    'compileAsync',
    'forceContextLoss',
    'forceContextRestore',
    'getActiveCubeFace',
    'getActiveMipmapLevel',
    'initTexture',
    'resetState',
    'setDrawingBufferSize',
    'setEffects',
    'setNodesHandler',
    'setRenderTargetTextures',
    'setRenderTargetFramebuffer',
    'setRenderTarget',
    'initRenderTarget',
    'getReadableState',
    'readRenderTargetPixels',
    'readRenderTargetPixelsAsync',
    'copyFramebufferToTexture',
    'copyTextureToTexture',
    'renderTransmissionPass',
  ],
  'WebGLTextures.js': [
    'onRenderTargetDispose',
    'destroyRenderTarget',
    'deallocateRenderTarget',
    'setupFrameBufferTexture',
    'setupRenderBufferStorage',
    'setupDepthTexture',
    'setupDepthRenderbuffer',
    'rebindTextures',
    'setupRenderTarget',
    'updateRenderTargetMipmap',
    'updateMultisampleRenderTarget',
    'getRenderTargetSamples',
    'uploadCubeTexture',
  ],
};

/** Text, which must be there, and what stands in its place. */
const replaced: Readonly<Record<string, readonly (readonly [text: RegExp | string, instead: string])[]>> = {
  'Three.Core.js': [[announcement, '']],
  // No mesh here is made without a material; the loader that needs this one brings it along.
  'Mesh.js': [
    [/import { MeshBasicMaterial } .*/, ''],
    ['material = new MeshBasicMaterial()', 'material'],
  ],
  // Never asked for: src/scene/gpu/link-check.ts says why.
  'WebGLProgram.js': [['renderer.debug.checkShaderErrors', 'false']],
};

export function privateThree(): Plugin {
  const missing = new Set(Object.keys(replaced));
  return {
    name: 'private-three',
    enforce: 'pre',
    config: () => ({ resolve: { alias: [{ find: /^three$/, replacement: 'three/src/Three.js' }] } }),
    async resolveId(specifier, importer, options) {
      if (importer === undefined || !importer.includes('/three/')) return null;
      const resolved = await this.resolve(specifier, importer, { ...options, skipSelf: true });
      return resolved !== null && replaceable.test(resolved.id) ? leanPath(resolved.id) : resolved;
    },
    transform(code, id) {
      if (!id.includes('/three/src/')) return null;
      const file = basename(id);
      let lean = code;
      for (const [text, instead] of replaced[file] ?? []) {
        const before = lean;
        lean = before.replace(text, instead);
        if (lean === before) throw new Error(`This three.js release has no ${String(text)} in ${id}`);
      }
      missing.delete(file);
      if (/^WebGLPrograms?\.js$/.test(file)) lean = withoutUnsetParameters(lean);
      const names = leftOut[file];
      if (names !== undefined) lean = without(lean, names, this.parse(lean));
      return { code: lean, map: null };
    },
    buildEnd(error) {
      if (error === undefined && missing.size > 0)
        this.error('three.js has not come from its sources: nothing of it is private or lean.');
    },
  };
}

function leanPath(path: string): string {
  const lean = fileURLToPath(new URL(`lean-three/${basename(path)}`, import.meta.url));
  return existsSync(lean) ? lean : path;
}

/** `code` without the functions of these names, declared, methods or assigned to `this` or to a class; throws where one is not there. */
function without(code: string, names: readonly string[], program: object): string {
  const missing = new Set(names);
  const gaps: [start: number, end: number][] = [];
  const visit = (node: unknown): void => {
    if (Array.isArray(node)) node.forEach(visit);
    if (!isNode(node)) return;
    const name = functionName(node);
    if (name !== undefined && names.includes(name)) {
      missing.delete(name);
      gaps.push([node.start, node.end]);
    } else {
      for (const child of Object.values(node)) if (typeof child === 'object') visit(child);
    }
  };
  visit(program);
  if (missing.size > 0) throw new Error(`This three.js release has no ${[...missing].join(', ')}`);
  return gaps.reduceRight((text, [start, end]) => text.slice(0, start) + text.slice(end), code);
}

interface Node {
  readonly type: string;
  readonly start: number;
  readonly end: number;
  readonly id?: { readonly name?: string };
  readonly key?: { readonly name?: string };
  readonly expression?: {
    readonly left?: { readonly object?: Node; readonly property?: { readonly name?: string } };
  };
}

const isNode = (value: unknown): value is Node =>
  typeof value === 'object' && value !== null && typeof (value as Partial<Node>).type === 'string';

function functionName({ type, id, key, expression }: Node): string | undefined {
  if (type === 'FunctionDeclaration') return id?.name;
  if (type === 'MethodDefinition') return key?.name;
  if (type !== 'ExpressionStatement') return undefined;
  const { object, property } = expression?.left ?? {};
  return object?.type === 'ThisExpression' || object?.type === 'Identifier' ? property?.name : undefined;
}
