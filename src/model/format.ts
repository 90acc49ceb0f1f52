// Finds the reader for a file's bytes. The content decides, then the element's `type`, the file extension and the media
// type. A new format is a row here and one in format-names.ts; its reader is a separate chunk, fetched with the first
// file that needs it.
import { FORMAT_NAMES, type FormatKey, type FormatNames } from './format-names.js';
import { ModelError } from './model.js';
import type { ModelReader } from './model-reader.js';
import { isBinaryStl, isTextStl } from './stl/stl-kind.js';

export interface Format extends FormatNames {
  /** Whether the bytes are those of this format and no other. */
  readonly matches: (bytes: Uint8Array) => boolean;
  readonly reader: () => Promise<ModelReader>;
}

/** How each format is recognised and read. */
const READERS: Readonly<Record<FormatKey, Pick<Format, 'matches' | 'reader'>>> = {
  gltf: {
    matches: (bytes) => startsWith(bytes, 'glTF') || firstCharacter(bytes) === '{',
    reader: async () => (await FORMAT_NAMES.gltf.code()).readGltf,
  },
  ply: {
    matches: (bytes) => startsWith(bytes, 'ply\n') || startsWith(bytes, 'ply\r'),
    reader: async () => (await FORMAT_NAMES.ply.code()).readPly,
  },
  stl: {
    matches: (bytes) => isTextStl(bytes) || isBinaryStl(bytes),
    reader: async () => (await FORMAT_NAMES.stl.code()).readStl,
  },
  obj: { matches: isObj, reader: async () => (await FORMAT_NAMES.obj.code()).readObj },
};

const FORMATS: readonly Format[] = (Object.keys(FORMAT_NAMES) as FormatKey[]).map((key) => ({
  ...FORMAT_NAMES[key],
  ...READERS[key],
}));

/** What is known about a file besides its bytes. */
interface FormatHints {
  /** What the element's `type` says: a word such as `obj` or a media type; empty for nothing. */
  readonly type?: string;
  /** The media type that came with the file; empty for none. */
  readonly mediaType?: string;
  /** The whole address, for the extension; by default the name. */
  readonly address?: string;
}

/**
 * The format of a file.
 * @param name for messages.
 * @throws ModelError `bad-model` that says what the file seems to be.
 */
export function formatOf(
  name: string,
  bytes: Uint8Array,
  { type = '', mediaType = '', address = name }: FormatHints = {},
): Format {
  if (bytes.byteLength === 0) throw new ModelError('bad-model', `The file ${name} is empty.`);
  const extension = /\.([a-z0-9]+)(?:[?#].*)?$/i.exec(address)?.[1]?.toLowerCase() ?? '';
  const byType = (written: string): Format | undefined =>
    FORMATS.find(({ types, otherTypes }) => [...types, ...otherTypes].includes(essence(written)));
  const byContent = FORMATS.find(({ matches }) => matches(bytes));
  if (byContent) return byContent;
  refuse(name, foreignContent(bytes, extension));
  const byHint = byType(type) ?? FORMATS.find(({ extensions }) => extensions.includes(extension)) ?? byType(mediaType);
  if (byHint) return byHint;
  refuse(name, foreignExtension(extension));
  throw new ModelError('bad-model', `The format is not supported: ${name}.`, {
    advice: `These are: ${supportedFormats}.`,
  });
}

/** For messages: names and extensions. */
export const supportedFormats = FORMATS.map(({ name, extensions }) => `${name} (.${extensions.join(', .')})`).join(
  ', ',
);

/** Extensions of files that can be shown, lower case. */
export const modelExtensions: readonly string[] = FORMATS.flatMap(({ extensions }) => extensions);

/** @throws ModelError unless `foreign` is null. */
function refuse(name: string, foreign: ForeignFormat | null): void {
  if (foreign === null) return;
  const { what, cure = `Export it as glTF (.glb), or as ${OTHERS}.` } = foreign;
  throw new ModelError('bad-model', `It is ${what}, which cannot be shown: ${name}.`, { advice: cure });
}

const OTHERS = FORMATS.slice(1)
  .map(({ name }) => name)
  .join(', ')
  .replace(/, (\w+)$/, ' or $1');

/** A media type without its parameters, or a word, as in the table. */
const essence = (type: string): string => (type.split(';', 1)[0] ?? '').trim().toLowerCase();

function startsWith(bytes: Uint8Array, text: string): boolean {
  return Array.from(text).every((character, i) => bytes[i] === character.charCodeAt(0));
}

/** The first character of a UTF-8 text that is neither white space nor a byte order mark. */
function firstCharacter(bytes: Uint8Array): string {
  return new TextDecoder().decode(bytes.subarray(0, 256)).trimStart().charAt(0);
}

/**
 * Whether each of the first lines begins with a word of OBJ files, and one of them is a vertex, a name or a library.
 */
function isObj(bytes: Uint8Array): boolean {
  const start = new TextDecoder().decode(bytes.subarray(0, 4096)).split(/\r?\n|\r/);
  if (bytes.byteLength > 4096) start.pop(); // cut in the middle
  const words = start.map((line) => line.trim().split(/\s/, 1)[0] ?? '');
  const known = words.every((word) => /^(v[tnp]?|f|o|g|s|l|p|usemtl|mtllib|)$/.test(word) || word.startsWith('#'));
  return known && words.some((word) => /^(v|o|g|mtllib)$/.test(word));
}

/** A format that people bring and that cannot be read, for messages. */
interface ForeignFormat {
  /** Such as `an FBX file`. */
  readonly what: string;
  /** What to do about it, as a sentence; by default it is to be exported in a supported format. */
  readonly cure?: string;
}

const FBX: ForeignFormat = { what: 'an FBX file' };
const BLEND: ForeignFormat = { what: 'a Blender file (BLEND)' };
const COLLADA: ForeignFormat = { what: 'a COLLADA file (DAE)' };
const USD: ForeignFormat = { what: 'a USD file' };
const ARCHIVE: ForeignFormat = { what: 'an archive', cure: 'Unpack it, and use the model in it.' };
// Many servers answer with a web page when a file is missing.
const WEB_PAGE: ForeignFormat = { what: 'a web page or XML, not a model', cure: 'Check the address.' };

const EXTENSIONS: Readonly<Record<string, ForeignFormat>> = {
  fbx: FBX,
  blend: BLEND,
  dae: COLLADA,
  usd: USD,
  usda: USD,
  usdc: USD,
  usdz: USD,
  zip: ARCHIVE,
};

/** Beginnings that no other format has, as Latin-1. */
const BEGINNINGS: readonly (readonly [text: string, format: ForeignFormat])[] = [
  ['Kaydara FBX Binary', FBX],
  ['; FBX', FBX],
  ['BLENDER', BLEND],
  ['#usda', USD],
  ['PXR-USDC', USD],
  ['PK\x03\x04', ARCHIVE],
  ['\x1f\x8b', ARCHIVE],
];

/** Recognised by the first bytes, then by the extension (lower case, without the dot); null if unknown. */
function foreignContent(bytes: Uint8Array, extension: string): ForeignFormat | null {
  const start = new TextDecoder('latin1').decode(bytes.subarray(0, 2048));
  const known = BEGINNINGS.find(([text]) => start.startsWith(text));
  // A USDZ file is an archive.
  if (known) return known[1] === ARCHIVE ? (foreignExtension(extension) ?? ARCHIVE) : known[1];
  // A byte order mark of UTF-8 reads as these three characters.
  const markup = start.replace(/^ï»¿/, '').trimStart();
  if (!markup.startsWith('<')) return null;
  return /<COLLADA\b/.test(markup) ? COLLADA : WEB_PAGE;
}

/** @param extension lower case, without the dot. */
const foreignExtension = (extension: string): ForeignFormat | null =>
  Object.hasOwn(EXTENSIONS, extension) ? (EXTENSIONS[extension] ?? null) : null;
