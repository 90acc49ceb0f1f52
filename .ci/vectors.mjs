// @ts-check
// Writes dist/vectors.json. A step of `npm run build`.

import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';
import { outputFolder } from './output-folder.mjs';

const repository = fileURLToPath(new URL('..', import.meta.url));
const { module } = await runnerImport(join(repository, '.ci/vectors.ts'), {
  root: repository,
  configFile: false,
  logLevel: 'warn',
});
const { vectors } = /** @type {typeof import('./vectors.js')} */ (module);
const rows = vectors().map((row) => `    ${JSON.stringify(row)}`);
writeFileSync(
  join(outputFolder('dist'), 'vectors.json'),
  `{
  "about": "Phong's equation for one light, with exact colours: see the guide, Test vectors.",
  "license": "CC0-1.0: in the public domain",
  "points": [
${rows.join(',\n')}
  ]
}
`,
);
