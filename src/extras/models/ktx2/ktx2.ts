// Turns KTX2 textures into pixels by the Basis Universal transcoder, as RGBA: exact, for every GPU,
// and readable by `shadeAt`. The file's values are kept as they are.
import createBasis, { type Basis } from 'three/examples/jsm/libs/basis/basis_transcoder.js';
import type { Decoded } from '../decoders/decoder.js';
import { startWasm } from '../decoders/decoder.js';

export interface Ktx2Job {
  /** A checked file. */
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** How the picture is scaled down; empty if it is not. */
  readonly scale: ImageBitmapOptions;
}

/** The transcoder's number for four bytes per pixel. */
const RGBA32 = 13;

/** @throws WebAssembly.CompileError, or EvalError in WebKit, if a policy does not allow it. */
export async function createDecoder(
  source: string | ArrayBuffer,
): Promise<(job: Ktx2Job) => Promise<Decoded<ImageBitmap>>> {
  const basis = await startWasm(createBasis, source);
  basis.initializeBasis();
  return async ({ bytes, scale }) => {
    const result = await createImageBitmap(pixelsOf(basis, bytes), {
      premultiplyAlpha: 'none',
      colorSpaceConversion: 'none',
      ...scale,
    });
    return { result, transfer: [result] };
  };
}

function pixelsOf(basis: Basis, bytes: Uint8Array): ImageData {
  const file = new basis.KTX2File(bytes);
  try {
    if (!file.isValid()) throw new Error('is a damaged KTX2 file');
    if (file.isHDR()) throw new Error('is a KTX2 file with HDR colours, which cannot be shown');
    const [width, height] = [file.getWidth(), file.getHeight()];
    const pixels = new Uint8ClampedArray(4 * width * height);
    const target = new Uint8Array(pixels.buffer);
    const transcoded =
      file.startTranscoding() &&
      file.getImageTranscodedSizeInBytes(0, 0, 0, RGBA32) === target.length &&
      file.transcodeImage(target, 0, 0, 0, RGBA32, 0, -1, -1);
    if (!transcoded) throw new Error('is a damaged KTX2 file');
    return new ImageData(pixels, width, height);
  } finally {
    file.close();
    file.delete();
  }
}
