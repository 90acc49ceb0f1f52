// Resolves the package's own names inside this repository, so that demo pages and tests import them
// as a user would.

import { fileURLToPath } from 'node:url';

const source = (path: string): string => fileURLToPath(new URL(`../src/${path}`, import.meta.url));

/** The order does not matter: each pattern matches one whole specifier. */
export const packageAliases = [
  { find: /^phong-viewer$/, replacement: source('viewer/index.ts') },
  { find: /^phong-viewer\/core$/, replacement: source('phong/core.ts') },
  { find: /^phong-viewer\/reference$/, replacement: source('phong/reference/index.ts') },
  { find: /^phong-viewer\/react$/, replacement: source('extras/frameworks/react.ts') },
  { find: /^phong-viewer\/still$/, replacement: source('extras/still/index.ts') },
  { find: /^phong-viewer\/still\/markup$/, replacement: source('extras/png/index.ts') },
  { find: /^phong-viewer\/playwright$/, replacement: source('extras/playwright/index.ts') },
];
