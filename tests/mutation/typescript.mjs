// @ts-check
// Runs mutants of the pure TypeScript with StrykerJS and the unit tests, in a copy of the
// repository.

import { mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Stryker } from '@stryker-mutator/core';

/**
 * @typedef {{ name: string, status: 'killed' | 'survived' | 'did not compile', by: string }} Result
 */

/** What Stryker finds, in this command's words. @type {Record<string, Result['status']>} */
const STATUS = {
  Killed: 'killed',
  Timeout: 'killed',
  Survived: 'survived',
  NoCoverage: 'survived',
};

/**
 * @param {{ files: readonly string[], share: number, seed: number, jobs: number }} options
 *   files: patterns; share: of all mutants, 1 for all
 * @returns {Promise<Result[]>}
 */
export async function runTypeScript({ files, share, seed, jobs }) {
  process.env['PHONG_VIEWER_SAMPLE'] = `${seed} ${share}`;
  const stryker = new Stryker({
    mutate: [...files],
    testRunner: 'vitest',
    vitest: { configFile: 'tests/mutation/vitest.config.ts' },
    plugins: ['@stryker-mutator/vitest-runner', './tests/mutation/stryker-plugin.mjs'],
    checkers: share < 1 ? ['sample'] : [],
    reporters: ['shown'],
    coverageAnalysis: 'perTest',
    // Tables at the top of modules: every test would have to run for each of their entries.
    ignoreStatic: true,
    concurrency: jobs,
    // Neither in node_modules, which Vitest ignores, nor in test-results, which Playwright empties.
    tempDirName: mkdtempSync(join(tmpdir(), 'phong-viewer-mutation-')),
    ignorePatterns: [
      'dist*',
      'demo',
      'test-results',
      'tests/bench',
      'tests/*/results',
      'tests/visual/baselines',
    ],
    allowConsoleColors: false,
    logLevel: /** @type {import('@stryker-mutator/api/core').LogLevel} */ ('warn'),
  });
  const results = await stryker.runMutationTest();
  return results.flatMap(({ fileName, location, mutatorName, replacement, status, killedBy }) => {
    const found = STATUS[status];
    if (found === undefined) return [];
    const file = fileName.slice(fileName.lastIndexOf('/src/') + 1);
    const { line, column } = location.start;
    const name = `${file}:${line}:${column} ${mutatorName} -> ${replacement}`;
    return [{ name, status: found, by: status === 'Killed' ? String(killedBy?.[0]) : status }];
  });
}
