// Which loader reads these bytes? The content decides, then the file extension. A new format is one more row in the table; its loader
// is a separate chunk, fetched with the first file that needs it.
import { lazyCode } from '../lazy-code.js';
import { ModelError, type Model } from './model.js';

export interface ModelSource {
  readonly url: URL;
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly signal: AbortSignal;
  /** Downloads a file that the model names, if it is allowed to name it. */
  readonly linked: (uri: string) => Promise<Uint8Array<ArrayBuffer>>;
}

/** Reads a whole model, or throws and leaks nothing. An error other than ModelError means a broken file. */
export type ModelReader = (source: ModelSource) => Promise<Model>;

interface Format {
  readonly name: string;
  readonly extensions: readonly string[];
  readonly matches: (bytes: Uint8Array) => boolean;
  readonly reader: () => Promise<ModelReader>;
}

const gltfCode = lazyCode(() => import('./gltf/read-gltf.js'), 'glTF models');

const FORMATS: readonly Format[] = [
  {
    name: 'glTF',
    extensions: ['glb', 'gltf'],
    matches: (bytes) => startsWith(bytes, 'glTF') || firstCharacter(bytes) === '{',
    reader: async () => (await gltfCode()).readGltf,
  },
];

/** The format of a file. Throws a `bad-model` error that says what the file seems to be. */
export function formatOf(url: URL, bytes: Uint8Array): Format {
  const byContent = FORMATS.find((format) => format.matches(bytes));
  if (byContent) return byContent;
  if (bytes.byteLength === 0) throw new ModelError('bad-model', `${nameOf(url)} is empty.`);
  // Many servers answer with a web page when a file is missing.
  if (firstCharacter(bytes) === '<') {
    throw new ModelError(
      'bad-model',
      `${nameOf(url)} holds a web page or XML, not a model. Check the address.`,
    );
  }
  const extension = /\.([a-z0-9]+)$/i.exec(url.pathname)?.[1]?.toLowerCase() ?? '';
  const byName = FORMATS.find((format) => format.extensions.includes(extension));
  if (byName) return byName;
  const known = FORMATS.map((format) => `${format.name} (.${format.extensions.join(', .')})`).join(', ');
  throw new ModelError('bad-model', `${nameOf(url)} is not in a supported format: ${known}.`);
}

/** An address for messages, without the content of a data: URI. */
export const nameOf = (url: URL): string => (url.protocol === 'data:' ? 'the data: URI' : url.href);

function startsWith(bytes: Uint8Array, text: string): boolean {
  return Array.from(text).every((character, i) => bytes[i] === character.charCodeAt(0));
}

/** The first character of a UTF-8 text that is neither white space nor a byte order mark. */
function firstCharacter(bytes: Uint8Array): string {
  return new TextDecoder().decode(bytes.subarray(0, 256)).trimStart().charAt(0);
}
