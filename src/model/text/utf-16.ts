// Text files in UTF-16, as some editors and exporters on Windows write them, become UTF-8, which every reader expects.
import type { ModelBudget } from '../model-budget.js';
import type { Slices } from '../slices.js';

const LITTLE_ENDIAN = [0xff, 0xfe];
const BIG_ENDIAN = [0xfe, 0xff];

/** Bytes that are decoded at once. */
const PIECE = 2 ** 18;

/**
 * The same text in UTF-8 if the bytes begin with the byte order mark of UTF-16; otherwise the bytes themselves.
 * @throws ModelError `too-large`: UTF-16 counts as text whatever its format.
 */
export async function asUtf8(
  bytes: Uint8Array<ArrayBuffer>,
  budget: ModelBudget,
  slices: Slices,
): Promise<Uint8Array<ArrayBuffer>> {
  const encoding = beginsWith(bytes, LITTLE_ENDIAN) ? 'utf-16le' : beginsWith(bytes, BIG_ENDIAN) ? 'utf-16be' : null;
  if (encoding === null) return bytes;
  budget.add({ text: bytes.byteLength });
  // Two bytes become three at most, and four stay four.
  const text = new Uint8Array(Math.ceil(bytes.length * 1.5) + 3);
  const [decoder, encoder] = [new TextDecoder(encoding), new TextEncoder()];
  let length = 0;
  for (let from = 0; from < bytes.length; from += PIECE) {
    const piece = bytes.subarray(from, from + PIECE);
    const stream = from + PIECE < bytes.length;
    length += encoder.encodeInto(decoder.decode(piece, { stream }), text.subarray(length)).written;
    await slices.pauseIfDue();
  }
  return text.subarray(0, length);
}

const beginsWith = (bytes: Uint8Array, mark: readonly number[]): boolean => mark.every((byte, i) => bytes[i] === byte);
