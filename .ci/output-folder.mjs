// @ts-check
// Where do generated folders go? Into the repository's root, or into the folder named by
// PHONG_VIEWER_OUT, so that two runs in one checkout do not overwrite each other's dist/, site/ and
// test-results/.

import { existsSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { refuse } from '../tests/support/command-line.mjs';

const repository = fileURLToPath(new URL('..', import.meta.url));

/**
 * @param {'dist' | 'site' | 'dist-harness' | 'test-results' | 'truths'} name
 * @returns {string} absolute path
 */
export function outputFolder(name) {
  return join(resolve(process.env['PHONG_VIEWER_OUT'] || repository), name);
}

/**
 * Refuses to go on without a file that another command builds. @param {string} file @param {string}
 * command
 */
export function needBuilt(file, command) {
  if (!existsSync(file)) {
    refuse(`${file} is missing: run \`${command}\` first`);
  }
}
