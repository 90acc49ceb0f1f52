// Is what a page does not use of core left out of its bundle? A bundler drops what nothing needs only where importing it does nothing.
import { join } from 'node:path';
import { build } from 'vite';
import { outputFolder } from '../../.ci/output-folder.mjs';
import { expect, test } from '../support/test.js';

test('a page that takes the lights alone from core gets nothing of three.js', async () => {
  const entry = 'lights-alone';
  const source = `import { LightState } from ${JSON.stringify(join(outputFolder('dist'), 'core.js'))};
    console.log(new LightState({ cutoff: 2 }).values);`;
  const built = await build({
    configFile: false,
    logLevel: 'silent',
    build: { write: false, rolldownOptions: { input: entry } },
    plugins: [
      {
        name: entry,
        resolveId: (id) => (id === entry ? id : undefined),
        load: (id) => (id === entry ? source : undefined),
      },
    ],
  });
  if (!('output' in built)) throw new Error('more than one bundle');
  const code = built.output.map((part) => (part.type === 'chunk' ? part.code : '')).join('\n');
  expect(code).toContain('cutoff');
  expect(code).not.toMatch(/Box3|Matrix4|WebGLRenderer/);
  expect(code.length).toBeLessThan(20_000); // measured 18,514: the lights' values and their checks
});
