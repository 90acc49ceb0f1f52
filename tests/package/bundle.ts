// Bundles a script as a user's bundler does. The script may import packages of this repository or
// files of dist/.

import { execFileSync } from 'node:child_process';
import { build } from 'vite';
import { repository } from '../support/repository.mjs';

const entry = 'script-of-a-user';

interface BundleOptions {
  /** Puts what a page would fetch later into the same file, not minified. Default false. */
  readonly whole?: boolean;
  /** Expressions and what replaces them. */
  readonly define?: Record<string, string>;
}

/**
 * The code that a page fetches at start, minified. Imports are resolved from the repository's root.
 */
export async function bundleOf(
  script: string,
  { whole = false, define = {} }: BundleOptions = {},
): Promise<string> {
  const built = await build({
    root: repository,
    configFile: false,
    logLevel: 'silent',
    define,
    build: {
      write: false,
      minify: !whole,
      rolldownOptions: { input: entry, output: { codeSplitting: !whole } },
    },
    plugins: [
      {
        name: entry,
        resolveId: (id) => (id === entry ? `${repository}${entry}.js` : undefined),
        load: (id) => (id === `${repository}${entry}.js` ? script : undefined),
      },
    ],
  });
  if (!('output' in built)) throw new Error('more than one bundle');
  const chunks = built.output.filter((part) => part.type === 'chunk');
  const main = chunks.find(({ isEntry }) => isEntry);
  const atStart = chunks.filter(
    ({ fileName, isEntry }) => isEntry || main?.imports.includes(fileName),
  );
  return atStart.map(({ code }) => code).join('\n');
}

/** The markup that a server sends of `App`, a component that this script defines. */
export const renderedByServer = (script: string): string =>
  execFileSync(
    process.execPath,
    [
      '--input-type=module',
      '-e',
      `${script}
      const { renderToString } = await import('react-dom/server');
      process.stdout.write(renderToString(h(App)));`,
    ],
    { cwd: repository, encoding: 'utf8' },
  );
