// @ts-check
// Writes the ready sets of texts into dist/texts/, each a module whose value is JSON, to import or to
// paste into a page; and the type of their keys. A step of `npm run build`, after the types.

import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { outputFolder } from './output-folder.mjs';

const src = fileURLToPath(new URL('../src/', import.meta.url));

/** Each folder of an extra may have a table. */
const files = [
  'viewer/element/fields/texts.json',
  'phong/mistakes/texts.json',
  ...readdirSync(join(src, 'extras')).map((name) => `extras/${name}/texts.json`),
].filter((file) => existsSync(join(src, file)));

/**
 * By heading, then by key. @type {Readonly<Record<string, Readonly<Record<string,
 * Readonly<Record<string, string>>>>>>[]}
 */
const tables = files.map((file) => JSON.parse(readFileSync(join(src, file), 'utf8')));

const table = Object.assign({}, ...tables.flatMap((sections) => Object.values(sections)));

export const TEXT_KEYS = Object.keys(table);

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
    writeFileSync(join(target, `${name}.js`), `export default ${json};\n`);
    writeFileSync(join(target, `${name}.d.ts`), module);
  }
  const types = join(outputFolder('dist'), 'types/viewer');
  const keys = TEXT_KEYS.map((key) => JSON.stringify(key));
  writeFileSync(
    join(types, 'element/fields/text-key.d.ts'),
    `export type TextKey = ${keys.join(' | ')};\n`,
  );
  // It names the tables.
  writeFileSync(join(types, 'extras.d.ts'), 'export {};\n');
}
