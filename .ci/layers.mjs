// @ts-check
// Who may import whom in src/: the one table, which .ci/house-rules.mjs enforces. Arrows go down only, and two doors
// are lazy: a lazily reached layer may be named in `import()` or `import type`, never in a plain import.

import { posix } from 'node:path';

/**
 * @typedef {object} Layer
 * @property {string[]} layers    folders or entries below that may be imported
 * @property {string[]} lazy      the same, by `import()` or for types only
 * @property {string[]} packages  npm packages, with all their subpaths
 * @property {string[]} types     npm packages for types only
 */

/** @type {Record<string, Partial<Layer>>} */
export const layers = {
  math: {},
  fields: { layers: ['math'] },
  light: { layers: ['fields', 'math'] },
  reference: { layers: ['light', 'fields', 'math'] },
  camera: { layers: ['math'] },
  material: { layers: ['light', 'fields', 'math', 'shaders'], packages: ['three'] },
  model: { layers: ['material', 'light', 'fields', 'math'], packages: ['three'] },
  scene: { layers: ['model', 'material', 'camera', 'light', 'fields', 'math'], packages: ['three'] },
  element: {
    layers: ['core', 'scene', 'model', 'material', 'camera', 'light', 'fields', 'math'],
    lazy: ['overlay', 'reference'],
    packages: ['lit'],
    types: ['three', 'react', 'solid-js', 'svelte', 'vue'],
  },
  overlay: {
    layers: ['element', 'scene', 'model', 'material', 'camera', 'light', 'fields', 'math'],
    lazy: ['reference'],
    packages: ['three', 'lit'],
  },
  gui: {
    layers: ['element', 'scene', 'model', 'material', 'camera', 'light', 'fields', 'math'],
    packages: ['lil-gui'],
  },
  core: { layers: ['material', 'camera', 'light', 'fields', 'math'], packages: ['three'] },
  index: {
    layers: ['element', 'scene', 'model', 'material', 'camera', 'light', 'fields', 'math'],
    lazy: ['gui', 'reference'],
    types: ['three'],
  },
  classic: { layers: ['index'] },
  react: { layers: ['index', 'element'], packages: ['react'] },
  // Runs in Node and sends functions into pages: the elements are types to it.
  playwright: {
    layers: ['reference', 'light', 'math'],
    lazy: ['index'],
    packages: ['@playwright/test'],
  },
};

/**
 * The layer of a file: its first folder under src/, the entry's name, or `shaders`; undefined outside of both.
 * @param {string} file path with forward slashes
 */
function layerOf(file) {
  const match = /(?:^|\/)(?:src\/([^/.]+)|(shaders)\/)/.exec(file);
  return match?.[1] ?? match?.[2];
}

/**
 * What is wrong with this import; undefined where nothing is.
 * @param {string} file @param {string} specifier @param {boolean} isLazy
 * @returns {string | undefined}
 */
export function forbidden(file, specifier, isLazy) {
  const from = layerOf(file);
  if (from === undefined) return undefined;
  const layer = layers[from];
  if (layer === undefined) return `src/${from} is no layer: give it a line in .ci/layers.mjs.`;
  if (!specifier.startsWith('.')) {
    const allowed = [...(layer.packages ?? []), ...(isLazy ? (layer.types ?? []) : [])];
    if (allowed.some((name) => specifier === name || specifier.startsWith(`${name}/`))) return undefined;
    return `src/${from} must not know ${specifier}.`;
  }
  const target = layerOf(posix.join(posix.dirname(file), specifier));
  if (target === undefined) return `src/${from} must not reach outside src/: ${specifier}.`;
  const allowed = [from, ...(layer.layers ?? []), ...(isLazy ? (layer.lazy ?? []) : [])];
  if (allowed.includes(target)) return undefined;
  const reason = layer.lazy?.includes(target) ? 'only by import() or import type' : 'not at all';
  return `src/${from} may import ${target} ${reason}.`;
}
