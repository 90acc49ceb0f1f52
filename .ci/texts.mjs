// @ts-check
// Writes the ready sets of texts into dist/texts/: the JSON to paste into pages, and a module of it to import. A step of
// `npm run build`.

import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, parse } from 'node:path';
import { fileURLToPath } from 'node:url';
import { outputFolder } from './output-folder.mjs';

const folder = fileURLToPath(new URL('../src/element/texts/', import.meta.url));
const target = join(outputFolder('dist'), 'texts');
mkdirSync(target, { recursive: true });

const types = `import type { CompleteTexts } from '../types/element/fields/texts.js';
declare const texts: CompleteTexts;
export default texts;
`;

for (const file of readdirSync(folder)) {
  const { name } = parse(file);
  const json = readFileSync(join(folder, file), 'utf8');
  writeFileSync(join(target, file), json);
  writeFileSync(join(target, `${name}.js`), `export default ${json.trim()};\n`);
  writeFileSync(join(target, `${name}.d.ts`), types);
}
