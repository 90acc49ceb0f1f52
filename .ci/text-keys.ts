// Vite plugin: in a build an import of the table of texts gives its keys alone. The translations are files of their own.

import type { Plugin } from 'vite';

export const textKeys = (): Plugin => ({
  name: 'text-keys',
  apply: 'build',
  enforce: 'pre',
  transform(code, id) {
    if (!id.endsWith('/fields/texts.json')) return null;
    const keys = Object.keys(JSON.parse(code) as object);
    return { code: JSON.stringify(Object.fromEntries(keys.map((key) => [key, 0]))), map: null };
  },
});
