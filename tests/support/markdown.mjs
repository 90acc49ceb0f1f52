// @ts-check
// What the reports that commands write have in common: tables, and a part of the README between two
// marks.

import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

/** @param {readonly string[]} head @param {readonly (readonly string[])[]} rows */
export const table = (head, rows) =>
  [head, head.map(() => '---'), ...rows]
    .map((cells) => `| ${cells.map(escaped).join(' | ')} |`)
    .join('\n');

/** What would end a cell or begin a tag. @param {string} text */
export const escaped = (text) => text.replaceAll('|', '\\|').replaceAll('<', '&lt;');

/**
 * Puts `part` into the README in place of what begins and ends with the same lines. @param {string}
 * part
 */
export function writePart(part) {
  const file = fileURLToPath(new URL('../../README.md', import.meta.url));
  const readme = readFileSync(file, 'utf8');
  const lines = part.split('\n');
  const [open = '', close = ''] = [lines[0], lines.at(-1)];
  const [from, to] = [readme.indexOf(open), readme.indexOf(close)];
  if (from < 0 || to < from) throw new Error(`README.md has lost its marks ${open} and ${close}`);
  writeFileSync(file, readme.slice(0, from) + part + readme.slice(to + close.length));
}
