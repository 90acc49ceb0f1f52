// Vite plugin: in a build an import of the table of texts gives its keys alone. The translations
// are files of their own.

import type { Plugin } from 'vite';

export const textKeys = (): Plugin => ({
  name: 'text-keys',
  apply: 'build',
  enforce: 'pre',
  transform(code, id) {
    if (!id.endsWith('/fields/texts.json')) return null;
    const keysOf = (part: object) => Object.fromEntries(Object.keys(part).map((key) => [key, 0]));
    const sections = Object.values(JSON.parse(code) as Record<string, object>);
    return {
      code: JSON.stringify({ '': keysOf(Object.assign({}, ...sections) as object) }),
      map: null,
    };
  },
});
