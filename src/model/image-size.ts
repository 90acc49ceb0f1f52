// The number of pixels that an image file claims. Read from its headers, before a decoder allocates for them. Sizes are
// as stored: before any rotation. Only formats whose decoders allocate for that number and no other: in GIF, AVIF, BMP
// or SVG another place of the file can claim more.

export interface ImageSize {
  readonly width: number;
  readonly height: number;
}

/** The size of a PNG, JPEG, WebP or KTX2 image; null for other or broken files, and where two headers differ. */
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
  { at: 0, magic: '\x89PNG\r\n\x1a\n', read: pngSize },
  { at: 0, magic: '\xff\xd8\xff', read: jpegSize },
  {
    at: 1,
    magic: 'KTX 20',
    read: (view) => ({ width: view.getUint32(20, true), height: view.getUint32(24, true) }),
  },
  { at: 8, magic: 'WEBP', read: webpSize },
];

/** Before the pixels. No encoder writes as many. */
const MOST_CHUNKS = 1000;

function hasText(view: DataView, at: number, text: string): boolean {
  if (at + text.length > view.byteLength) return false;
  return Array.from(text).every((character, i) => view.getUint8(at + i) === character.charCodeAt(0));
}

/** The one IHDR chunk, which comes first. */
function pngSize(view: DataView): ImageSize | null {
  if (!hasText(view, 12, 'IHDR')) return null;
  for (let at = 33, i = 0; i < MOST_CHUNKS; i += 1) {
    if (hasText(view, at + 4, 'IDAT')) return { width: view.getUint32(16), height: view.getUint32(20) };
    if (hasText(view, at + 4, 'IHDR')) return null;
    at += 12 + view.getUint32(at);
  }
  return null;
}

/**
 * The one frame header (SOF0 to SOF15, but DHT, JPG and DAC, which lie between) before the first scan. A height of 0,
 * which a DNL segment would give later, is none.
 */
function jpegSize(view: DataView): ImageSize | null {
  let size: ImageSize | null = null;
  for (let at = 2, i = 0; i < MOST_CHUNKS; i += 1) {
    if (view.getUint8(at) !== 0xff) return null;
    const marker = view.getUint8(at + 1);
    if (marker === 0xff) {
      at += 1; // fill byte
      continue;
    }
    if (marker === 0xda || marker === 0xd9) return size;
    if (marker >= 0xc0 && marker <= 0xcf && marker !== 0xc4 && marker !== 0xc8 && marker !== 0xcc) {
      if (size !== null) return null;
      size = { width: view.getUint16(at + 7), height: view.getUint16(at + 5) };
    }
    const standsAlone = marker === 0x01 || (marker >= 0xd0 && marker <= 0xd8);
    at += 2 + (standsAlone ? 0 : view.getUint16(at + 2));
  }
  return null;
}

/** That of the canvas, if there is one: a still picture has the same, frames of an animation lie within it. */
function webpSize(view: DataView): ImageSize | null {
  let canvas: ImageSize | null = null;
  for (let at = 12, i = 0; i < MOST_CHUNKS; i += 1) {
    const start = at + 8;
    if (hasText(view, at, 'VP8X')) {
      if (canvas !== null) return null;
      canvas = { width: 1 + uint24(view, start + 4), height: 1 + uint24(view, start + 7) };
    }
    if (hasText(view, at, 'ANMF')) {
      const right = 2 * uint24(view, start) + 1 + uint24(view, start + 6);
      const bottom = 2 * uint24(view, start + 3) + 1 + uint24(view, start + 9);
      return canvas !== null && right <= canvas.width && bottom <= canvas.height ? canvas : null;
    }
    const frame = hasText(view, at, 'VP8L')
      ? losslessSize(view.getUint32(start + 1, true))
      : hasText(view, at, 'VP8 ')
        ? {
            width: view.getUint16(start + 6, true) & 0x3fff,
            height: view.getUint16(start + 8, true) & 0x3fff,
          }
        : null;
    at = start + 2 * Math.ceil(view.getUint32(at + 4, true) / 2);
    if (frame === null) continue;
    return canvas === null || (canvas.width === frame.width && canvas.height === frame.height) ? frame : null;
  }
  return null;
}

const losslessSize = (bits: number): ImageSize => ({
  width: 1 + (bits & 0x3fff),
  height: 1 + ((bits >>> 14) & 0x3fff),
});

const uint24 = (view: DataView, at: number): number => view.getUint16(at, true) + view.getUint8(at + 2) * 0x10000;
