// Bundles functions that run inside a page, each into one that carries its imports: Playwright and
// other drivers send a function as text.

import { fileURLToPath } from 'node:url';
import { build, type Plugin, type Rolldown } from 'vite';

const entry = fileURLToPath(new URL('../src/extras/playwright/in-page.ts', import.meta.url));

/** Replaces src/extras/playwright/in-page.ts by the module of its bundled functions. */
export function inPage(): Plugin {
  return {
    name: 'in-page',
    enforce: 'pre',
    load: (id) => (id === entry ? inPageModule() : null),
  };
}

/** The text of a module with the same exports. Each function takes the viewer and one argument. */
export async function inPageModule(): Promise<string> {
  const { code, exports } = await bundled();
  const functions = exports.map((name) => `export const ${name} = inPage('${name}');`);
  return `const code = ${JSON.stringify(code)};
const inPage = (name) => new Function('viewer', 'argument', code + 'return inPage.' + name + '(viewer, argument);');
${functions.join('\n')}
`;
}

/** A script that declares `inPage`, an object of the functions. */
async function bundled(): Promise<Rolldown.OutputChunk> {
  const built = (await build({
    configFile: false,
    publicDir: false,
    logLevel: 'warn',
    build: { write: false, target: 'es2022', lib: { entry, formats: ['iife'], name: 'inPage' } },
  })) as Rolldown.RolldownOutput[];
  const [chunk, ...others] = built[0]?.output ?? [];
  if (chunk === undefined || others.length > 0) {
    throw new Error(`${entry} is more than one script.`);
  }
  return chunk;
}
