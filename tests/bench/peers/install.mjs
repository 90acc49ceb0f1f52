// @ts-check
// The viewers that others publish, as their documentation says to use them without a bundler: one
// script for the page, which fetches what it needs from beside it. Their decoders come from this
// server instead of their hosts.

import { spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = fileURLToPath(new URL('.', import.meta.url));
const packages = join(here, 'node_modules');
/** The decoder that all viewers load. */
export const DRACO = fileURLToPath(
  new URL('../../../node_modules/three/examples/jsm/libs/draco/gltf/', import.meta.url),
);
const BABYLON_HOST = 'https://cdn.babylonjs.com';

/**
 * Versions of the packages by name; null where they are not installed and there is no network.
 * @returns {Record<string, string> | null}
 */
export function installPeers() {
  if (!existsSync(join(packages, '@babylonjs/viewer/dist'))) {
    const npm = process.platform === 'win32' ? 'npm.cmd' : 'npm';
    const args = ['ci', '--legacy-peer-deps', '--ignore-scripts', '--no-audit', '--no-fund'];
    if (
      spawnSync(npm, args, { cwd: here, stdio: 'ignore', shell: npm.endsWith('.cmd') }).status !== 0
    ) {
      return null;
    }
  }
  /** @param {string} name */
  const version = (name) =>
    JSON.parse(readFileSync(join(packages, name, 'package.json'), 'utf8')).version;
  return {
    'model-viewer': version('@google/model-viewer'),
    'babylon-viewer': version('@babylonjs/viewer'),
  };
}

/** Their scripts and decoders, below `folder`. @param {string} folder */
export function copyPeers(folder) {
  mkdirSync(join(folder, 'babylon/chunks'), { recursive: true });
  cpSync(
    join(packages, '@google/model-viewer/dist/model-viewer.min.js'),
    join(folder, 'model-viewer.min.js'),
  );
  const dist = join(packages, '@babylonjs/viewer/dist');
  const scripts = readdirSync(join(dist, 'chunks'))
    .filter((file) => file.endsWith('.min.js'))
    .map((file) => `chunks/${file}`);
  for (const file of ['babylon-viewer.esm.min.js', ...scripts]) {
    const text = readFileSync(join(dist, file), 'utf8');
    writeFileSync(
      join(folder, 'babylon', file),
      text.replaceAll(BABYLON_HOST, '/peers/babylon-host'),
    );
  }
  const { version } = JSON.parse(
    readFileSync(join(packages, '@babylonjs/viewer/package.json'), 'utf8'),
  );
  const host = join(folder, 'babylon-host', `v${version}`);
  for (const [name, file] of Object.entries(BABYLON_DRACO)) {
    cpSync(join(DRACO, file), join(host, name));
  }
}

/** What Babylon.js calls the same decoder. */
const BABYLON_DRACO = {
  'draco_wasm_wrapper_gltf.js': 'draco_wasm_wrapper.js',
  'draco_decoder_gltf.wasm': 'draco_decoder.wasm',
};
