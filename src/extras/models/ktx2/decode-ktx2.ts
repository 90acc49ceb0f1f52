// Decodes a KTX2 file to an image. Checked here, decoded by code that is fetched with the first
// such file.
import transcoder from 'three/examples/jsm/libs/basis/basis_transcoder.wasm?url';
import { lazyCode } from '../../../phong/lazy-code.js';
import { ModelError } from '../../../phong/model/model.js';
import { DecoderThread } from '../decoders/decoder-thread.js';
import { neededCode } from '../model-reader.js';
import type { Ktx2Job } from './ktx2.js';

const decoderCode = /* @__PURE__ */ lazyCode(() => import('./ktx2-worker.js'), 'KTX2 textures');

const RESAVE = 'Save it with PNG, JPEG or WebP textures.';

const thread = /* @__PURE__ */ new DecoderThread<Ktx2Job, ImageBitmap>(
  () => new Worker(new URL('./ktx2-worker.ts', import.meta.url), { type: 'module' }),
  async () => {
    // The script for pages opened from disk has no WebAssembly beside it.
    if (transcoder === '') {
      throw new ModelError(
        'bad-model',
        'KTX2 textures cannot be shown by phong-viewer.classic.js.',
        { advice: 'Use the module, from a server.', ownAdvice: RESAVE },
      );
    }
    const { createDecoder } = await neededCode(decoderCode(), DECODER);
    return (source) => neededCode(createDecoder(source).catch(notAllowed), DECODER);
  },
  transcoder,
);

/**
 * @throws ModelError, or Error for a file that cannot be shown: its message continues a sentence.
 */
export function decodeKtx2(
  bytes: Uint8Array<ArrayBuffer>,
  scale: ImageBitmapOptions,
  signal: AbortSignal,
): Promise<ImageBitmap> {
  checkKtx2(bytes);
  // A part of a larger file would take all of that file to the worker.
  return thread.decode({ bytes: bytes.slice(), scale }, signal);
}

const DECODER = `The decoder of KTX2 textures (${transcoder})`;

function notAllowed(cause: unknown): never {
  if (!(cause instanceof WebAssembly.CompileError || cause instanceof EvalError)) throw cause;
  throw new ModelError(
    'csp',
    'The model has KTX2 textures, and the page’s Content-Security-Policy does not allow the WebAssembly that unpacks them.',
    {
      cause,
      advice:
        "Add 'wasm-unsafe-eval' to script-src, or save the model with PNG, JPEG or WebP textures.",
      ownAdvice: RESAVE,
    },
  );
}

const MAGIC = '\xabKTX 20\xbb\r\n\x1a\n';

export const isKtx2 = (bytes: Uint8Array) =>
  Array.from(MAGIC).every((character, i) => bytes[i] === character.charCodeAt(0));

const HEADER = 80;
/** The largest image has 8192 × 8192 pixels, and 14 levels down to one. */
const MOST_LEVELS = 16;
/** UASTC has 16 bytes for 4 × 4 pixels, ETC1S up to 16 with alpha, and less. */
const BLOCK_BYTES = 16;

/**
 * Checks the header before the transcoder allocates for it (KTX File Format Specification 2.0,
 * sections 3 and 4).
 * @throws Error for a file that is no single picture in a format of Basis Universal, or that claims
 * too much.
 */
export function checkKtx2(bytes: Uint8Array): void {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (view.byteLength < HEADER) throw new Error('is a KTX2 file that ends inside its header');
  const uint = (at: number) => view.getUint32(at, true);
  const [format, width, height, depth, layers, faces] = [12, 20, 24, 28, 32, 36].map(uint);
  if (format !== 0) {
    throw new Error(
      'is a KTX2 file in a format of its own; only those of Basis Universal can be shown',
    );
  }
  if (depth !== 0 || (layers ?? 0) > 1 || faces !== 1) {
    throw new Error('is a KTX2 file that holds no single picture');
  }
  const levels = Math.max(uint(40), 1);
  if (levels > MOST_LEVELS || HEADER + 24 * levels > view.byteLength) {
    throw new Error('is a KTX2 file that is cut short');
  }
  const most = Math.ceil((width ?? 0) / 4) * Math.ceil((height ?? 0) / 4) * BLOCK_BYTES;
  for (let level = 0; level < levels; level += 1) {
    const long = (at: number) => Number(view.getBigUint64(HEADER + 24 * level + at, true));
    if (long(0) + long(8) > view.byteLength) throw new Error('is a KTX2 file that is cut short');
    if (long(16) > most) throw new Error('is a KTX2 file that unpacks to more than its size says');
  }
}
