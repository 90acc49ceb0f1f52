// @ts-check
// What a bench run leaves: one JSON file a stack. Says its shape, and reads those that lie in tests/bench/results.

import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

/**
 * @typedef {import('./figures/peer-row.mjs').PeerRow} PeerRow
 *
 * @typedef {object} BenchResult
 * @property {Record<string, unknown>} machine
 * @property {number} seed
 * @property {number} launches
 * @property {number} rounds
 * @property {import('./front.mjs').Front[]} fronts
 * @property {import('./growth.mjs').Growth[]} growth
 * @property {PeerRow[]} peers
 * @property {Record<string, import('./report.mjs').Figure[]>} figures
 */

/** A file of one run; what it did not measure is empty. @param {string} path @returns {BenchResult} */
export function readResult(path) {
  const empty = { fronts: [], growth: [], peers: [], figures: {} };
  return { ...empty, ...JSON.parse(readFileSync(path, 'utf8')) };
}

/**
 * All of a folder, by the names of their files.
 * @param {string} folder
 * @returns {(BenchResult & { stack: string })[]}
 */
export function readResults(folder) {
  if (!existsSync(folder)) return [];
  return readdirSync(folder)
    .filter((file) => file.endsWith('.json'))
    .sort()
    .map((file) => ({ stack: file.slice(0, -'.json'.length), ...readResult(join(folder, file)) }));
}

/**
 * What a row is called in a list where several may have one name: the second gets " (2)". Their order is that of the run.
 * @template T
 * @param {readonly T[]} list @param {(one: T) => string} nameOf
 * @returns {Map<string, T>}
 */
export function named(list, nameOf) {
  /** @type {Map<string, number>} */
  const counts = new Map();
  return new Map(
    list.map((one) => {
      const name = nameOf(one);
      const count = (counts.get(name) ?? 0) + 1;
      counts.set(name, count);
      return [count === 1 ? name : `${name} (${count})`, one];
    }),
  );
}
