// Reads a text from a PNG file that may come from a stranger: nothing is taken from a file that is
// not whole, and no length that it states is believed.
import { checksum, joined, LONGEST_MARKUP, MARKUP_KEYWORD, SIGNATURE } from './chunks.js';

/** Why a file holds no text that can be read. */
export type TextFault = 'none' | 'damaged' | 'too-large' | 'refused';

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

/** UTF-8 takes up to three bytes for a character of one code unit. */
const MOST_TEXT_BYTES = 3 * LONGEST_MARKUP;

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
  const found = chunksOf(png).filter(({ type, data }) => {
    const start = String.fromCharCode(...data.subarray(0, keyword.length + 1));
    return type === 'iTXt' && start === `${keyword}\0`;
  });
  const [one] = found;
  if (one === undefined) throw new PngTextError('none');
  if (found.length > 1 || one.sum !== checksum(one.summed)) throw new PngTextError('damaged');
  const { data } = one;
  const isCompressed = data[keyword.length + 1];
  const method = data[keyword.length + 2];
  const language = data.indexOf(0, keyword.length + 3);
  const translated = language < 0 ? -1 : data.indexOf(0, language + 1);
  if (translated < 0 || method !== 0 || isCompressed === undefined || isCompressed > 1) {
    throw new PngTextError('damaged');
  }
  const stored = data.subarray(translated + 1);
  if (stored.length > MOST_TEXT_BYTES) throw new PngTextError('too-large');
  const text = decoded(isCompressed === 1 ? await inflated(stored) : stored);
  if (text.length > LONGEST_MARKUP) throw new PngTextError('too-large');
  return text;
}

interface Chunk {
  readonly type: string;
  readonly data: Uint8Array;
  /** What the checksum is of. */
  readonly summed: Uint8Array;
  readonly sum: number;
}

/** Those with text, of a whole file. */
function chunksOf(png: Uint8Array): Chunk[] {
  if (!SIGNATURE.every((byte, i) => png[i] === byte)) throw new PngTextError('none');
  const view = new DataView(png.buffer, png.byteOffset, png.byteLength);
  const found: Chunk[] = [];
  for (let at = SIGNATURE.length; at + 12 <= png.length;) {
    const length = view.getUint32(at);
    const end = at + 12 + length;
    if (end > png.length) break;
    const type = String.fromCharCode(...png.subarray(at + 4, at + 8));
    if (type === 'IEND') return found;
    if (type === 'iTXt') {
      const summed = png.subarray(at + 4, end - 4);
      found.push({ type, data: summed.subarray(4), summed, sum: view.getInt32(end - 4) });
    }
    at = end;
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
