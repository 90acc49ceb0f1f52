// @ts-check
// Writes the descriptions of the elements that editors and documentation tools read into dist/, and
// the tables of demo/guide/reference.md. A step of `npm run build`.

import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';
import { describeElements } from './manifest/elements.mjs';
import { customElementsManifest, vsCodeHtmlData, webTypes } from './manifest/formats.mjs';
import { referencePage } from './manifest/reference-page.mjs';
import { outputFolder } from './output-folder.mjs';

const repository = fileURLToPath(new URL('..', import.meta.url));

const { module: tables } = await runnerImport(join(repository, '.ci/manifest/tables.ts'), {
  root: repository,
  configFile: false,
  logLevel: 'warn',
});
const elements = describeElements(/** @type {typeof import('./manifest/tables.js')} */ (tables));

write('custom-elements.json', customElementsManifest(elements));
write(
  'web-types.json',
  webTypes(elements, JSON.parse(readFileSync(join(repository, 'package.json'), 'utf8'))),
);
write('vscode.html-custom-data.json', vsCodeHtmlData(elements));
const page = join(repository, 'demo/guide/reference.md');
writeFileSync(page, referencePage(readFileSync(page, 'utf8'), elements));

/** @param {string} name @param {object} content */
function write(name, content) {
  writeFileSync(join(outputFolder('dist'), name), `${JSON.stringify(content, null, 2)}\n`);
}
