// Puts three's GLTFLoader, and the classes of three.js that only the loader needs, into the chunk
// that reads glTF. Bundlers do not split three.core.js: what a chunk imports of it is in the file
// that every page fetches, and these classes are 42 kB of it. They extend and use the user's own
// three.js.

import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Plugin } from 'vite';

const sources = '/node_modules/three/src/';
const loader = /\/node_modules\/three\/examples\/jsm\/(loaders\/GLTFLoader|utils\/\w+)\.js$/;

/** Files of three/src that the first file and three's renderer do without. */
const own =
  /^(loaders\/.+|animation\/PropertyBinding|core\/Interleaved\w+|materials\/MeshStandardMaterial|math\/(MathUtils|Interpolant)|objects\/(Bone|Skeleton|SkinnedMesh)|constants|utils)\.js$/;

/** Files for what src/extras/models/gltf/document.ts takes out of each document before it is read. */
const unreached =
  /^(animation\/(AnimationClip|tracks\/\w+)|materials\/(LineBasic|Points)Material|objects\/(Line\w*|Points))\.js$/;

/** What the ES modules of browsers import of three/src, or of GLTFLoader, is no import of theirs. */
export const isOfGltfThree = (specifier: string): boolean =>
  /^three\/(src\/|addons\/loaders\/GLTFLoader)/.test(specifier);

export function gltfThree(): Plugin {
  const index = fileURLToPath(import.meta.resolve('three/src/Three.Core.js'));
  const exported = readFileSync(index, 'utf8').matchAll(/export \{ (\w+) \} from '\.\/(.+)';/g);
  const files = new Map(Array.from(exported, ([, name = '', file = '']) => [name, file]));
  const importOf = (name: string): string => {
    const file = files.get(name) ?? `materials/${name}.js`;
    if (unreached.test(file)) return `const ${name} = undefined;`;
    return `import { ${name} } from '${own.test(file) ? `three/src/${file}` : 'three'}';`;
  };
  return {
    name: 'gltf-three',
    enforce: 'pre',
    async resolveId(specifier, importer, options) {
      if (importer === undefined || !importer.includes(sources)) return null;
      const resolved = await this.resolve(specifier, importer, { ...options, skipSelf: true });
      const file = resolved?.id.split(sources)[1];
      return file === undefined || own.test(file) ? resolved : { id: 'three', external: true };
    },
    transform(code, id) {
      if (!loader.test(id)) return null;
      return code.replace(/import \{([^}]+)\} from 'three';/, (_, list: string) =>
        (list.match(/\w+/g) ?? []).map(importOf).join('\n'),
      );
    },
  };
}
