// Decodes meshopt data by three's WebAssembly decoder, on the main thread: about a gigabyte per
// second. A chunk.
import { MeshoptDecoder } from 'three/addons/libs/meshopt_decoder.module.js';
import { ModelError } from '../../../phong/model/model.js';
import type { MeshoptView } from './accessors.js';

/** @throws ModelError `csp` if the page allows no WebAssembly, Error for broken bytes. */
export async function decodeMeshopt(
  bytes: Uint8Array,
  { count, stride, mode, filter }: MeshoptView,
): Promise<Uint8Array<ArrayBuffer>> {
  if (!MeshoptDecoder.supported) throw refused(undefined);
  await MeshoptDecoder.ready.catch((cause: unknown) => {
    throw refused(cause);
  });
  const decoded = new Uint8Array(count * stride);
  // An empty view has nothing to decode, and the decoder wants a header.
  if (decoded.length > 0) {
    MeshoptDecoder.decodeGltfBuffer(decoded, count, stride, bytes, mode, filter);
  }
  return decoded;
}

const refused = (cause: unknown) =>
  new ModelError(
    'csp',
    'The model is compressed by meshopt, and the page’s Content-Security-Policy does not allow the WebAssembly that unpacks it.',
    {
      cause,
      advice: "Add 'wasm-unsafe-eval' to script-src, or save the model without that compression.",
      ownAdvice: 'Save it without that compression.',
    },
  );
