// @ts-check
// Builds the bench's pages into a folder, with the models they show, the standalone file, the sizes
// of what users download, and the versions of everything. A machine without a network can measure
// with this folder alone.

import { execFileSync } from 'node:child_process';
import { cpSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { brotliCompressSync, constants } from 'node:zlib';
import { outputFolder } from '../../.ci/output-folder.mjs';
import { casterCode } from '../support/cast.mjs';
import { writeModels } from './models.mjs';
import { PAGE_NAMES } from './pages.mjs';
import { copyPeers, DRACO, installPeers } from './peers/install.mjs';
import { repository } from '../support/repository.mjs';

const here = fileURLToPath(new URL('.', import.meta.url));
/**
 * @typedef {object} BuiltFrom
 * @property {Record<string, string>} versions revision and packages
 * @property {Record<string, number>} bytes brotli sizes of all scripts that a page loads for its
 * first picture
 */

/** The ray caster's file among the built pages. */
export const CASTER = 'caster.js';

/** Empties `folder`. @param {string} folder */
export async function buildPages(folder) {
  const { build } = await import('vite');
  execFileSync(process.execPath, [join(repository, '.ci/build.mjs')], {
    cwd: repository,
    stdio: ['ignore', 'ignore', 'inherit'],
  });
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  process.env['PHONG_VIEWER_BENCH_OUT'] = folder;
  for (const page of PAGE_NAMES) {
    process.env['PHONG_VIEWER_BENCH_PAGE'] = page;
    await build({ configFile: join(here, 'vite.config.ts'), logLevel: 'error' });
  }
  // What a page may fetch: all but types and source maps.
  const filter = (/** @type {string} */ file) => !/[\\/]types$|\.map$/.test(file);
  cpSync(outputFolder('dist'), join(folder, 'dist'), { recursive: true, filter });
  writeModels(join(folder, 'models'));
  cpSync(DRACO, join(folder, 'draco'), { recursive: true });
  const peers = installPeers();
  if (peers === null) {
    console.error('The other viewers cannot be installed: no model will be measured.');
  } else {
    copyPeers(join(folder, 'peers'));
  }
  writeFileSync(join(folder, CASTER), await casterCode());
  compress(folder);
  const bytes = {
    standalone: brotliSize(join(folder, 'dist/phong-viewer.standalone.js')),
    bundled: pageSize(folder, 'start-element.html'),
    three: pageSize(folder, 'start-three.html'),
  };
  const about = JSON.stringify({ versions: { ...versions(), ...peers }, bytes }, null, 1);
  writeFileSync(join(folder, 'built-from.json'), about);
}

/**
 * Keeps in brotli too what servers compress of the pages that are measured over a network. @param
 * {string} folder
 */
function compress(folder) {
  for (const file of readdirSync(folder, { recursive: true, encoding: 'utf8' })) {
    if (!/^(?:dist|draco|peers|models|start-model).*\.(?:html|js|wasm|gltf)$/.test(file)) continue;
    // The highest level that does not take minutes for all of them.
    const params = { [constants.BROTLI_PARAM_QUALITY]: 9 };
    const bytes = brotliCompressSync(readFileSync(join(folder, file)), { params });
    writeFileSync(join(folder, `${file}.br`), bytes);
  }
}

/** @param {string} folder @returns {BuiltFrom} */
export const builtFrom = (folder) =>
  JSON.parse(readFileSync(join(folder, 'built-from.json'), 'utf8'));

function versions() {
  /** @param {string} name */
  const version = (name) =>
    JSON.parse(readFileSync(join(repository, 'node_modules', name, 'package.json'), 'utf8'))
      .version;
  /** @param {string[]} args */
  const git = (...args) => execFileSync('git', args, { cwd: repository, encoding: 'utf8' }).trim();
  const changed = git('status', '--short', 'src', 'shaders') === '' ? '' : ' and changes';
  const packages = ['three', 'lit', 'vite'].map((name) => [name, version(name)]);
  return {
    revision: git('rev-parse', '--short', 'HEAD') + changed,
    ...Object.fromEntries(packages),
  };
}

/** @param {string} file */
const brotliSize = (file) => brotliCompressSync(readFileSync(file)).length;

/** All scripts that a page imports statically. @param {string} folder @param {string} page */
function pageSize(folder, page) {
  const html = readFileSync(join(folder, page), 'utf8');
  const scripts = html.matchAll(/(?:src|href)="\.\/(assets\/[^"]+\.js)"/g);
  const found = new Set([...scripts].map(([, file = '']) => file));
  // A set's iteration reaches what is added on the way.
  for (const file of found) {
    const text = readFileSync(join(folder, file), 'utf8');
    for (const [, name] of text.matchAll(
      /(?:^|[;}])import(?:[^"'();]*from)?\s*["']\.\/([^"']+\.js)["']/g,
    )) {
      found.add(`assets/${name}`);
    }
  }
  return [...found].reduce((sum, file) => sum + brotliSize(join(folder, file)), 0);
}
