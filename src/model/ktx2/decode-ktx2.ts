// Decodes a KTX2 file to an image. Checked here, decoded by code that is fetched with the first such file.
import transcoder from 'three/examples/jsm/libs/basis/basis_transcoder.wasm?url';
import { lazyCode } from '../lazy-code.js';
import { DecoderThread } from '../decoders/decoder-thread.js';
import { ModelError } from '../model.js';
import type { Ktx2Job } from './ktx2.js';
import { checkKtx2 } from './ktx2-header.js';

const decoderCode = /* @__PURE__ */ lazyCode(() => import('./ktx2.js'), 'KTX2 textures');

const thread = /* @__PURE__ */ new DecoderThread<Ktx2Job, ImageBitmap>(
  [() => new Worker(new URL('./ktx2-worker.ts', import.meta.url), { type: 'module' })],
  async () => {
    // The script for pages opened from disk has no WebAssembly beside it.
    if (transcoder === '')
      throw new ModelError('bad-model', 'KTX2 textures cannot be shown by phong-viewer.classic.js. Use the module, from a server.'); // prettier-ignore
    const { createDecoder } = await decoderCode().catch(notFetched);
    return (address) => createDecoder(address).catch(notStarted);
  },
  transcoder,
);

/** @throws ModelError, or Error for a file that cannot be shown: its message continues a sentence. */
export function decodeKtx2(
  bytes: Uint8Array<ArrayBuffer>,
  scale: ImageBitmapOptions,
  signal: AbortSignal,
): Promise<ImageBitmap> {
  checkKtx2(bytes);
  // A part of a larger file would take all of that file to the worker.
  return thread.decode({ bytes: bytes.slice(), scale }, signal);
}

function notFetched(cause: unknown): never {
  const message = `The decoder of KTX2 textures, which this model needs, could not be fetched with ${transcoder}.`;
  throw new ModelError('load-failed', message, { cause });
}

function notStarted(cause: unknown): never {
  if (!(cause instanceof WebAssembly.CompileError || cause instanceof EvalError)) notFetched(cause);
  throw new ModelError(
    'csp',
    'The model has KTX2 textures, and the page’s Content-Security-Policy does not allow the WebAssembly that unpacks them. ' +
      "Add 'wasm-unsafe-eval' to script-src, or save the model with PNG, JPEG or WebP textures.",
    { cause },
  );
}
