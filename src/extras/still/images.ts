// PNG and JPEG images by plain JavaScript; other formats are refused by name.
import { Unzlib } from 'fflate';
import type { PNGWithMetadata } from 'pngjs';
import type { FileBytes } from '../models/model-reader.js';
import { clamp } from '../../phong/math/vector.js';
import { ModelError } from '../../phong/model/model.js';
import type { Pixels } from './mesh-shape.js';
import { IMAGE_SIDE_LIMIT } from '../models/limits.js';

/** @throws ModelError for a format that is not read; Error for a broken file. */
export async function decodeImage({ bytes }: FileBytes): Promise<Pixels> {
  // The Exif data, from their two bytes of length on: at most 64 kB.
  const header = new TextDecoder('latin1').decode(bytes.subarray(0, 2 ** 17));
  const exif = header.search(/(?<=\xff\xe1)..Exif|..eXIf/s);
  if (TURNED.test(header.slice(exif, exif + 6 + 256 * bytes[exif]! + bytes[exif + 1]!))) {
    throw new ModelError('bad-model', 'A still cannot turn an image, as its Exif data say.');
  }
  const decode = bytes[0] === 0xff ? decodeJpeg : decodePng;
  const decoded = await decode(bytes).catch((cause: unknown) => {
    // The decoders' own sentences are for programmers.
    throw cause instanceof ModelError ? cause : new Error('is damaged', { cause });
  });
  const { width, height, data } = decoded;
  if (Math.max(width, height) > IMAGE_SIDE_LIMIT) {
    throw new ModelError(
      'too-large',
      `A still cannot scale an image of ${String(width)} × ${String(height)} pixels down.`,
    );
  }
  return { width, height, data, close: () => undefined };
}

/** An orientation from 2 to 8, in both orders of bytes. */
const TURNED = /(\x12\x01\x03\0\x01\0\0\0|\x01\x12\0\x03\0\0\0\x01\0)[\x02-\x08]/;

type Decoded = Omit<Pixels, 'close'>;

async function decodePng(bytes: Uint8Array): Promise<Decoded> {
  if (bytes[0] !== 0x89) {
    throw new ModelError('bad-model', 'A still reads images in PNG and JPEG, not in WebP.');
  }
  const { PNG } = await import('pngjs');
  const image: PngImage = PNG.sync.read(Buffer.from(wholePng(bytes)));
  const { data, depth, transColor } = image;
  if (transColor === undefined) return image;
  // pngjs makes the one transparent colour black, which shows where opacity does not count.
  const most = (1 << depth) - 1;
  const [red, green = red, blue = red] = transColor.map((c) => Math.round((255 * c) / most));
  for (let i = 0; i < data.length; i += 4) {
    if (data[i + 3] === 0) {
      data.set([red!, green!, blue!], i);
    }
  }
  return image;
}

/** `transColor`: the colour that is transparent, by the file's own depth. One number is a grey. */
type PngImage = PNGWithMetadata & { readonly transColor?: readonly number[] };

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

async function decodeJpeg(file: Uint8Array): Promise<Decoded> {
  const { default: jpeg } = await import('jpeg-js');
  const bytes = file.slice();
  const { isYcc, across, down } = readFrame(bytes);
  const { width, height, data } = jpeg.decode(bytes, {
    useTArray: true,
    maxResolutionInMP: 34,
    maxMemoryUsageInMB: 2048,
    colorTransform: false,
    formatAsRGBA: !isYcc,
  });
  if (!isYcc) return { width, height, data };
  const chroma = (x: number, y: number, k: number): number => data[3 * (y * width + x) + k]!;
  /** Three quarters of the nearer sample and one of the farther, as browsers' libjpeg has it. */
  const smooth = (x: number, y: number, k: number): number => {
    const [beside, above] = [farther(x, width, across), farther(y, height, down)];
    const column = (i: number): number => 3 * chroma(i, y, k) + chroma(i, above, k);
    return ((3 * column(x) + column(beside) + 8 - (x & 1)) >> 4) - 128;
  };
  const rgba = new Uint8ClampedArray(4 * width * height).fill(255);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const [luma, blue, red] = [chroma(x, y, 0), smooth(x, y, 1), smooth(x, y, 2)];
      const color = [
        luma + ((91881 * red + 32768) >> 16),
        luma + ((-22554 * blue - 46802 * red + 32768) >> 16),
        luma + ((116130 * blue + 32768) >> 16),
      ];
      rgba.set(color, 4 * (y * width + x));
    }
  }
  return { width, height, data: new Uint8Array(rgba.buffer) };
}

/** A pixel of the farther sample, where each is of `step` pixels. Only halves are smoothed. */
const farther = (at: number, size: number, step: number): number =>
  clamp(step === 2 ? at - 1 + 2 * (at & 1) : at, 0, size - 1);

/**
 * How browsers' libjpeg reads a file's colours: `isYcc` of three components that are not r, g and b;
 * then `across` and `down` are the pixels to a sample of chroma. Takes from the Adobe marker that it
 * is YCbCr: jpeg-js would convert by it, without smoothing.
 */
function readFrame(bytes: Uint8Array) {
  let transform: number | undefined; // 0: none, from r, g and b
  for (let at = 2; at + 17 < bytes.length;) {
    const marker = bytes[at + 1]!;
    const data = bytes.subarray(at + 4);
    if (marker === 0xe0 && data[2] === 0x49) {
      transform = 1; // JFIF has no other
    }
    if (marker === 0xee) {
      transform ??= data[11]!;
      data[11]! &= 2; // that of CMYK
    }
    if (marker >= 0xc0 && marker <= 0xc2 && data[0] === 8) {
      const [luma, chroma] = [data[7]!, data[10]!];
      return {
        // Without a marker r, g and b are told by their names: the first is called "R".
        isYcc: data[5] === 3 && (transform ?? data[6]! - 0x52) !== 0,
        across: (luma >> 4) / (chroma >> 4),
        down: (luma & 15) / (chroma & 15),
      };
    }
    at += marker === 0xff ? 1 : 2 + 256 * bytes[at + 2]! + bytes[at + 3]!;
  }
  throw new Error('no frame in 8 bits');
}
