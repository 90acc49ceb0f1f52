// Reads a text from a PNG file that may come from a stranger: nothing is taken from a file that is
// not whole, and no length that it states is believed.
import { checksum, joined, LONGEST_MARKUP, MARKUP_KEYWORD, SIGNATURE } from './chunks.js';

/** Why a file holds no text that can be read. */
type TextFault = 'none' | 'damaged' | 'too-large' | 'refused';

export class PngTextError extends Error {
  readonly fault: TextFault;

  constructor(fault: TextFault) {
    super(SENTENCES[fault]);
    this.fault = fault;
  }
}

const SENTENCES: Readonly<Record<TextFault, string>> = {
  none: 'The picture holds no scene: only PNG files that a viewer saved do.',
  damaged: 'The picture holds no scene that can be read: the file is damaged.',
  'too-large': 'The picture holds a scene that is too large to open.',
  refused: "The page's policy refuses markup from files: allow trusted-types phong-viewer.",
};

/** Bytes of a file. A picture of 33 million pixels that do not compress has 134 million. */
const MOST_BYTES = 2 ** 28;

/** UTF-8 takes up to three bytes for a character of one code unit; some more for a chunk's head. */
const MOST_TEXT_BYTES = 3 * LONGEST_MARKUP + 1000;

/**
 * The markup of the scene that a viewer, a still or the command has saved in a PNG file.
 * @throws PngTextError if there is none that can be read.
 */
export async function markupIn(file: Blob | Uint8Array): Promise<string> {
  const size = file instanceof Blob ? file.size : file.length;
  if (size > MOST_BYTES) throw new PngTextError('too-large');
  const png = file instanceof Blob ? new Uint8Array(await file.arrayBuffer()) : file;
  return textIn(png, MARKUP_KEYWORD);
}

/** The text with this keyword. @throws PngTextError where there is none, or more than one. */
export async function textIn(png: Uint8Array, keyword: string): Promise<string> {
  const chunk = textChunk(png, keyword);
  // Before the checksum, which takes 5 ms a megabyte.
  if (chunk.length > MOST_TEXT_BYTES) throw new PngTextError('too-large');
  const summed = chunk.subarray(0, -4);
  const sum = new DataView(chunk.buffer, chunk.byteOffset + summed.length).getInt32(0);
  if (sum !== checksum(summed)) throw new PngTextError('damaged');
  const data = summed.subarray(TYPE_LENGTH + keyword.length + 1);
  const [isCompressed, method] = data;
  const language = data.indexOf(0, 2);
  const translated = language < 0 ? -1 : data.indexOf(0, language + 1);
  if (translated < 0 || method !== 0 || isCompressed === undefined || isCompressed > 1) {
    throw new PngTextError('damaged');
  }
  const stored = data.subarray(translated + 1);
  const text = decoded(isCompressed === 1 ? await inflated(stored) : stored);
  if (text.length > LONGEST_MARKUP) throw new PngTextError('too-large');
  return text;
}

const TYPE_LENGTH = 4;
const END = 0x49454e44; // IEND

/** From its type to its checksum, in a whole file. A file may have millions of chunks. */
function textChunk(png: Uint8Array, keyword: string): Uint8Array {
  if (!SIGNATURE.every((byte, i) => png[i] === byte)) throw new PngTextError('none');
  const view = new DataView(png.buffer, png.byteOffset, png.byteLength);
  const start = new TextEncoder().encode(`iTXt${keyword}\0`);
  let found: Uint8Array | undefined;
  let count = 0;
  for (let at = SIGNATURE.length; at + 12 <= png.length;) {
    const from = at + 4;
    const length = view.getUint32(at);
    at = from + TYPE_LENGTH + length + 4;
    if (at > png.length) break;
    if (view.getUint32(from) === END) {
      if (found === undefined) throw new PngTextError('none');
      if (count > 1) break;
      return found;
    }
    if (length > keyword.length && start.every((byte, i) => png[from + i] === byte)) {
      found = png.subarray(from, at);
      count += 1;
    }
  }
  throw new PngTextError('damaged');
}

function decoded(bytes: Uint8Array): string {
  try {
    return new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    throw new PngTextError('damaged');
  }
}

/** No more than the longest text is unpacked: a few bytes can claim gigabytes. */
async function inflated(bytes: Uint8Array): Promise<Uint8Array> {
  const packed = new Blob([new Uint8Array(bytes)]).stream();
  const reader = packed.pipeThrough(new DecompressionStream('deflate')).getReader();
  const parts: Uint8Array[] = [];
  let size = 0;
  for (;;) {
    const { done, value } = await reader.read().catch(() => {
      throw new PngTextError('damaged');
    });
    if (done) return joined(parts);
    size += value.length;
    if (size > MOST_TEXT_BYTES) {
      await reader.cancel().catch(() => undefined);
      throw new PngTextError('too-large');
    }
    parts.push(value);
  }
}
