// Where the package's own names lead inside this repository, so that demo pages and tests import what a user would.

import { fileURLToPath } from 'node:url';

const source = (path: string): string => fileURLToPath(new URL(`../src/${path}`, import.meta.url));

/** Longest names first is not needed: each pattern matches one whole specifier. */
export const packageAliases = [
  { find: /^phong-viewer$/, replacement: source('index.ts') },
  { find: /^phong-viewer\/core$/, replacement: source('core.ts') },
  { find: /^phong-viewer\/reference$/, replacement: source('reference/index.ts') },
];
