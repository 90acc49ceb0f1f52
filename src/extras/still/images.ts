// PNG and JPEG images by plain JavaScript; other formats are refused by name.
import { Unzlib } from 'fflate';
import type { FileBytes } from '../models/model-reader.js';
import { LIMITS } from '../../phong/model/limits.js';
import { ModelError } from '../../phong/model/model.js';
import type { Pixels } from './mesh-shape.js';
import { IMAGE_SIDE_LIMIT } from '../models/limits.js';

/** @throws ModelError for a format that is not read; Error for a broken file. */
export async function decodeImage({ bytes }: FileBytes): Promise<Pixels> {
  const decode = isJpeg(bytes) ? decodeJpeg : decodePng;
  const decoded = await decode(bytes).catch((cause: unknown) => {
    // The decoders' own sentences are for programmers.
    throw cause instanceof ModelError ? cause : new Error('is damaged', { cause });
  });
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
  return PNG.sync.read(Buffer.from(wholePng(bytes)));
}

/** Bytes that are unpacked at a time: to 16 MB at most. */
const SLICE = 2 ** 14;

/**
 * The file up to its end. Refuses one that has less or more data than its header says: pngjs shows
 * memory of the process in place of what is missing, and unpacks all of an interlaced image, 1,000
 * times the file's size.
 */
function wholePng(bytes: Uint8Array): Uint8Array {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const samples = [1, 0, 3, 1, 2, 0, 4][bytes[25]!]!; // by colour type
  const row = 1 + Math.ceil((view.getUint32(16) * samples * bytes[24]!) / 8);
  const least = row * view.getUint32(20);
  const most = 2 * least + 64; // the rows of an interlaced image are up to twice as many
  let unpacked = 0;
  const unzip = new Unzlib((part) => (unpacked += part.length));
  let end = 8;
  for (let type = 0; type !== IEND && end + 12 <= bytes.length; end += 4) {
    let at = end + 8;
    type = view.getUint32(end + 4);
    end = at + view.getUint32(end);
    for (; type === IDAT && at < end && unpacked <= most; at += SLICE) {
      unzip.push(bytes.subarray(at, Math.min(end, at + SLICE)));
    }
  }
  if (!(unpacked >= least && unpacked <= most)) throw new Error('not the rows of its header');
  return bytes.subarray(0, end);
}

const IEND = 0x49454e44;
const IDAT = 0x49444154;

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
