// The parts of pages that are not typed by hand: the API's tables from the manifest, the release
// notes from the change log, the sizes from the built package. Text in, HTML out.

import { readdirSync, readFileSync, existsSync } from 'node:fs';
import { join } from 'node:path';
import { brotliCompressSync } from 'node:zlib';
import type { CustomElementDeclaration, Package, Type } from 'custom-elements-manifest';
import { DEFAULT } from '../manifest/attributes-page.mjs';
import { blocksHtml, escapeHtml, inlineHtml } from './markdown.js';

// -- API
// -------------------------------------------------------------------------------------------------

/** One section per element: attributes, properties, methods, events, slots and parts. */
export function apiHtml(manifest: Package): string {
  return manifest.modules
    .flatMap((module) => module.declarations ?? [])
    .filter(
      (declaration): declaration is CustomElementDeclaration => 'customElement' in declaration,
    )
    .map(elementHtml)
    .join('\n');
}

function elementHtml(element: CustomElementDeclaration): string {
  const tag = element.tagName ?? '';
  const members = element.members ?? [];
  const names = new Set((element.attributes ?? []).map(({ fieldName }) => fieldName));
  const properties = members.filter((member) => member.kind === 'field' && !names.has(member.name));
  const methods = members.filter((member) => member.kind === 'method');
  return [
    `<section aria-labelledby="${tag}"><h2 id="${tag}"><code>&lt;${tag}&gt;</code></h2>`,
    described(element.description),
    table(
      tag,
      'attribute',
      'Attributes',
      element.attributes ?? [],
      ({ name, fieldName, description, default: fallback }) => [
        anchored(tag, name) +
          (fieldName === undefined || fieldName === name ? '' : ` <small>${fieldName}</small>`),
        described(withoutDefault(description)) +
          (fallback === undefined || fallback === '' ? '' : defaultHtml(fallback)),
      ],
    ),
    table(tag, 'property', 'Properties without an attribute', properties, (member) => [
      anchored(tag, member.name),
      described(member.description) + typeHtml('type' in member ? member.type : undefined),
    ]),
    table(tag, 'method', 'Methods', methods, (method) => [
      anchored(tag, method.name, `(${(method.parameters ?? []).map((p) => p.name).join(', ')})`),
      described(method.description) + typeHtml(method.return?.type, 'returns '),
    ]),
    table(tag, 'event', 'Events', element.events ?? [], (event) => [
      anchored(tag, `${event.name}-event`, '', event.name),
      described(event.description) + typeHtml(event.type),
    ]),
    table(tag, 'slot', 'Slots', element.slots ?? [], (slot) => [
      `<code>${escapeHtml(slot.name || 'none')}</code>`,
      described(slot.description),
    ]),
    table(tag, 'part', 'Parts for CSS', element.cssParts ?? [], (part) => [
      `<code>${escapeHtml(part.name)}</code>`,
      described(part.description),
    ]),
    '</section>',
  ].join('\n');
}

/** Links to every element and to everything that has a row in its tables. */
export function membersHtml(manifest: Package): string {
  const elements = manifest.modules
    .flatMap((module) => module.declarations ?? [])
    .filter(
      (declaration): declaration is CustomElementDeclaration => 'customElement' in declaration,
    );
  return elements
    .map(({ tagName = '', attributes = [], members = [], events = [] }) => {
      const names = new Set(attributes.map(({ fieldName }) => fieldName));
      const others = members.filter(({ kind, name }) => kind === 'method' || !names.has(name));
      const ids = [...attributes, ...others].map(({ name }) => [name, `-${name}`]);
      ids.push(...events.map(({ name }) => [name, `-${name}-event`]));
      const links = ids.map(
        ([name = '', id = '']) => `<a href="#${tagName}${id}"><code>${escapeHtml(name)}</code></a>`,
      );
      return `<details class="members"><summary><code>&lt;${tagName}&gt;</code></summary>
        <p class="jump"><a href="#${tagName}">all of it</a> ${links.join('\n')}</p></details>`;
    })
    .join('\n');
}

/** Two columns; nothing for an empty list. */
function table<T>(
  tag: string,
  column: string,
  caption: string,
  rows: readonly T[],
  cells: (row: T) => readonly [string, string],
): string {
  if (rows.length === 0) return '';
  const body = rows.map((row) => {
    const [name, text] = cells(row);
    return `<tr><th scope="row">${name}</th><td>${text}</td></tr>`;
  });
  return `<table class="api"><caption><b>${caption}</b> of <code>&lt;${tag}&gt;</code></caption>
    <thead><tr><th scope="col">${column}</th><th scope="col">meaning</th></tr></thead>
    <tbody>${body.join('\n')}</tbody></table>`;
}

/** A name that can be linked to. */
function anchored(tag: string, name: string, after = '', shown = name): string {
  const id = `${tag}-${name}`;
  return `<a id="${id}" href="#${id}"><code>${escapeHtml(shown + after)}</code></a>`;
}

const described = (text: string | undefined): string =>
  text === undefined || text === '' ? '' : blocksHtml(text);

/** The default is shown on its own, from the manifest's field, and not twice. */
const withoutDefault = (text: string | undefined): string => (text ?? '').replace(DEFAULT, '');

const defaultHtml = (text: string): string =>
  `<p class="type">default <code>${escapeHtml(text)}</code></p>`;

const typeHtml = (type: Type | undefined, before = ''): string =>
  type === undefined || type.text === 'void'
    ? ''
    : `<p class="type">${before}<code>${escapeHtml(type.text)}</code></p>`;

// -- Release notes
// -------------------------------------------------------------------------------------------------

const RELATIVE_LINK = /\[([^\]]+)\]\((?!https?:)[^)]+\)/g;

/**
 * The change log without its title. @param repository the address that its relative links refer to;
 * empty: no links.
 */
export const releasesHtml = (changelog: string, repository: string): string =>
  blocksHtml(
    repository === ''
      ? changelog.replace(/^# .*\n/, '').replace(RELATIVE_LINK, '$1')
      : changelog.replace(/^# .*\n/, ''),
    `${repository}/blob/main/`,
  ).replace(
    /<h2>\[?([^\]<]+)\]?/g,
    (_, name: string) => `<h2 id="${escapeHtml(name.split(' ')[0]!.toLowerCase())}">${name}`,
  );

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
  { words: '`phong-viewer/standalone`, with three.js and Lit inside', folder: '.', file: /^phong-viewer\.standalone\.js$/, noted: 118 }, // oxfmt-ignore
  {
    words: 'the control panel, when it is first opened',
    folder: 'chunks',
    file: /^(panel|round-number|followed-drag)-/,
    noted: 20.3,
  },
  { words: 'the teapot, when it is first shown', folder: 'chunks', file: /^teapot-/, noted: 3.2 },
  { words: 'the reader of glTF and GLB, with the first model of this format', folder: 'chunks', file: /^read-gltf-/, noted: 40 }, // oxfmt-ignore
  { words: 'the reader of OBJ and MTL', folder: 'chunks', file: /^read-obj-/, noted: 4 },
  { words: 'the reader of STL', folder: 'chunks', file: /^read-stl-/, noted: 1.9 },
  { words: 'the reader of PLY', folder: 'chunks', file: /^read-ply-/, noted: 3.1 },
  {
    words: 'the Draco decoder, if a model needs it',
    folder: 'chunks',
    file: /^draco_decoder/,
    noted: 49,
  },
  {
    words: 'the meshopt decoder, if a model needs it',
    folder: 'chunks',
    file: /^meshopt-/,
    noted: 6.7,
  },
];

/** The script for pages opened from disk, which is no download of a page. */
const CLASSIC: SizeRow = {
  words: '',
  folder: '.',
  file: /^phong-viewer\.classic\.js$/,
  noted: 324,
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
