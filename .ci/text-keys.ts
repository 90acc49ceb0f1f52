// Vite plugin: an import of the viewer's table of texts gives the keys of all tables, and no text.
// The translations are files of their own.

import type { Plugin } from 'vite';
import { TEXT_KEYS } from './texts.mjs';

export const textKeys = (): Plugin => ({
  name: 'text-keys',
  enforce: 'pre',
  transform(_code, id) {
    if (!id.endsWith('/fields/texts.json')) return null;
    return {
      code: JSON.stringify({ '': Object.fromEntries(TEXT_KEYS.map((key) => [key, 0])) }),
      map: null,
    };
  },
});
