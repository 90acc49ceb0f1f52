// How Stryker runs the unit tests: those alone that import nothing above the mutated folders, in
// one environment, the quickest files first. So most mutants die within a second.

import { readdirSync, readFileSync } from 'node:fs';
import { mergeConfig } from 'vitest/config';
import { BaseSequencer, type TestSpecification } from 'vitest/node';
import config from '../../vitest.config.js';

/**
 * What a test of pure code has no need of: three.js, the layers above but for their tables of
 * fields and what is pure itself, tools and files.
 */
const ABOVE =
  /from '(three|[^']*\/(explained|model-files)|[^']*src\/(phong\/material|viewer\/scene|viewer\/element|extras\/panel)\/(?![^']*(fields|values|tiles|travel))|[^']*\/bench\/|node:)/;

/**
 * Longest time that a file has taken, in ms: a run that only needs a part of a file says little.
 */
const longest = new Map<string, number>();

class QuickestFirst extends BaseSequencer {
  override async sort(files: TestSpecification[]) {
    const { cache, config } = this.ctx;
    for (const { project, moduleId } of files) {
      const file = moduleId.replace(`${config.root}/`, '');
      const last = cache.getFileTestResults(`${project.name}:${file}`)?.duration ?? 0;
      longest.set(moduleId, Math.max(last, longest.get(moduleId) ?? 0));
    }
    const sorted = await super.sort(files);
    return sorted.sort((a, b) => longest.get(a.moduleId)! - longest.get(b.moduleId)!);
  }
}

const pure = ['tests/unit', 'tests/extras']
  .flatMap((folder) =>
    readdirSync(folder, { recursive: true }).map((name) => `${folder}/${String(name)}`),
  )
  .filter((file) => file.endsWith('.test.ts'))
  .filter((file) => !ABOVE.test(readFileSync(file, 'utf8')));

export default mergeConfig(
  { ...config, test: { ...config.test, include: pure } },
  // Instrumented code is slow, and a machine may be busy: Stryker has a clock of its own.
  { test: { sequence: { sequencer: QuickestFirst }, isolate: false, testTimeout: 120_000 } },
);
