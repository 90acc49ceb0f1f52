// Reads a text from a PNG file that may come from a stranger: nothing is taken from a file that is
// not whole, and no length that it states is believed.
import { checksum, LONGEST_MARKUP, MARKUP_KEYWORD, SIGNATURE, textHead } from './chunks.js';

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
export function textIn(png: Uint8Array, keyword: string): string {
  const start = new TextEncoder().encode(`iTXt${textHead(keyword)}`);
  const chunk = textChunk(png, start);
  // Before the checksum, which takes 5 ms a megabyte.
  if (chunk.length > MOST_TEXT_BYTES) throw new PngTextError('too-large');
  const summed = chunk.subarray(0, -4);
  const sum = new DataView(chunk.buffer, chunk.byteOffset + summed.length).getInt32(0);
  if (sum !== checksum(summed)) throw new PngTextError('damaged');
  const text = decoded(summed.subarray(start.length));
  if (text.length > LONGEST_MARKUP) throw new PngTextError('too-large');
  return text;
}

const TYPE_LENGTH = 4;
const END = 0x49454e44; // IEND

/**
 * The one chunk that begins so, from its type to its checksum, in a whole file. A file may have millions
 * of chunks.
 */
function textChunk(png: Uint8Array, start: Uint8Array): Uint8Array {
  if (!SIGNATURE.every((byte, i) => png[i] === byte)) throw new PngTextError('none');
  const view = new DataView(png.buffer, png.byteOffset, png.byteLength);
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
    if (at - from >= start.length + 4 && start.every((byte, i) => png[from + i] === byte)) {
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
