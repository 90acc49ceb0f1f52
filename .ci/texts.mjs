// @ts-check
// Writes the ready sets of texts into dist/texts/: the JSON to paste into pages, and a module of it
// to import; and the type of their keys. A step of `npm run build`, after the types.

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { outputFolder } from './output-folder.mjs';

/**
 * By heading, then by key. @type {Readonly<Record<string, Readonly<Record<string,
 * Readonly<Record<string, string>>>>>>}
 */
const sections = JSON.parse(
  readFileSync(
    fileURLToPath(new URL('../src/viewer/element/fields/texts.json', import.meta.url)),
    'utf8',
  ),
);

const table = Object.assign({}, ...Object.values(sections));

export const LANGUAGES = Object.keys(table['en'] ?? {});

/**
 * The ready set of a language, by key. What a language of a country does not say in its own way is
 * as in the language: `pt-PT` has few rows, and the others are those of `pt`.
 * @param {string} language
 * @returns {Record<string, string>}
 */
export const textsIn = (language) =>
  Object.fromEntries(
    Object.entries(table).map(([key, texts]) => [
      key,
      texts[language] ?? texts[language.split('-')[0] ?? ''] ?? '',
    ]),
  );

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  writeAll();
}

function writeAll() {
  const target = join(outputFolder('dist'), 'texts');
  mkdirSync(target, { recursive: true });
  const module = `import type { CompleteTexts } from '../types/viewer/element/fields/texts.js';
declare const texts: CompleteTexts;
export default texts;
`;
  for (const name of LANGUAGES) {
    const json = JSON.stringify(textsIn(name), null, 2);
    writeFileSync(join(target, `${name}.json`), `${json}\n`);
    writeFileSync(join(target, `${name}.js`), `export default ${json};\n`);
    writeFileSync(join(target, `${name}.d.ts`), module);
  }
  const keys = Object.keys(table).map((key) => JSON.stringify(key));
  writeFileSync(
    join(outputFolder('dist'), 'types/viewer/element/fields/text-key.d.ts'),
    `export type TextKey = ${keys.join(' | ')};\n`,
  );
}
