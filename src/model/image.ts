// Decodes an image file to pixels, without colour conversion and without premultiplication, first row on top. The
// browser decodes them, but KTX2. No blob: address is fetched, as a strict CSP requires.
import { imageSize, type ImageSize } from './image-size.js';
import { decodeKtx2, isKtx2 } from './ktx2/decode-ktx2.js';
import { IMAGE_PIXEL_LIMIT, IMAGE_SIDE_LIMIT } from './limits.js';
import { type ModelBudget, requireAtMost } from './model-budget.js';

/**
 * Pixels that are decoded at the same time, over all models. A decoder takes up to three times the memory of its
 * result.
 */
const PIXELS_AT_ONCE = 2 ** 24;

export interface ImageFile {
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** Media type; may be empty. */
  readonly type: string;
}

/**
 * Adds an image that is to be decoded to the budget. @throws Error for a file that is no image, ModelError past a
 * limit.
 */
export function countImage({ bytes }: ImageFile, budget: ModelBudget): ImageSize {
  const size = imageSize(bytes);
  if (!size) throw new Error('is no PNG, JPEG, WebP or KTX2 image, or its headers contradict each other');
  const pixels = size.width * size.height;
  if (isKtx2(bytes)) requireAtMost(pixels, IMAGE_PIXEL_LIMIT, 'pixels in one KTX2 image');
  budget.add({ pixels });
  return size;
}

/**
 * Decodes an image, scaled down if it is larger than the limits of one image. Count its pixels first ({@link
 * countImage}).
 * @throws if it cannot be decoded.
 */
export async function decodeImage(file: ImageFile, size: ImageSize, signal: AbortSignal): Promise<ImageBitmap> {
  const pixels = Math.min(size.width * size.height, PIXELS_AT_ONCE);
  await acquire(pixels);
  try {
    const scale = scaledDown(size);
    return isKtx2(file.bytes) ? await decodeKtx2(file.bytes, scale, signal) : await decodeByBrowser(file, size, scale);
  } finally {
    release(pixels);
  }
}

async function decodeByBrowser(
  { bytes, type }: ImageFile,
  { width, height }: ImageSize,
  scale: ImageBitmapOptions,
): Promise<ImageBitmap> {
  let bitmap: ImageBitmap;
  try {
    bitmap = await createImageBitmap(new Blob([bytes], { type }), {
      premultiplyAlpha: 'none',
      colorSpaceConversion: 'none',
      ...scale,
    });
  } catch (cause) {
    throw new Error('cannot be decoded by this browser', { cause });
  }
  // Photographs can be turned by a quarter. Others have the size that was counted, or are not shown.
  const sides = [bitmap.width, bitmap.height];
  if (scale.resizeWidth !== undefined || (sides.includes(width) && sides.includes(height))) return bitmap;
  bitmap.close();
  throw new Error(`has ${sides.join(' × ')} pixels, but ${String(width)} × ${String(height)} in its header`);
}

function scaledDown({ width, height }: ImageSize): ImageBitmapOptions {
  const factor = Math.min(IMAGE_SIDE_LIMIT / Math.max(width, height), Math.sqrt(IMAGE_PIXEL_LIMIT / (width * height)));
  if (factor >= 1) return {};
  return {
    resizeWidth: Math.max(Math.floor(width * factor), 1),
    resizeHeight: Math.max(Math.floor(height * factor), 1),
    resizeQuality: 'medium',
  };
}

let decoding = 0;
const waiting: { readonly pixels: number; readonly start: () => void }[] = [];

async function acquire(pixels: number): Promise<void> {
  if (waiting.length > 0 || decoding + pixels > PIXELS_AT_ONCE) {
    await new Promise<void>((resolve) => waiting.push({ pixels, start: resolve }));
  } else {
    decoding += pixels;
  }
}

function release(pixels: number): void {
  decoding -= pixels;
  for (let next = waiting[0]; next && decoding + next.pixels <= PIXELS_AT_ONCE; next = waiting[0]) {
    waiting.shift();
    decoding += next.pixels;
    next.start();
  }
}
