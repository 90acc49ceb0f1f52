// The copy of three.js inside the standalone file. It is private: three leaves its version on `window` and warns when it finds
// one there, and a page that also uses three.js itself would get that warning for a copy it never sees. And it is lean: what
// no ShaderMaterial can reach is replaced by the modules of lean-three/, one for one by file name. It is taken from three's
// sources, module by module, so that what only the loaders use goes with them.

import { existsSync } from 'node:fs';
import { basename } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';

const announcement =
  /if \( typeof window !== 'undefined' \) \{\s*if \( window\.__THREE__ \) \{[^}]*\} else \{[^}]*\}\s*\}/;

/** Folders of three/src/renderers whose modules lean-three/ may replace. */
const replaceable = /\/three\/src\/renderers\/(?:webgl|webxr|shaders)\/[^/]+\.js$/;

export function privateThree(): Plugin {
  const found = new Set<string>();
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
      if (!id.endsWith('/three/src/Three.Core.js')) return null;
      if (!announcement.test(code))
        throw new Error(`This three.js release announces itself in another way: ${id}`);
      found.add('announcement');
      return { code: code.replace(announcement, ''), map: null };
    },
    buildEnd(error) {
      if (error === undefined && !found.has('announcement'))
        this.error('three.js has not come from its sources: nothing of it is private or lean.');
    },
  };
}

function leanPath(path: string): string {
  const lean = fileURLToPath(new URL(`lean-three/${basename(path)}`, import.meta.url));
  return existsSync(lean) ? lean : path;
}
