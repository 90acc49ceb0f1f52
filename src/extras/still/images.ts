// PNG and JPEG images by plain JavaScript; other formats are refused by name.
import type { FileBytes } from '../models/model-reader.js';
import { IMAGE_PIXEL_LIMIT, IMAGE_SIDE_LIMIT, ModelError } from '../../viewer/extra.js';
import type { Pixels } from './mesh-shape.js';

/** @throws ModelError for a format that is not read; Error for a broken file. */
export async function decodeImage({ bytes }: FileBytes): Promise<Pixels> {
  const decoded = isJpeg(bytes) ? await decodeJpeg(bytes) : await decodePng(bytes);
  const { width, height, data } = decoded;
  if (Math.max(width, height) > IMAGE_SIDE_LIMIT || width * height > IMAGE_PIXEL_LIMIT) {
    throw new ModelError(
      'too-large',
      `A still cannot scale an image of ${String(width)} × ${String(height)} pixels down.`,
    );
  }
  return { width, height, data, close: () => undefined };
}

const isJpeg = (bytes: Uint8Array): boolean => bytes[0] === 0xff && bytes[1] === 0xd8;

type Decoded = Omit<Pixels, 'close'>;

async function decodePng(bytes: Uint8Array): Promise<Decoded> {
  if (bytes[0] !== 0x89) {
    throw new ModelError('bad-model', 'A still reads images in PNG and JPEG, not in WebP.');
  }
  const { PNG } = await import('pngjs');
  return PNG.sync.read(Buffer.from(bytes));
}

async function decodeJpeg(bytes: Uint8Array): Promise<Decoded> {
  const { default: jpeg } = await import('jpeg-js');
  const options = { useTArray: true, maxResolutionInMP: 34, maxMemoryUsageInMB: 2048 } as const;
  return jpeg.decode(bytes, options);
}
