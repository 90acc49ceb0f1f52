// The number of pixels that an image file claims. Read from its header, before a decoder allocates for them. Sizes are
// as stored: before any rotation. Knows the formats that browsers decode, and KTX2.

export interface ImageSize {
  readonly width: number;
  readonly height: number;
}

/** The size of a PNG, JPEG, WebP, AVIF, GIF, BMP or KTX2 image; null for other or broken files. */
export function imageSize(file: Uint8Array): ImageSize | null {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  const reader = READERS.find(({ at, magic }) => hasText(view, at, magic));
  try {
    const size = reader?.read(view) ?? null;
    return size && size.width > 0 && size.height > 0 ? size : null;
  } catch {
    return null; // a header beyond the end of the file
  }
}

interface Reader {
  readonly at: number;
  readonly magic: string;
  readonly read: (view: DataView) => ImageSize | null;
}

const READERS: readonly Reader[] = [
  {
    at: 0,
    magic: '\x89PNG\r\n\x1a\n',
    read: (view) => ({ width: view.getUint32(16), height: view.getUint32(20) }),
  },
  { at: 0, magic: '\xff\xd8\xff', read: jpegSize },
  {
    at: 1,
    magic: 'KTX 20',
    read: (view) => ({ width: view.getUint32(20, true), height: view.getUint32(24, true) }),
  },
  { at: 8, magic: 'WEBP', read: webpSize },
  { at: 4, magic: 'ftyp', read: avifSize },
  {
    at: 0,
    magic: 'GIF8',
    read: (view) => ({ width: view.getUint16(6, true), height: view.getUint16(8, true) }),
  },
  {
    at: 0,
    magic: 'BM',
    // The height is negative if the first row is the top.
    read: (view) => ({ width: view.getInt32(18, true), height: Math.abs(view.getInt32(22, true)) }),
  },
];

function hasText(view: DataView, at: number, text: string): boolean {
  if (at + text.length > view.byteLength) return false;
  return Array.from(text).every((character, i) => view.getUint8(at + i) === character.charCodeAt(0));
}

/** Segments up to the frame header (SOF0 to SOF15, but DHT, JPG and DAC, which lie between). */
function jpegSize(view: DataView): ImageSize | null {
  for (let at = 2; ;) {
    if (view.getUint8(at) !== 0xff) return null;
    const marker = view.getUint8(at + 1);
    if (marker === 0xff) {
      at += 1; // fill byte
      continue;
    }
    const frame = marker >= 0xc0 && marker <= 0xcf && marker !== 0xc4 && marker !== 0xc8 && marker !== 0xcc;
    if (frame) return { width: view.getUint16(at + 7), height: view.getUint16(at + 5) };
    const standsAlone = marker === 0x01 || (marker >= 0xd0 && marker <= 0xd8);
    at += 2 + (standsAlone ? 0 : view.getUint16(at + 2));
  }
}

function webpSize(view: DataView): ImageSize | null {
  if (hasText(view, 12, 'VP8X')) return { width: 1 + uint24(view, 24), height: 1 + uint24(view, 27) };
  if (hasText(view, 12, 'VP8L')) {
    const bits = view.getUint32(21, true);
    return { width: 1 + (bits & 0x3fff), height: 1 + ((bits >>> 14) & 0x3fff) };
  }
  if (!hasText(view, 12, 'VP8 ')) return null;
  return { width: view.getUint16(26, true) & 0x3fff, height: view.getUint16(28, true) & 0x3fff };
}

const uint24 = (view: DataView, at: number): number =>
  view.getUint16(at, true) + view.getUint8(at + 2) * 0x10000;

/**
 * The largest of the sizes that the file's items have (`ispe` properties): alpha, thumbnail and tiles have their own.
 */
function avifSize(view: DataView): ImageSize | null {
  const size = { width: 0, height: 0 };
  const read = (start: number, end: number): void => {
    for (let at = start; at + 8 <= end;) {
      const length = view.getUint32(at);
      const inner = at + 8;
      // 0: up to the end. 1: a 64-bit length, which no header needs.
      const next = length === 0 ? end : Math.min(at + length, end);
      if (length === 1 || (length > 0 && length < 8)) return;
      if (hasText(view, at + 4, 'meta')) read(inner + 4, next);
      else if (hasText(view, at + 4, 'iprp') || hasText(view, at + 4, 'ipco')) read(inner, next);
      else if (hasText(view, at + 4, 'ispe')) {
        size.width = Math.max(size.width, view.getUint32(inner + 4));
        size.height = Math.max(size.height, view.getUint32(inner + 8));
      }
      at = next;
    }
  };
  read(0, view.byteLength);
  return size;
}
