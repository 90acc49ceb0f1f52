// Text files in UTF-16, as some editors and exporters on Windows write them, become UTF-8, which every reader expects.

const LITTLE_ENDIAN = [0xff, 0xfe];
const BIG_ENDIAN = [0xfe, 0xff];

/** The same text in UTF-8 if the bytes begin with the byte order mark of UTF-16; otherwise the bytes themselves. */
export function asUtf8(bytes: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> {
  const encoding = beginsWith(bytes, LITTLE_ENDIAN)
    ? 'utf-16le'
    : beginsWith(bytes, BIG_ENDIAN)
      ? 'utf-16be'
      : null;
  return encoding === null ? bytes : new TextEncoder().encode(new TextDecoder(encoding).decode(bytes));
}

const beginsWith = (bytes: Uint8Array, mark: readonly number[]): boolean =>
  mark.every((byte, i) => bytes[i] === byte);
