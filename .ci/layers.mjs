// @ts-check
// Who may import whom in src/: the one table, which .ci/house-rules.mjs enforces. Arrows go down
// only, and a few doors are lazy: a lazily reached layer may be named in `import()` or `import
// type`, never in a plain import.

import { readdirSync } from 'node:fs';
import { posix } from 'node:path';

/**
 * @typedef {object} Layer
 * @property {string[]} layers    folders or entries below that may be imported
 * @property {string[]} lazy      the same, by `import()` or for types only
 * @property {string[]} packages  npm packages, with all their subpaths
 * @property {string[]} types     npm packages for types only
 */

const phong = [
  'phong/lazy-code.ts',
  'phong/model',
  'phong/geometry',
  'phong/mistakes',
  'phong/material',
  'phong/camera',
  'phong/light',
  'phong/fields',
  'phong/math',
];
const viewer = ['viewer/element', 'viewer/scene', 'viewer/model', ...phong];
/** What each extra may import. Packages and edges between extras need a line of their own below. */
const extra = ['viewer/extra.ts', ...phong];

/** Their folders. */
export const EXTRAS = readdirSync(new URL('../src/extras', import.meta.url), {
  withFileTypes: true,
})
  .filter((entry) => entry.isDirectory())
  .map(({ name }) => name);

/** @type {Record<string, Partial<Layer>>} */
export const layers = {
  'phong/lazy-code.ts': {},
  'phong/math': {},
  'phong/fields': { layers: ['phong/math'] },
  'phong/light': { layers: ['phong/fields', 'phong/math'] },
  'phong/reference': { layers: ['phong/light', 'phong/fields', 'phong/math'] },
  'phong/mistakes': { layers: ['phong/light', 'phong/math'] },
  'phong/camera': { layers: ['phong/math'] },
  'phong/material': {
    layers: ['phong/light', 'phong/fields', 'phong/math', 'shaders'],
    packages: ['three'],
  },
  'phong/geometry': {
    layers: ['phong/material', 'phong/camera', 'phong/math'],
    packages: ['three'],
  },
  // What a mesh shows: shapes, contents of files, and how much may be held.
  'phong/model': {
    layers: [
      'phong/lazy-code.ts',
      'phong/geometry',
      'phong/material',
      'phong/light',
      'phong/fields',
      'phong/math',
    ],
    packages: ['three'],
  },
  phong: { layers: phong, packages: ['three'] },
  'viewer/model': { layers: phong, packages: ['three'] },
  'viewer/scene': {
    layers: ['viewer/model', ...phong],
    packages: ['three'],
  },
  'viewer/element': {
    layers: ['viewer/scene', 'viewer/model', ...phong],
    lazy: ['phong/reference'],
    packages: ['lit'],
    types: ['three', 'react', 'solid-js', 'svelte', 'vue'],
  },
  viewer: {
    layers: ['viewer/extras.ts', ...viewer],
    types: ['three'],
  },
  // The table of extras: the only file of the viewer that knows them.
  'viewer/extras.ts': {
    layers: ['viewer/element', 'viewer/scene', 'viewer/model', 'phong/lazy-code.ts'],
    lazy: EXTRAS.map((name) => `extras/${name}`),
  },
  // All that extras may import of the viewer.
  'viewer/extra.ts': { layers: viewer },
  ...Object.fromEntries(EXTRAS.map((name) => [`extras/${name}`, { layers: extra }])),
  'extras/models': { layers: extra, lazy: ['extras/png'], packages: ['three'] },
  'extras/samples': { layers: extra, lazy: ['extras/png'], packages: ['three'] },
  'extras/explain': { layers: ['phong/reference', ...extra], packages: ['three'] },
  'extras/compare': { layers: extra, packages: ['lit'] },
  'extras/overlay': {
    layers: ['extras/explain', ...extra],
    packages: ['three', 'lit'],
  },
  // The equation in steps, and the points of a picture.
  'extras/exercise': {
    layers: ['extras/explain', 'phong/reference', ...extra],
    packages: [
      'three',
      'lit',
      ...['fs', 'path', 'querystring', 'timers/promises', 'util'].map((name) => `node:${name}`),
    ],
    types: ['@playwright/test'],
  },
  'extras/panel': { layers: extra, packages: ['lil-gui'] },
  'extras/probe': {
    layers: ['extras/overlay', 'phong/reference', ...extra],
    packages: ['three', 'lit'],
  },
  'extras/frameworks': {
    layers: ['viewer', 'viewer/element', 'phong/fields'],
    lazy: ['viewer/scene', 'phong/light'],
    packages: ['react'],
    types: ['react', 'solid-js', 'svelte', 'vue'],
  },
  // Runs in Node, and in pages without threads.
  'extras/still': {
    layers: ['extras/png', 'phong/reference', 'extras/models', ...extra],
    packages: [
      'three',
      'parse5',
      'fflate',
      'pngjs',
      'jpeg-js',
      'node:worker_threads',
      'node:crypto',
      'node:fs',
      'node:os',
      'node:path',
      'node:url',
      'node:util',
    ],
  },
  // The whole script of a page until the elements are fetched.
  'extras/lazy': { lazy: ['viewer'] },
  // Runs in Node and sends functions into pages: the elements are types to it.
  'extras/playwright': {
    layers: ['phong/reference', 'phong/light', 'phong/math'],
    lazy: ['viewer'],
    packages: ['@playwright/test'],
  },
};

/**
 * The layer of a file: the file itself where the table has a line for it, else its first two
 * folders under src/, the first alone for an entry, or `shaders`; undefined outside of both.
 * @param {string} file path with forward slashes
 */
function layerOf(file) {
  const own = `${/(?:^|\/)src\/(.+)\.[jt]s$/.exec(file)?.[1] ?? ''}.ts`;
  if (Object.hasOwn(layers, own)) return own;
  const match = /(?:^|\/)(?:src\/([^/.]+(?:\/[^/.]+(?=\/))?)|(shaders)\/)/.exec(file);
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
    if (allowed.some((name) => specifier === name || specifier.startsWith(`${name}/`))) {
      return undefined;
    }
    return `src/${from} must not know ${specifier}.`;
  }
  const target = layerOf(posix.join(posix.dirname(file), specifier));
  if (target === undefined) return `src/${from} must not reach outside src/: ${specifier}.`;
  const allowed = [from, ...(layer.layers ?? []), ...(isLazy ? (layer.lazy ?? []) : [])];
  if (allowed.includes(target)) return undefined;
  const reason = layer.lazy?.includes(target) ? 'only by import() or import type' : 'not at all';
  return `src/${from} may import ${target} ${reason}.`;
}
