// @ts-check
// Makes dist/: the ES modules, the standalone and the classic file, the types, the ready sets of texts, and the
// manifests of the elements.

import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'vite';
import { outputFolder } from './output-folder.mjs';

const repository = fileURLToPath(new URL('..', import.meta.url));
process.chdir(repository);

for (const mode of ['index', 'trusted-types', 'core', 'reference', 'react', 'react-standalone', 'playwright'])
  await build({ configFile: join(repository, '.ci/vite/lib.config.ts'), mode, logLevel: 'warn' });
for (const name of ['standalone', 'classic'])
  await build({ configFile: join(repository, `.ci/vite/${name}.config.ts`), logLevel: 'warn' });
runNode(
  'node_modules/typescript/bin/tsc',
  '-p',
  'tsconfig.build.json',
  '--outDir',
  outputFolder('dist') + '/types',
);
runNode('.ci/texts.mjs');
if (existsSync('.ci/manifest.mjs')) runNode('.ci/manifest.mjs');

/** @param {string[]} args */
function runNode(...args) {
  const { status } = spawnSync(process.execPath, args, { stdio: 'inherit' });
  if (status !== 0) process.exit(status ?? 1);
}
