// @ts-check
// Makes dist/: the ES modules, the standalone and the classic file, the page for frames, the types,
// the ready sets of texts, and the manifests of the elements. `node .ci/build.mjs classic` makes
// only that part; the site's server asks for parts that a page wants.

import { spawnSync } from 'node:child_process';
import { copyFileSync, readFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { brotliCompressSync } from 'node:zlib';
import { entries } from './entries.mjs';
import { outputFolder } from './output-folder.mjs';

const repository = fileURLToPath(new URL('..', import.meta.url));
process.chdir(repository);
await import('./install.mjs');
const { build } = await import('vite');

/** @type {Readonly<Record<string, () => void | Promise<void>>>} */
const parts = {
  modules: async () => {
    for (const { name, config } of entries) {
      if (config === undefined) {
        await bundle('lib', name);
      }
    }
  },
  standalone: () => bundle('standalone'),
  classic: () => bundle('classic'),
  types: () => runNode('.ci/types.mjs'),
  texts: () => runNode('.ci/texts.mjs'),
  manifest: () => runNode('.ci/manifest.mjs'),
  vectors: () => runNode('.ci/vectors.mjs'),
  embed: async () => {
    await bundle('embed');
    copyFileSync('demo/embed/embed.html', join(outputFolder('dist'), 'embed.html'));
  },
};

const chosen = process.argv.slice(2);
for (const [name, make] of Object.entries(parts)) {
  if (chosen.length === 0 || chosen.includes(name)) {
    await make();
  }
}

// Who builds one file wants to know where it is, and how large.
for (const name of chosen.filter((part) => part === 'classic' || part === 'standalone')) {
  const file = join(outputFolder('dist'), `phong-viewer.${name}.js`);
  const bytes = readFileSync(file);
  const [whole, sent] = [bytes.length, brotliCompressSync(bytes).length].map((size) =>
    Math.round(size / 1000).toLocaleString('en'),
  );
  console.log(`${relative(repository, file)}: ${whole} kB, ${sent} kB as a server sends it`);
}

/** @param {string} config @param {string} [mode] */
async function bundle(config, mode) {
  const configFile = join(repository, `.ci/vite/${config}.config.ts`);
  // How long a plugin took is no warning, least of all for who builds this for the first time.
  const quiet = { rolldownOptions: { checks: { pluginTimings: false } } };
  await build({
    configFile,
    build: quiet,
    logLevel: 'warn',
    ...(mode === undefined ? {} : { mode }),
  });
}

/** @param {string[]} args */
function runNode(...args) {
  const { status } = spawnSync(process.execPath, args, { stdio: 'inherit' });
  if (status !== 0) {
    process.exit(status ?? 1);
  }
}
