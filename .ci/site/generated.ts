// The parts of pages that are not typed by hand: the examples, and the sizes from the built
// package. Text in, HTML out.

import { readdirSync, readFileSync, existsSync } from 'node:fs';
import { join } from 'node:path';
import { brotliCompressSync } from 'node:zlib';
import { parseHTML } from 'linkedom';
import { COLUMNS, markupOf } from '../../demo/parts/markup.js';
import { escapeHtml, inlineHtml } from './markdown.js';

// -- Examples
// -------------------------------------------------------------------------------------------------

export interface Example {
  readonly name: string;
  readonly title: string;
  readonly words: string;
}

/** Each example: its picture, what it shows, its markup, and the way to the playground. */
export const examplesHtml = (
  examples: readonly Example[],
  sceneHtml: (name: string) => string,
): string =>
  examples
    .map(
      ({
        name,
        title,
        words,
      }) => `<section class="example" id="${name}" aria-labelledby="${name}-title">
      <h2 id="${name}-title">${escapeHtml(title)}</h2>
      <p>${inlineHtml(words)} <a href="../playground/#example=${name}" aria-label="Open in the playground: ${escapeHtml(title)}">Playground</a></p>
      <figure>${sceneHtml(name)}</figure>
      <div class="listing" data-of="#${name} figure > *" data-title="${escapeHtml(title)}"></div>
    </section>`,
    )
    .join('\n');

/**
 * Writes the markup that a listing is of into it, as the script will for a screen and for a phone:
 * the page keeps its height.
 */
export function withListings(html: string): string {
  const { document } = parseHTML(html);
  return html.replace(
    /(<div class="listing" data-of="([^"]+)"[^>]*>)(?=<\/div>)/g,
    (_, start: string, selector: string) => {
      const element = document.querySelector(selector)!;
      const texts = Object.entries({ wide: COLUMNS, narrow: 44 }).map(([width, columns]) => {
        const pieces = markupOf(element, columns);
        const text = escapeHtml(pieces.map((piece) => piece.text).join(''));
        return `<pre class="${width}" translate="no">${text}</pre>`;
      });
      return start + texts.join('');
    },
  );
}

// -- Sizes
// -------------------------------------------------------------------------------------------------

interface SizeRow {
  readonly words: string;
  readonly folder: string;
  readonly file: RegExp;
  /**
   * Measured, in kB after Brotli. Shown where the package has not been built, as after a fresh `npm
   * start`.
   */
  readonly noted: number;
}

/** What files of dist/ are for. */
export const SIZES: readonly SizeRow[] = [
  { words: '`phong-viewer/standalone`, with three.js and Lit inside', folder: '.', file: /^phong-viewer\.standalone\.js$/, noted: 127 }, // oxfmt-ignore
  {
    words: 'the control panel, when it is first opened',
    folder: 'chunks',
    file: /^(panel(-rows)?|round-number|followed-drag)\./,
    noted: 20.3,
  },
  { words: 'the teapot, when it is first shown', folder: 'chunks', file: /^teapot\./, noted: 3.2 },
  { words: 'the reader of glTF and GLB, with the first model of this format', folder: 'chunks', file: /^read-gltf\./, noted: 37 }, // oxfmt-ignore
  { words: 'the reader of OBJ and MTL', folder: 'chunks', file: /^read-obj\./, noted: 4 },
  { words: 'the reader of STL', folder: 'chunks', file: /^read-stl\./, noted: 1.9 },
  { words: 'the reader of PLY', folder: 'chunks', file: /^read-ply\./, noted: 3.5 },
  {
    words: 'the Draco decoder, if a model needs it',
    folder: 'chunks',
    file: /^draco_decoder/,
    noted: 49,
  },
  {
    words: 'the meshopt decoder, if a model needs it',
    folder: 'chunks',
    file: /^meshopt\./,
    noted: 6.7,
  },
];

/** The script for pages opened from disk, which is no download of a page. */
const CLASSIC: SizeRow = {
  words: '',
  folder: '.',
  file: /^phong-viewer\.classic\.js$/,
  noted: 358,
};

/**
 * Size after Brotli in kB (1,000 bytes), measured; undefined where the package has not been built.
 */
export function measured(dist: string, { folder, file }: SizeRow): number | undefined {
  const path = join(dist, folder);
  const names = existsSync(path)
    ? readdirSync(path).filter((name) => file.test(name) && !name.endsWith('.map'))
    : [];
  const bytes = names.map((name) => brotliCompressSync(readFileSync(join(path, name))).length);
  return bytes.length === 0 ? undefined : bytes.reduce((sum, size) => sum + size) / 1000;
}

const sizeText = (dist: string, row: SizeRow): string => {
  const kilobytes = measured(dist, row) ?? row.noted;
  return kilobytes < 10 ? kilobytes.toFixed(1) : String(Math.round(kilobytes));
};

/** Size in kB of a file that has a row. */
export const sizeOf = (dist: string, name: string): string =>
  sizeText(
    dist,
    [...SIZES, CLASSIC].find(({ file }) => file.test(name))!,
  );

/** Rows of a table. @param dist the built package. */
export const sizesHtml = (dist: string): string =>
  SIZES.map(
    (row) =>
      `<tr><th scope="row">${inlineHtml(row.words)}</th><td>${sizeText(dist, row)} kB</td></tr>`,
  ).join('\n');
