// PNG and JPEG images by plain JavaScript; other formats are refused by name.
import type { FileBytes } from '../models/model-reader.js';
import { LIMITS } from '../../phong/model/limits.js';
import { ModelError } from '../../phong/model/model.js';
import type { Pixels } from './mesh-shape.js';
import { IMAGE_SIDE_LIMIT } from '../models/limits.js';

/** @throws ModelError for a format that is not read; Error for a broken file. */
export async function decodeImage({ bytes }: FileBytes): Promise<Pixels> {
  const decoded = isJpeg(bytes) ? await decodeJpeg(bytes) : await decodePng(bytes);
  const { width, height, data } = decoded;
  if (Math.max(width, height) > IMAGE_SIDE_LIMIT || width * height > LIMITS.imagePixels) {
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
  const [across, down] = chromaSteps(bytes);
  if (across === 1 && down === 1) return jpeg.decode(bytes, options);
  const plain = { ...options, colorTransform: false, formatAsRGBA: false };
  const { width, height, data } = jpeg.decode(bytes, plain);
  const rgba = new Uint8ClampedArray(4 * width * height);
  const chroma = (x: number, y: number, k: number): number => data[3 * (y * width + x) + k]!;
  /** Three quarters of the nearer sample and one of the farther, as browsers' libjpeg has it. */
  const smooth = (x: number, y: number, k: number): number => {
    const [near, far] = across === 1 ? [x, x] : neighbours(x, width);
    const [above, below] = down === 1 ? [y, y] : neighbours(y, height);
    const column = (i: number): number => 3 * chroma(i, above, k) + chroma(i, below, k);
    return ((3 * column(near) + column(far) + 8 - (x & 1)) >> 4) - 128;
  };
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const [luma, blue, red] = [chroma(x, y, 0), smooth(x, y, 1), smooth(x, y, 2)];
      const green = (-22554 * blue - 46802 * red + 32768) >> 16;
      const color = [
        luma + ((91881 * red + 32768) >> 16),
        luma + green,
        luma + ((116130 * blue + 32768) >> 16),
        255,
      ];
      rgba.set(color, 4 * (y * width + x));
    }
  }
  return { width, height, data: new Uint8Array(rgba.buffer) };
}

/** Where the nearer and the farther sample of a halved row are, in whole pixels. */
function neighbours(at: number, size: number): readonly [number, number] {
  const near = at - (at & 1);
  const far = (at & 1) === 1 ? near + 2 : near - 2;
  return [near, far < 0 || far >= size ? near : far];
}

/**
 * Pixels to a chroma sample across and down, 2 or 1: of three components, whose colours no Adobe
 * marker declares. 1 for all other files: their decoder's own colours.
 */
function chromaSteps(bytes: Uint8Array): readonly [number, number] {
  for (let at = 2; at + 17 < bytes.length; at += 2 + 256 * bytes[at + 2]! + bytes[at + 3]!) {
    const marker = bytes[at + 1]!;
    if (marker === 0xee) return [1, 1];
    if (marker < 0xc0 || marker > 0xc2) continue;
    const [luma, blue, red] = [bytes[at + 11]!, bytes[at + 14]!, bytes[at + 17]!];
    const isUsual = bytes[at + 9] === 3 && blue === 0x11 && red === 0x11;
    const [across, down] = [luma >> 4, luma & 15];
    return isUsual && across <= 2 && down <= 2 ? [across, down] : [1, 1];
  }
  return [1, 1];
}
