// @ts-check
// Writes the ready sets of texts into dist/texts/: a module to import, and the same as JSON to paste into pages. A step
// of `npm run build`.

import { mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { join, parse } from 'node:path';
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';
import { outputFolder } from './output-folder.mjs';

const repository = fileURLToPath(new URL('..', import.meta.url));
const folder = join(repository, 'src/element/texts');
const target = join(outputFolder('dist'), 'texts');
mkdirSync(target, { recursive: true });

for (const file of readdirSync(folder)) {
  const { module } = await runnerImport(join(folder, file), {
    root: repository,
    configFile: false,
    logLevel: 'warn',
  });
  const { default: texts } = /** @type {{ default: Record<string, string> }} */ (module);
  const json = JSON.stringify(texts, null, 2);
  writeFileSync(join(target, `${parse(file).name}.json`), `${json}\n`);
  writeFileSync(join(target, `${parse(file).name}.js`), `export default ${json};\n`);
}
