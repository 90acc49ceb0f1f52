// Text files in UTF-16, as some editors and exporters on Windows write them, become UTF-8, which every reader expects.
import type { Slices } from '../slices.js';

const LITTLE_ENDIAN = [0xff, 0xfe];
const BIG_ENDIAN = [0xfe, 0xff];

/** Bytes that are converted at once. */
const PIECE = 2 ** 18;

/** The same text in UTF-8 if the bytes begin with the byte order mark of UTF-16; otherwise the bytes themselves. */
export async function asUtf8(
  bytes: Uint8Array<ArrayBuffer>,
  slices: Slices,
): Promise<Uint8Array<ArrayBuffer>> {
  const little = beginsWith(bytes, LITTLE_ENDIAN);
  if (!little && !beginsWith(bytes, BIG_ENDIAN)) return bytes;
  const decoder = new TextDecoder(little ? 'utf-16le' : 'utf-16be');
  const encoder = new TextEncoder();
  // Two bytes become three at most.
  const utf8 = new Uint8Array(Math.ceil(1.5 * bytes.length) + 3);
  let length = 0;
  for (let at = 0; at < bytes.length; at += PIECE) {
    const text = decoder.decode(bytes.subarray(at, at + PIECE), { stream: at + PIECE < bytes.length });
    length += encoder.encodeInto(text, utf8.subarray(length)).written;
    await slices.pauseIfDue();
  }
  return utf8.subarray(0, length);
}

const beginsWith = (bytes: Uint8Array, mark: readonly number[]): boolean =>
  mark.every((byte, i) => bytes[i] === byte);
