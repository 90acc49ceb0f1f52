// @ts-check
// Two plugins for Stryker: one leaves out the mutants that are not in the sample, the other shows
// progress. Stryker loads this file in processes of its own, so the sample is in the environment:
// PHONG_VIEWER_SAMPLE="seed share".

import { relative } from 'node:path';
import { declareClassPlugin, PluginKind } from '@stryker-mutator/api/plugin';
import { Progress } from '../support/command-line.mjs';
import { drawn } from './sample.mjs';

const [seed = 0, share = 1] = (process.env['PHONG_VIEWER_SAMPLE'] ?? '0 1').split(' ').map(Number);

/** Mutants that are not drawn are reported as not compiling, which no score counts. */
class Sample {
  async init() {
    // Nothing to prepare.
  }

  /** @param {import('@stryker-mutator/api/core').Mutant[]} mutants */
  async check(mutants) {
    return Object.fromEntries(
      mutants.map(({ id, fileName, location: { start, end }, replacement }) => {
        const place = [start.line, start.column, end.line, end.column];
        const name = [relative('.', fileName).split('src/').pop(), ...place, replacement];
        const status = drawn(name.join(' '), seed) < share ? 'passed' : 'compileError';
        return [id, { status, reason: 'not in the sample' }];
      }),
    );
  }
}

class Shown {
  /** From when the mutants are run: the tests without any come first. */
  #progress = new Progress();
  #total = 0;
  #done = 0;

  /** @param {import('@stryker-mutator/api/report').MutationTestingPlanReadyEvent} event */
  onMutationTestingPlanReady({ mutantPlans }) {
    this.#progress = new Progress();
    this.#total = Math.ceil(mutantPlans.filter(({ plan }) => plan === 'Run').length * share);
  }

  /** @param {Readonly<import('@stryker-mutator/api/core').MutantResult>} result */
  onMutantTested({ status, fileName }) {
    if (status === 'CompileError' || status === 'Ignored' || status === 'NoCoverage') return;
    this.#done += 1;
    this.#progress.show(this.#done, Math.max(this.#total, this.#done + 1), relative('.', fileName));
  }

  onMutationTestReportReady() {
    this.#progress.clear();
  }
}

export const strykerPlugins = [
  declareClassPlugin(PluginKind.Checker, 'sample', /** @type {any} */ (Sample)),
  declareClassPlugin(PluginKind.Reporter, 'shown', Shown),
];
