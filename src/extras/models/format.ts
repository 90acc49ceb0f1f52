// Finds the format of a file's bytes. The content decides, then the element's `type`, the file
// extension and the media type. A new format is a row here and one in phong/model/format-names.ts.
import { FORMAT_NAMES, type FormatNames } from '../../phong/model/format-names.js';
import { ModelError } from '../../phong/model/model.js';
import { isBinaryStl, isTextStl } from './stl/stl-kind.js';

/**
 * Whether the bytes are those of a format and no other. In the order in which they are tested: the
 * strictest first.
 */
const CONTENT: Readonly<Record<keyof typeof FORMAT_NAMES, (bytes: Uint8Array) => boolean>> = {
  gltf: (bytes) => /^(glTF|(ï»¿)?\s*\{)/.test(latin1(bytes, 256)),
  ply: (bytes) => /^ply[\r\n]/.test(latin1(bytes, 4)),
  stl: (bytes) => isTextStl(bytes) || isBinaryStl(bytes),
  obj: isObj,
};

const FORMATS: readonly FormatNames[] = Object.values(FORMAT_NAMES);

/** What is known about a file besides its bytes. */
interface FormatHints {
  /** What the element's `type` says: a word such as `obj` or a media type; empty for nothing. */
  readonly type?: string;
  /** The media type that came with the file; empty for none. */
  readonly mediaType?: string;
  /** The whole address, for the extension; by default the name. */
  readonly address?: string;
}

/** @param name for messages. @throws ModelError `bad-model` that says what the file seems to be. */
export function formatOf(
  name: string,
  bytes: Uint8Array,
  { type = '', mediaType = '', address = name }: FormatHints = {},
): FormatNames {
  if (bytes.byteLength === 0) throw new ModelError('bad-model', `The model is empty: ${name}.`);
  const extension = /\.([a-z0-9]+)(?:[?#].*)?$/i.exec(address)?.[1]?.toLowerCase() ?? '';
  const byContent = (Object.keys(CONTENT) as (keyof typeof CONTENT)[]).find((key) =>
    CONTENT[key](bytes),
  );
  if (byContent !== undefined) return FORMAT_NAMES[byContent];
  const byType = (written: string) =>
    FORMATS.find(({ types, otherTypes }) => [...types, ...otherTypes].includes(essence(written)));
  const foreign = FOREIGN.find(({ start }) => start.test(latin1(bytes, 64)));
  if (foreign !== undefined) {
    const fact = `It is ${foreign.what}, which cannot be shown: ${name}.`;
    throw new ModelError('bad-model', fact, { advice: foreign.cure });
  }
  const byHint =
    byType(type) ??
    FORMATS.find(({ extensions }) => extensions.includes(extension)) ??
    byType(mediaType);
  if (byHint !== undefined) return byHint;
  const advice = `Export it as one that is: ${supportedFormats}.`;
  throw new ModelError('bad-model', `The format is not supported: ${name}.`, { advice });
}

/** For messages: names and extensions. */
export const supportedFormats = FORMATS.map(
  ({ name, extensions }) => `${name} (.${extensions.join(', .')})`,
).join(', ');

/** Extensions of files that can be shown, lower case. */
export const modelExtensions: readonly string[] = FORMATS.flatMap(({ extensions }) => extensions);

/** A media type without its parameters, or a word, as in the table. */
const essence = (type: string) => (type.split(';', 1)[0] ?? '').trim().toLowerCase();

/**
 * The first bytes, a character each: a browser's decoder reads windows-1252. A byte order mark of
 * UTF-8 is `ï»¿`.
 */
const latin1 = (bytes: Uint8Array, most: number) => String.fromCharCode(...bytes.subarray(0, most));

/**
 * Whether each of the first lines begins with a word of OBJ, and one of them is a vertex, a name or
 * a library.
 */
function isObj(bytes: Uint8Array): boolean {
  const start = new TextDecoder().decode(bytes.subarray(0, 4096)).split(/\r?\n|\r/);
  if (bytes.byteLength > 4096) {
    start.pop(); // cut in the middle
  }
  const words = start.map((line) => line.trim().split(/\s/, 1)[0] ?? '');
  const isKeyword = (word: string) => /^(v[tnp]?|f|o|g|s|l|p|usemtl|mtllib|#.*|)$/.test(word);
  return words.every(isKeyword) && words.some((word) => /^(v|o|g|mtllib)$/.test(word));
}

/** What comes in place of a model, by a beginning that no model has, as Latin-1. */
const FOREIGN = [
  // Many servers answer with a web page when a file is missing.
  { what: 'a web page or XML, not a model', cure: 'Check the address.', start: /^(ï»¿)?\s*</ },
  {
    what: 'an archive',
    cure: 'Unpack it, and use the model in it.',
    start: /^(PK\x03\x04|\x1f\x8b)/,
  },
] as const;
