// @ts-check
// Where do generated folders go? Into the repository's root, or into the folder named by
// PHONG_VIEWER_OUT, so that two runs in one checkout do not overwrite each other's dist/, site/ and
// test-results/.

import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const repository = fileURLToPath(new URL('..', import.meta.url));

/**
 * @param {'dist' | 'site' | 'dist-harness' | 'test-results' | 'truths'} name
 * @returns {string} absolute path
 */
export function outputFolder(name) {
  return join(resolve(process.env['PHONG_VIEWER_OUT'] || repository), name);
}
