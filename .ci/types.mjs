// @ts-check
// Writes the types into dist/types/: those that an entry of package.json reaches. TypeScript writes
// a file for each source, most of which only our own code imports. A step of `npm run build`.

import { spawnSync } from 'node:child_process';
import { readdirSync, readFileSync, rmSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { outputFolder } from './output-folder.mjs';

const folder = join(outputFolder('dist'), 'types');
const compiler = 'node_modules/typescript/bin/tsc';
const { status } = spawnSync(
  process.execPath,
  [compiler, '-p', 'tsconfig.build.json', '--outDir', folder],
  { stdio: 'inherit' },
);
if (status !== 0) {
  process.exit(status ?? 1);
}

/** @type {Record<string, { types?: string }>} */
const exported = JSON.parse(readFileSync('package.json', 'utf8')).exports;
/** @type {Set<string>} */
const reached = new Set();
for (const { types } of Object.values(exported)) {
  if (types?.startsWith('./dist/types/')) {
    reach(join(folder, types.slice('./dist/types/'.length)));
  }
}
for (const name of readdirSync(folder, { recursive: true, encoding: 'utf8' })) {
  if (name.endsWith('.d.ts') && !reached.has(resolve(folder, name))) {
    rmSync(join(folder, name));
  }
}

/** @param {string} file */
function reach(file) {
  if (reached.has(resolve(file))) return;
  reached.add(resolve(file));
  const imports = readFileSync(file, 'utf8').matchAll(/(?:from|import)\s*\(?\s*'(\.[^']+)\.js'/g);
  for (const [, path = ''] of imports) {
    reach(join(dirname(file), `${path}.d.ts`));
  }
}
