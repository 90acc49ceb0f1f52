// @ts-check
// Runs every guard of guards.ts: with its wrong function in place, a test of the named file must fail. About a minute.

import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';
import { startVitest } from 'vitest/node';
import { readCommandLine } from '../support/command-line.mjs';

readCommandLine('node tests/mutation/guards.mjs: does a test fail when a named behaviour is broken?', {});
process.chdir(fileURLToPath(new URL('../..', import.meta.url)));

/** @type {{ module: typeof import('./guards.js') }} */
const { module } = await runnerImport('./tests/mutation/guards.ts');
const projects = module.GUARDS.map(({ test }, i) => ({
  test: {
    name: `guard ${i}`,
    include: [test],
    setupFiles: ['tests/mutation/guard-setup.ts'],
    env: { PHONG_VIEWER_GUARD: String(i) },
  },
}));
const vitest = await startVitest('test', [], { config: false, watch: false, reporters: [{}], projects });
const loose = module.GUARDS.filter((_, i) => {
  const files = vitest.state.getTestModules().filter(({ project }) => project.name === `guard ${i}`);
  return !files.some((file) => [...file.children.allTests('failed')].length > 0);
});
await vitest.close();
for (const { behaviour, test } of loose) console.error(`No test of ${test} fails without this: ${behaviour}`);
console.log(`${module.GUARDS.length - loose.length} of ${module.GUARDS.length} guarded behaviours are tested`);
process.exit(loose.length > 0 ? 1 : 0);
