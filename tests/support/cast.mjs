// @ts-check
// Casts pictures on all cores, and keeps them on disk. Plain JavaScript, so that the bench's
// commands can import it.

import { createHash, randomUUID } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { serialize } from 'node:v8';
import { Worker } from 'node:worker_threads';
import { outputFolder } from '../../.ci/output-folder.mjs';

/** @import { CastOptions, CastScene } from '../../src/extras/still/cast-scene.js' */

/** @type {Promise<string> | undefined} */
let bundled;

/**
 * The threads' code as one module, for machines that cannot bundle it. @returns {Promise<string>}
 */
export const casterCode = () => (bundled ??= bundle());

/**
 * The mean over each pixel's square of what the equation writes there, clamped and encoded but not
 * rounded: r, g, b, a of each pixel, rows from the top, codes 0–255, premultiplied. Kept on disk.
 * `code`: see {@link casterCode}; bundled by default.
 * @param {CastScene} scene @param {CastOptions} options @param {string} [code] @returns
 * {Promise<Float64Array>}
 */
export async function castPicture(scene, options, code) {
  code ??= await casterCode();
  const key = createHash('sha256')
    .update(code)
    .update(serialize([scene, options]))
    .digest('hex');
  const folder = outputFolder('truths');
  const file = join(folder, key.slice(0, 32));
  if (existsSync(file)) return new Float64Array(new Uint8Array(readFileSync(file)).buffer);
  const picture = await castNow(code, scene, options);
  mkdirSync(folder, { recursive: true });
  const draft = `${file}.${randomUUID()}`; // another process may be writing the same one
  writeFileSync(draft, picture);
  renameSync(draft, file);
  return picture;
}

/**
 * @param {string} code @param {CastScene} scene @param {CastOptions} options @returns
 * {Promise<Float64Array>}
 */
async function castNow(code, scene, options) {
  const next = new Int32Array(new SharedArrayBuffer(4));
  const means = new Float64Array(new SharedArrayBuffer(32 * options.width * options.height));
  const workerData = { scene, options, next, means };
  const thread = () =>
    new Promise((resolve, reject) => {
      new Worker(moduleUrl(code), { workerData }).on('error', reject).on('exit', resolve);
    });
  await Promise.all(Array.from({ length: availableParallelism() }, thread));
  return means;
}

/** The thread's module without imports. @returns {Promise<string>} */
async function bundle() {
  const { build } = await import('vite');
  const result = await build({
    configFile: false,
    logLevel: 'error',
    build: {
      ssr: fileURLToPath(new URL('../../src/extras/still/worker.ts', import.meta.url)),
      write: false,
      target: 'node20',
    },
  });
  const [{ output }] = /** @type {[import('vite').Rolldown.RolldownOutput]} */ ([result].flat());
  return output[0].code;
}

/** @param {string} code */
const moduleUrl = (code) =>
  new URL(`data:text/javascript;base64,${Buffer.from(code).toString('base64')}`);
