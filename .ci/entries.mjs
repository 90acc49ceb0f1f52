// @ts-check
// The entries of the package: what is built, from which file, and under which name users import it.
// Builds, aliases and the exports in package.json follow from this table. An entry of an extra goes
// with the extra's folder.

import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

/**
 * @typedef {object} Entry
 * @property {string} name    dist/NAME.js
 * @property {string} source  below src/
 * @property {string} [beside]  another file that it cannot do without
 * @property {string} [as]    what users import, after `phong-viewer`; left out for files that only
 *   others of the package name
 * @property {true} [node]    Node runs it as it is
 * @property {true} [client]  dist/NAME-client.js is what React's servers import
 * @property {string} [config]  .ci/vite/CONFIG.config.ts builds it; left out for `lib`
 */

/** @type {readonly Entry[]} */
const all = [
  // Built first: it empties dist/.
  { name: 'index', source: 'viewer/index.ts', as: '.' },
  { name: 'trusted-types', source: 'viewer/element/page/trusted-types.ts' },
  { name: 'core', source: 'phong/core.ts', as: './core' },
  { name: 'reference', source: 'phong/reference/index.ts', as: './reference' },
  { name: 'react', source: 'extras/frameworks/react.ts', as: './react', client: true },
  {
    name: 'react-standalone',
    source: 'extras/frameworks/react.ts',
    as: './react/standalone',
    client: true,
  },
  {
    name: 'react-lazy',
    source: 'extras/frameworks/react.ts',
    beside: 'extras/lazy/index.ts',
    as: './react/lazy',
    client: true,
  },
  { name: 'lazy', source: 'extras/lazy/index.ts', as: './lazy' },
  { name: 'phong-viewer.lazy', source: 'extras/lazy/index.ts' },
  { name: 'playwright', source: 'extras/playwright/index.ts', as: './playwright', node: true },
  { name: 'still', source: 'extras/still/index.ts', as: './still', node: true },
  { name: 'still-threads', source: 'extras/still/threads.ts', node: true },
  { name: 'still-worker', source: 'extras/still/worker.ts', node: true },
  { name: 'still-markup', source: 'extras/png/index.ts', as: './still/markup' },
  { name: 'cli', source: 'extras/still/command/cli.ts', node: true },
  { name: 'check', source: 'extras/exercise/command/check-files.ts', node: true },
  {
    name: 'phong-viewer.standalone',
    source: 'viewer/index.ts',
    as: './standalone',
    config: 'standalone',
  },
  { name: 'phong-viewer.classic', source: 'viewer/classic.ts', as: './classic', config: 'classic' },
];

/** @param {string} source */
export const sourcePath = (source) =>
  fileURLToPath(new URL(join('../src', source), import.meta.url));

export const entries = all.filter(({ source, beside = source }) =>
  [source, beside].every((file) => existsSync(sourcePath(file))),
);

/** What package.json says of the entries, and of the other files that users name. */
export function packageExports() {
  /** @type {Record<string, string | Record<string, string>>} */
  const exports = {};
  /** @type {Record<string, string[]>} */
  const types = {};
  for (const { name, source, as, client } of entries) {
    if (as === undefined) continue;
    const declarations = `./dist/types/${source.replace('.ts', '.d.ts')}`;
    exports[as] = {
      types: declarations,
      ...(client && { 'react-server': `./dist/${name}-client.js` }),
      default: `./dist/${name}.js`,
    };
    if (as !== '.') {
      types[as.slice('./'.length)] = [declarations];
    }
  }
  return {
    exports: {
      ...exports,
      './texts/*': { types: './dist/texts/*.d.ts', default: './dist/texts/*.js' },
      ...Object.fromEntries(DATA.map((name) => [`./${name}`, `./dist/${name}`])),
      './package.json': './package.json',
    },
    typesVersions: {
      '*': {
        ...types,
        'texts/*': ['./dist/texts/*.d.ts'],
        '*.json': ['./dist/*.json', './*.json'],
      },
    },
  };
}

/** Written by .ci/manifest.mjs and .ci/vectors.mjs. */
const DATA = [
  'custom-elements.json',
  'web-types.json',
  'vscode.html-custom-data.json',
  'vectors.json',
];
