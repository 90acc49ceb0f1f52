// @ts-check
// Installs the packages of package-lock.json if node_modules does not hold exactly those. Imports
// no package: it runs before there are any.

import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const repository = fileURLToPath(new URL('..', import.meta.url));

/** @typedef {{ version?: string, optional?: boolean }} Package */

/** @param {string} path @returns {Record<string, Package>} */
function packagesOf(path) {
  return JSON.parse(readFileSync(repository + path, 'utf8')).packages;
}

/**
 * Compares with the lock file that npm writes into node_modules. Optional packages may be absent.
 */
function isCurrent() {
  try {
    const installed = packagesOf('node_modules/.package-lock.json');
    return Object.entries(packagesOf('package-lock.json')).every(([path, wanted]) => {
      const found = installed[path];
      return path === '' || (found ? found.version === wanted.version : wanted.optional);
    });
  } catch {
    return false;
  }
}

if (!isCurrent()) {
  console.log('Installing packages by package-lock.json');
  // Through a shell, because npm is a script on Windows.
  const { status } = spawnSync('npm ci --no-audit --no-fund', {
    cwd: repository,
    stdio: 'inherit',
    shell: true,
  });
  if (status !== 0) {
    console.error('npm ci failed. Is there a network, and is this Node 20.19 or later with npm?');
    process.exit(1);
  }
}
