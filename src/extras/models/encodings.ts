// Bytes out of base64, data: URIs and UTF-16. The first two in slices and mostly in place: files of
// hundreds of megabytes are never strings.
import { requireAtMost } from '../../phong/model/budget.js';
import { ModelError } from '../../phong/model/model.js';
import type { FileBytes } from './model-reader.js';
import type { Slices } from './slices.js';
import { isDataUri } from '../../phong/fields/file-names.js';

/** Bytes or characters between two looks at the clock. */
const SLICE = 2 ** 16;

/**
 * Percent-encoded or base64. Decoded here, because fetching one needs `connect-src data:`, which a
 * strict CSP refuses. The type is without parameters, in lower case; by default `text/plain`.
 * @throws ModelError `bad-model`.
 */
export async function decodeDataUri(uri: string, slices: Slices): Promise<FileBytes> {
  const comma = uri.indexOf(',');
  if (!isDataUri(uri) || comma < 0) {
    throw new ModelError('bad-model', 'A data: URI has no comma before its data.');
  }
  // A fragment identifier is not part of the data.
  const end = uri.indexOf('#', comma);
  const { type, base64 } = dataHeader(uri.slice(0, comma));
  const octets = await octetsOf(uri.slice(comma + 1, end < 0 ? uri.length : end), slices);
  return { type, bytes: base64 ? await fromBase64(octets, slices) : octets };
}

/** What stands before the comma. */
export function dataHeader(header: string) {
  const [type, ...parameters] = header.slice('data:'.length).split(';');
  return {
    type: (type ?? '').trim().toLowerCase() || 'text/plain',
    base64: parameters.at(-1)?.trim().toLowerCase() === 'base64',
  };
}

async function octetsOf(text: string, slices: Slices): Promise<Uint8Array<ArrayBuffer>> {
  const bytes = new Uint8Array(text.length);
  let length = 0;
  for (let at = 0; at < text.length;) {
    for (const end = Math.min(at + SLICE, text.length); at < end; length += 1) {
      const escaped = text[at] === '%' && /^[0-9a-f]{2}$/i.test(text.slice(at + 1, at + 3));
      bytes[length] = escaped ? parseInt(text.slice(at + 1, at + 3), 16) : text.charCodeAt(at);
      at += escaped ? 3 : 1;
    }
    await slices.pauseIfDue();
  }
  return bytes.subarray(0, length);
}

/** Values of the characters; what is skipped is {@link SKIPPED}, what is wrong {@link WRONG}. */
const SKIPPED = 64;
const WRONG = 65;
const VALUES = /* @__PURE__ */ (() => {
  const values = new Uint8Array(256).fill(WRONG);
  const alphabet = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/';
  for (let value = 0; value < 64; value += 1) {
    values[alphabet.charCodeAt(value)] = value;
  }
  // White space, padding, and the backslash that JSON allows before a slash.
  for (const character of '\t\n\f\r =\\') {
    values[character.charCodeAt(0)] = SKIPPED;
  }
  return values;
})();

/** The data behind base64, written over it. @throws ModelError `bad-model` for anything else. */
export async function fromBase64(
  text: Uint8Array<ArrayBuffer>,
  slices: Slices,
): Promise<Uint8Array<ArrayBuffer>> {
  const state = { bits: 0, count: 0, length: 0 };
  for (let from = 0; from < text.length; from += SLICE) {
    decode(text, from, Math.min(from + SLICE, text.length), state);
    await slices.pauseIfDue();
  }
  if (state.count === 6) throw broken();
  return text.subarray(0, state.length);
}

/**
 * A function of its own: in the loop above it took twice as long. `count`: bits that are not
 * written yet.
 */
function decode(
  text: Uint8Array,
  from: number,
  to: number,
  state: { bits: number; count: number; length: number },
): void {
  let { bits, count, length } = state;
  for (let i = from; i < to; i += 1) {
    const value = VALUES[text[i]!]!;
    if (value >= SKIPPED) {
      if (value === SKIPPED) continue;
      throw broken();
    }
    bits = ((bits << 6) | value) & 0xfff;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    text[length] = bits >> count;
    length += 1;
  }
  Object.assign(state, { bits, count, length });
}

const broken = () => new ModelError('bad-model', 'A data: URI holds broken base64.');

/** Most bytes of a text in UTF-16, 8 MiB: it is decoded in one task, in 17 to 39 ms. */
const UTF16_LIMIT = 2 ** 23;

/**
 * The same text in UTF-8, which every reader expects, if the bytes begin with the byte order mark
 * of UTF-16, as some editors and exporters on Windows write it; otherwise the bytes themselves.
 * @throws ModelError `too-large`.
 */
export function asUtf8(bytes: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> {
  const [first, second] = bytes;
  const isLittleEndian = first === 0xff && second === 0xfe;
  const isBigEndian = first === 0xfe && second === 0xff;
  if (!isLittleEndian && !isBigEndian) return bytes;
  requireAtMost(bytes.byteLength, UTF16_LIMIT, 'bytes of text in UTF-16');
  const decoder = new TextDecoder(isLittleEndian ? 'utf-16le' : 'utf-16be');
  return new TextEncoder().encode(decoder.decode(bytes));
}
