// How the copy of three.js inside the standalone file stays private. three leaves its version on `window` and warns
// when it finds one there; a page that also uses three.js itself would get that warning for a copy it never sees.

import type { Plugin } from 'vite';

const announcement =
  /if \( typeof window !== 'undefined' \) \{\s*if \( window\.__THREE__ \) \{[^}]*\} else \{[^}]*\}\s*\}/;

export function privateThree(): Plugin {
  return {
    name: 'private-three',
    enforce: 'pre',
    transform(code, id) {
      if (!id.endsWith('/three/build/three.core.js')) return null;
      if (!announcement.test(code))
        throw new Error(`This three.js release announces itself in another way: ${id}`);
      return { code: code.replace(announcement, ''), map: null };
    },
  };
}
