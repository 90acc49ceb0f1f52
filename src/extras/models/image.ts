// The images of a model as textures: decoded without colour conversion and without
// premultiplication, first row on top. The browser decodes all but KTX2. No blob: address is
// fetched, as a strict CSP requires.
import { LinearFilter, NearestFilter, NoColorSpace, Texture } from 'three';
import { decodeKtx2, isKtx2 } from './ktx2/decode-ktx2.js';
import { LIMITS } from '../../phong/model/limits.js';
import { type FileBytes, type ModelSource, requireDecoders } from './model-reader.js';
import { Slices } from './slices.js';
import { IMAGE_SIDE_LIMIT } from './limits.js';
import { turnsOf } from './turns.js';

/**
 * Pixels that are decoded at once, over all models. A decoder takes up to three times the memory of
 * its result.
 */
const PIXELS_AT_ONCE = 2 ** 24;
const inTurn = /* @__PURE__ */ turnsOf(PIXELS_AT_ONCE);

export type Sampler = Readonly<Pick<Texture, 'magFilter' | 'minFilter' | 'wrapS' | 'wrapT'>>;

/** Texture coordinates are multiplied by `scale`, then `offset` is added. */
interface Placement {
  readonly scale: readonly [u: number, v: number];
  readonly offset: readonly [u: number, v: number];
}

const AS_IT_IS: Placement = { scale: [1, 1], offset: [0, 0] };

/** An image that is decoded once, however many textures use it. */
interface Image {
  readonly decoded: Promise<{ readonly pixels: number; readonly bitmap: ImageBitmap } | null>;
  /** By sampler and placement. */
  readonly textures: Map<string, Promise<Texture | null>>;
  readonly samplers: Set<string>;
  source?: Texture<ImageBitmap>['source'];
}

/** Textures of one image with one sampler and placement are one object. */
export class ImageTextures {
  readonly #source: ModelSource;
  readonly #images = new Map<unknown, Image>();

  /**
   * The source's budget gets the pixels of every image, once for each sampler: three.js uploads it
   * for each.
   */
  constructor(source: ModelSource) {
    this.#source = source;
  }

  /**
   * Null for an image that is missing or broken, which is reported by `name`. @param key equal for
   * equal images.
   */
  of(
    key: unknown,
    name: string,
    read: () => Promise<FileBytes>,
    sampler: Sampler,
    placement = AS_IT_IS,
  ): Promise<Texture | null> {
    const image = this.#images.get(key) ?? {
      decoded: this.#decode(name, read),
      textures: new Map<string, Promise<Texture | null>>(),
      samplers: new Set<string>(),
    };
    this.#images.set(key, image);
    const use = JSON.stringify([sampler, placement]);
    const texture = image.textures.get(use) ?? this.#create(image, sampler, placement);
    image.textures.set(use, texture);
    return texture;
  }

  /** Waits for images that are being decoded, then closes all images. */
  async close(): Promise<void> {
    for (const image of await Promise.allSettled(
      Array.from(this.#images.values(), ({ decoded }) => decoded),
    )) {
      if (image.status === 'fulfilled') {
        image.value?.bitmap.close();
      }
    }
  }

  #decode(name: string, read: () => Promise<FileBytes>): Image['decoded'] {
    const { optional, budget, signal, decodeImage } = this.#source;
    return optional(name, read, async (file) => {
      const size = imageSize(file.bytes);
      if (!size) {
        throw new Error(
          'is no PNG, JPEG, WebP or KTX2 image, or its headers contradict each other',
        );
      }
      const pixels = size.width * size.height;
      if (pixels > LIMITS.imagePixels) {
        const [has, most] = [pixels, LIMITS.imagePixels].map((count) => count.toLocaleString('en'));
        throw new Error(`has ${has!} pixels; at most ${most!} can be shown`);
      }
      await requireFewScans(file.bytes, new Slices(signal));
      const isPacked = isKtx2(file.bytes);
      budget.add({ pixels });
      const scale = scaledDown(size);
      const bitmap = await inTurn(Math.min(pixels, PIXELS_AT_ONCE), () => {
        signal.throwIfAborted(); // while it waited
        if (isPacked) {
          requireDecoders(this.#source, 'KTX2');
        }
        return (
          decodeImage?.(file) ??
          (isPacked ? decodeKtx2(file.bytes, scale, signal) : decodeByBrowser(file, size, scale))
        );
      });
      return { pixels, bitmap };
    });
  }

  async #create(
    image: Image,
    sampler: Sampler,
    { scale, offset }: Placement,
  ): Promise<Texture | null> {
    const decoded = await image.decoded;
    if (decoded === null) return null;
    const texture = new Texture(decoded.bitmap);
    const uploaded = JSON.stringify(sampler);
    if (image.samplers.size > 0 && !image.samplers.has(uploaded)) {
      this.#source.budget.add({ pixels: decoded.pixels });
    }
    image.samplers.add(uploaded);
    texture.source = image.source ??= texture.source;
    Object.assign(texture, sampler, {
      generateMipmaps: sampler.minFilter !== NearestFilter && sampler.minFilter !== LinearFilter,
      colorSpace: NoColorSpace,
      flipY: false,
      // Or the browser would hold the copies of all images until the first frame is complete.
      onUpdate: this.#source.flush ?? null,
      needsUpdate: true,
    });
    texture.repeat.set(...scale);
    texture.offset.set(...offset);
    texture.updateMatrix();
    return texture;
  }
}

async function decodeByBrowser(
  { bytes, type }: FileBytes,
  { width, height }: ImageSize,
  scale: ImageBitmapOptions,
): Promise<ImageBitmap> {
  const options = { premultiplyAlpha: 'none', colorSpaceConversion: 'none', ...scale } as const;
  const bitmap = await createImageBitmap(new Blob([bytes], { type }), options).catch(
    (cause: unknown) => {
      throw new Error('cannot be decoded by this browser', { cause });
    },
  );
  // Photographs can be turned by a quarter. Others have the size that was counted, or are not
  // shown.
  const sides = [bitmap.width, bitmap.height];
  if (scale.resizeWidth !== undefined || (sides.includes(width) && sides.includes(height))) {
    return bitmap;
  }
  bitmap.close();
  throw new Error(
    `has ${sides.join(' × ')} pixels, but ${String(width)} × ${String(height)} in its header`,
  );
}

function scaledDown({ width, height }: ImageSize): ImageBitmapOptions {
  const factor = IMAGE_SIDE_LIMIT / Math.max(width, height);
  if (factor >= 1) return {};
  return {
    resizeWidth: Math.max(Math.floor(width * factor), 1),
    resizeHeight: Math.max(Math.floor(height * factor), 1),
    resizeQuality: 'medium',
  };
}

/** In pixels, as stored: before any rotation. */
interface ImageSize {
  readonly width: number;
  readonly height: number;
}

/**
 * The size that a PNG, JPEG, WebP or KTX2 image claims in its headers; null for other or broken
 * files, and where two headers differ. Read before a decoder allocates for it. Only formats whose
 * decoders allocate for that number and no other: in GIF, AVIF, BMP or SVG another place of the
 * file can claim more.
 */
export function imageSize(file: Uint8Array): ImageSize | null {
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  const [, , read] = READERS.find(([at, magic]) => hasText(view, at, magic)) ?? [];
  try {
    const size = read?.(view) ?? null;
    return size && size.width > 0 && size.height > 0 ? size : null;
  } catch {
    return null; // a header beyond the end of the file
  }
}

const READERS: readonly (readonly [
  at: number,
  magic: string,
  read: (view: DataView) => ImageSize | null,
])[] = [
  [0, '\x89PNG\r\n\x1a\n', pngSize],
  [0, '\xff\xd8\xff', jpegSize],
  [1, 'KTX 20', (view) => ({ width: view.getUint32(20, true), height: view.getUint32(24, true) })],
  [8, 'WEBP', webpSize],
];

/** Before the pixels. No encoder writes as many. */
const MOST_CHUNKS = 1000;

function hasText(view: DataView, at: number, text: string): boolean {
  if (at + text.length > view.byteLength) return false;
  const bytes = new Uint8Array(view.buffer, view.byteOffset + at, text.length);
  return String.fromCharCode(...bytes) === text;
}

/** The one IHDR chunk, which comes first. */
function pngSize(view: DataView): ImageSize | null {
  if (!hasText(view, 12, 'IHDR')) return null;
  for (let at = 33, i = 0; i < MOST_CHUNKS; i += 1) {
    if (hasText(view, at + 4, 'IDAT')) {
      return { width: view.getUint32(16), height: view.getUint32(20) };
    }
    if (hasText(view, at + 4, 'IHDR')) return null;
    at += 12 + view.getUint32(at);
  }
  return null;
}

/**
 * The only frame header (SOF0–SOF15 except DHT, JPG, DAC) before the first scan. Height 0, which a
 * DNL segment would define later, is refused.
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

/** Encoders write about ten. A decoder visits all pixels for each. */
const MOST_SCANS = 100;

/** Throws for a JPEG with more. Other files pass. */
async function requireFewScans(file: Uint8Array, slices: Slices) {
  if (file[0] !== 0xff || file[1] !== 0xd8) return;
  const view = new DataView(file.buffer, file.byteOffset, file.byteLength);
  let scans = 0;
  for (
    let at = file.indexOf(0xff, 2);
    at >= 0 && at + 4 <= file.length;
    at = file.indexOf(0xff, at)
  ) {
    const marker = file[at + 1]!;
    if (marker === 0xd9) return;
    if (marker === 0xda && ++scans > MOST_SCANS) {
      throw new Error(`has more than ${String(MOST_SCANS)} scans`);
    }
    // Fill bytes, zeros after a byte of data, and what stands alone: RST0–RST7, SOI, TEM.
    const isSegment = marker > 1 && marker < 0xff && (marker < 0xd0 || marker > 0xd8);
    at += marker === 0xff ? 1 : 2 + (isSegment ? view.getUint16(at + 2) : 0);
    if (slices.took()) {
      await slices.pause();
    }
  }
}

/**
 * That of the canvas, if there is one: a still picture has the same, frames of an animation lie
 * within it.
 */
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
    const frame = webpFrame(view, at);
    at = start + 2 * Math.ceil(view.getUint32(at + 4, true) / 2);
    if (frame === null) continue;
    return canvas === null || (canvas.width === frame.width && canvas.height === frame.height)
      ? frame
      : null;
  }
  return null;
}

/** The size in a chunk that holds a picture, lossless or lossy; null for other chunks. */
function webpFrame(view: DataView, at: number): ImageSize | null {
  if (hasText(view, at, 'VP8L')) {
    const bits = view.getUint32(at + 9, true);
    return { width: 1 + (bits & 0x3fff), height: 1 + ((bits >>> 14) & 0x3fff) };
  }
  if (!hasText(view, at, 'VP8 ')) return null;
  return {
    width: view.getUint16(at + 14, true) & 0x3fff,
    height: view.getUint16(at + 16, true) & 0x3fff,
  };
}

const uint24 = (view: DataView, at: number) =>
  view.getUint16(at, true) + view.getUint8(at + 2) * 0x10000;
