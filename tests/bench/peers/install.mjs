// @ts-check
// What only the bench needs, by locks of its own: the peers, installed on first use. Those that come ready for a page, as their
// documentation has them loaded, are copied beside the built pages; the others are bundled with the page that uses them.

import { execSync } from 'node:child_process';
import { cpSync, existsSync, readFileSync, statSync } from 'node:fs';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = fileURLToPath(new URL('.', import.meta.url));

/**
 * @typedef {object} Peer
 * @property {string} folder with package.json and lock
 * @property {string} name of its package
 * @property {string} [dist] folder of the package that pages load from
 * @property {RegExp} [files] which of that folder's files
 */

/** @type {readonly Peer[]} */
const PEERS = [
  { folder: 'model-viewer', name: '@google/model-viewer' },
  { folder: 'aframe', name: 'aframe', dist: 'dist', files: /^aframe-master\.min\.js$/ },
  { folder: 'babylon-viewer', name: '@babylonjs/viewer', dist: 'dist', files: /\.min\.js$/ },
  // Its script loads components, and what they need, from assets/ beside it.
  {
    folder: 'x-ite',
    name: 'x_ite',
    dist: 'dist',
    files: /^x_ite\.min\.js$|\.min\.js$|\.(css|svg|wasm|png|ttf|woff2?)$/,
  },
];

/** Of the packages, by their folders' names. */
export function peerVersions() {
  return Object.fromEntries(PEERS.map((peer) => [peer.folder, packageOf(peer).version]));
}

export function installPeers() {
  for (const peer of PEERS) {
    const cwd = join(here, peer.folder);
    if (existsSync(join(cwd, 'node_modules/.package-lock.json'))) continue;
    console.log(`Installing ${peer.name}, for the bench alone`);
    // A command line, since on Windows npm is a script that only a shell finds.
    execSync('npm ci --no-audit --no-fund --ignore-scripts', { cwd, stdio: 'inherit' });
  }
}

/** Beside the built pages, so that they need no other host. @param {string} folder */
export function copyPeers(folder) {
  for (const { folder: peer, name, dist, files } of PEERS) {
    if (dist === undefined) continue;
    cpSync(join(here, peer, 'node_modules', name, dist), join(folder, 'peers', peer), {
      recursive: true,
      filter: (path) => statSync(path).isDirectory() || (files?.test(basename(path)) ?? true),
    });
  }
}

/** @param {Peer} peer @returns {{ version: string }} */
function packageOf({ folder, name }) {
  return JSON.parse(readFileSync(join(here, folder, 'node_modules', name, 'package.json'), 'utf8'));
}
