// @ts-check
// Writes the descriptions of the elements that editors and documentation tools read into dist/, and
// the tables of demo/guide/reference.md and the exports in package.json. A step of `npm run build`.

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { runnerImport } from 'vite';
import { describeElements } from './manifest/elements.mjs';
import { customElementsManifest, vsCodeHtmlData, webTypes } from './manifest/formats.mjs';
import { referencePage } from './manifest/reference-page.mjs';
import { packageExports } from './entries.mjs';
import { outputFolder } from './output-folder.mjs';

const repository = fileURLToPath(new URL('..', import.meta.url));

const { module: tables } = await runnerImport(join(repository, '.ci/manifest/tables.ts'), {
  root: repository,
  configFile: false,
  logLevel: 'warn',
});
const elements = describeElements(/** @type {typeof import('./manifest/tables.js')} */ (tables));

mkdirSync(outputFolder('dist'), { recursive: true });
write('custom-elements.json', customElementsManifest(elements));
const packageFile = join(repository, 'package.json');
const packageText = readFileSync(packageFile, 'utf8');
const packageData = { ...JSON.parse(packageText), ...packageExports() };
write('web-types.json', webTypes(elements, packageData));
write('vscode.html-custom-data.json', vsCodeHtmlData(elements));
const page = join(repository, 'demo/guide/reference.md');
writeFileSync(page, referencePage(readFileSync(page, 'utf8'), elements));
// Only where the entries have changed: others may be reading it.
const packageNow = `${JSON.stringify(packageData, null, 2)}\n`;
if (packageNow !== packageText) {
  writeFileSync(packageFile, packageNow);
}

/** @param {string} name @param {object} content */
function write(name, content) {
  writeFileSync(join(outputFolder('dist'), name), `${JSON.stringify(content)}\n`);
}
