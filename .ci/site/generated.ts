// The parts of pages that are not typed by hand: the API's tables from the manifest, the release notes from the change log,
// the sizes from the built package. Text in, HTML out.

import { readdirSync, readFileSync, existsSync } from 'node:fs';
import { join } from 'node:path';
import { brotliCompressSync } from 'node:zlib';
import type { CustomElementDeclaration, Package, Type } from 'custom-elements-manifest';
import { blocksHtml, escapeHtml, inlineHtml } from './markdown.js';

// -- API --------------------------------------------------------------------------------------------------------------

/** One section per element: attributes, properties, methods, events, slots and parts. */
export function apiHtml(manifest: Package): string {
  return manifest.modules
    .flatMap((module) => module.declarations ?? [])
    .filter((declaration): declaration is CustomElementDeclaration => 'customElement' in declaration)
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
const withoutDefault = (text: string | undefined): string =>
  (text ?? '').replace(/ Default [^.:\n]+(\.\d+[^.:\n]*)*\.(?=\s|$)/, '');

const defaultHtml = (text: string): string => `<p class="type">default <code>${escapeHtml(text)}</code></p>`;

const typeHtml = (type: Type | undefined, before = ''): string =>
  type === undefined || type.text === 'void'
    ? ''
    : `<p class="type">${before}<code>${escapeHtml(type.text)}</code></p>`;

// -- Release notes ----------------------------------------------------------------------------------------------------

/** The change log without its title. @param repository the address that its relative links refer to. */
export const releasesHtml = (changelog: string, repository: string): string =>
  blocksHtml(changelog.replace(/^# .*\n/, ''), `${repository}/blob/main/`).replace(
    /<h2>\[?([^\]<]+)\]?/g,
    (_, name: string) => `<h2 id="${escapeHtml(name.split(' ')[0]!.toLowerCase())}">${name}`,
  );

// -- Sizes ------------------------------------------------------------------------------------------------------------

/** What a file of dist/ is for. A pattern without a file gives no row. */
const files: readonly (readonly [words: string, folder: string, pattern: RegExp])[] = [
  ['`phong-viewer/standalone`, with three.js and Lit inside', '.', /^phong-viewer\.standalone\.js$/],
  ['the control panel, when it is first opened', 'chunks', /^panel-/],
  ['the teapot, when it is first shown', 'chunks', /^teapot-/],
  ['the reader of glTF and GLB, with the first model of this format', 'chunks', /^read-gltf-/],
  ['the reader of OBJ and MTL', 'chunks', /^read-obj-/],
  ['the reader of STL', 'chunks', /^read-stl-/],
  ['the reader of PLY', 'chunks', /^read-ply-/],
  ['the Draco decoder, if a model needs it', 'chunks', /^draco_decoder/],
  ['the meshopt decoder, if a model needs it', 'chunks', /^meshopt-/],
];

/** Size after Brotli in kB (1,000 bytes), as text. */
export function kilobytes(file: string): string {
  const bytes = brotliCompressSync(readFileSync(file)).length;
  return bytes < 10_000 ? (bytes / 1000).toFixed(1) : String(Math.round(bytes / 1000));
}

/** Rows of a table. @param dist the built package. */
export function sizesHtml(dist: string): string {
  return files
    .flatMap(([words, folder, pattern]) => {
      const path = join(dist, folder);
      const name = existsSync(path) ? readdirSync(path).find((file) => pattern.test(file)) : undefined;
      if (name === undefined) return [];
      return `<tr><th scope="row">${inlineHtml(words)}</th><td>${kilobytes(join(path, name))} kB</td></tr>`;
    })
    .join('\n');
}
