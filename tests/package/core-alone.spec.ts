// Does a bundler leave out the parts of core that a page does not use? It can only drop a module that does nothing on
// import.

import { join } from 'node:path';
import { outputFolder } from '../../.ci/output-folder.mjs';
import { expect, test } from '@playwright/test';
import { bundleOf } from './bundle.js';

test('a page that imports only the lights from core gets nothing of three.js', async () => {
  const code = await bundleOf(`
    import { LightState } from ${JSON.stringify(join(outputFolder('dist'), 'core.js'))};
    console.log(new LightState({ cutoff: 2 }).values);
  `);
  expect(code).toContain('cutoff');
  expect(code).not.toMatch(/Box3|Matrix4|WebGLRenderer/);
  expect(code.length).toBeLessThan(20_000); // measured 18,514: the lights' values and their checks
});
