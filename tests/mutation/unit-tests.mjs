// @ts-check
// Unit tests against one mutant: the full title of the first that fails. One after another in a fixed order and with a
// fixed seed, so that the same test names itself in every run.

import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { startVitest } from 'vitest/node';
import { mutantPlugin } from './vite-mutant.mjs';

const repository = fileURLToPath(new URL('../..', import.meta.url));

class InOrder {
  /** @param {import('vitest/node').Vitest} vitest */
  constructor(vitest) {
    this.wanted = vitest.config.include;
  }
  /** @param {import('vitest/node').TestSpecification[]} files */
  sort(files) {
    const place = (/** @type {string} */ id) => this.wanted.findIndex((path) => id.endsWith(`/${path}`));
    return files.sort((a, b) => place(a.moduleId) - place(b.moduleId));
  }
  /** @param {import('vitest/node').TestSpecification[]} files */
  shard(files) {
    return files;
  }
}

/**
 * @param {import('./mutants.mjs').Mutant | null} mutant null: the code as it is
 * @param {readonly string[]} names of test files, in order
 * @returns {Promise<string | null>} null where all pass
 */
export async function failingUnitTest(mutant, names) {
  const include = names.map((name) => `tests/unit/${name}.test.ts`);
  const vitest = await startVitest(
    'test',
    [],
    {
      root: repository,
      config: join(repository, 'vitest.config.ts'),
      watch: false,
      bail: 1,
      reporters: [{}],
      fileParallelism: false,
      isolate: false,
      cache: false,
      include,
      sequence: { sequencer: InOrder },
      setupFiles: [
        join(repository, 'tests/support/quiet-lit.ts'),
        join(repository, 'tests/mutation/same-seed.ts'),
      ],
    },
    { plugins: mutant === null ? [] : [mutantPlugin(mutant)] },
  );
  const modules = vitest.state.getTestModules();
  const [stray] = vitest.state.getUnhandledErrors();
  let found = stray === undefined ? null : `unhandled error: ${String(stray)}`;
  const place = (/** @type {string} */ id) => include.findIndex((path) => id.endsWith(`/${path}`));
  for (const module of modules.sort((a, b) => place(a.moduleId) - place(b.moduleId))) {
    if (found !== null) break;
    const [failed] = module.children.allTests('failed');
    const file = include[place(module.moduleId)];
    if (failed !== undefined) found = `${file} › ${failed.fullName.replaceAll(' > ', ' › ')}`;
    else if (module.errors().length > 0) found = `${file} › cannot be loaded`;
  }
  if (modules.length === 0) throw new Error(`no tests ran: ${include.join(', ')}`);
  await vitest.close();
  process.exitCode = 0;
  return found;
}
