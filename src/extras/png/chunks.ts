// Chunks of PNG files, and the markup of a scene in one of them: an `iTXt` chunk after the header.
// Runs in Node too.

/** Names the chunk that holds a scene's markup. */
export const MARKUP_KEYWORD = 'phong-viewer';

/** Characters of markup in a file, as the playground's limit: 1,000 elements have about 100,000. */
export const LONGEST_MARKUP = 100_000;

/** The PNG with a scene's markup in it, or as it is where that is too long to be opened again. */
export const withMarkup = (png: Uint8Array<ArrayBuffer>, markup: string): Uint8Array<ArrayBuffer> =>
  markup.length > LONGEST_MARKUP ? png : withText(png, MARKUP_KEYWORD, markup);

/** The file's first eight bytes. */
export const SIGNATURE = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a);

/** Signature and header, which come first in each file. */
const HEADER_END = 33;

export function chunk(type: string, data: Uint8Array): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(data.length + 12);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, data.length);
  bytes.set(
    Array.from(type, (letter) => letter.charCodeAt(0)),
    4,
  );
  bytes.set(data, 8);
  view.setInt32(bytes.length - 4, checksum(bytes.subarray(4, -4)));
  return bytes;
}

/** CRC-32 of type and data. */
export function checksum(bytes: Uint8Array): number {
  let crc = -1;
  for (const byte of bytes) {
    crc = CRC[(crc ^ byte) & 0xff]! ^ (crc >>> 8);
  }
  return ~crc;
}

const CRC = /* @__PURE__ */ Int32Array.from({ length: 256 }, (_, i) => {
  let crc = i;
  for (let bit = 0; bit < 8; bit++) {
    crc = (crc & 1) === 1 ? 0xedb88320 ^ (crc >>> 1) : crc >>> 1;
  }
  return crc;
});

/**
 * What stands before the text in its chunk: the keyword, which is ASCII, and its end; not compressed, by
 * method 0; no language; no translated keyword.
 */
export const textHead = (keyword: string): string => `${keyword}\0\0\0\0\0`;

/** The PNG with this text in it. */
export function withText(png: Uint8Array, keyword: string, text: string): Uint8Array<ArrayBuffer> {
  const data = new TextEncoder().encode(textHead(keyword) + text);
  return joined([png.subarray(0, HEADER_END), chunk('iTXt', data), png.subarray(HEADER_END)]);
}

export function joined(parts: readonly Uint8Array[]): Uint8Array<ArrayBuffer> {
  const all = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}
