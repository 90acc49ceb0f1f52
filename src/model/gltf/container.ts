// The JSON and the binary chunk of a .glb or .gltf file. Lengths are checked against the size of the file.
import type { ModelBudget } from '../model-budget.js';
import type { Slices } from '../slices.js';
import { parseJson } from './json-text.js';

export interface Container {
  readonly json: unknown;
  /** The binary chunk, which is the first buffer, or null. */
  readonly body: Uint8Array<ArrayBuffer> | null;
}

const MAGIC = 0x46546c67;
const CHUNK_JSON = 0x4e4f534a;
const CHUNK_BIN = 0x004e4942;
const HEADER = 12;
const CHUNK_HEADER = 8;

/** @param budget gets the values of the JSON. */
export async function openContainer(
  bytes: Uint8Array<ArrayBuffer>,
  budget: ModelBudget,
  slices: Slices,
): Promise<Container> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.byteLength < HEADER || view.getUint32(0, true) !== MAGIC) {
    return { json: await parseJson(bytes, budget, slices), body: null };
  }
  const version = view.getUint32(4, true);
  if (version !== 2)
    throw new Error(`it is a GLB of version ${String(version)}; only version 2 is supported`);
  const claimed = view.getUint32(8, true);
  if (claimed > bytes.byteLength) {
    throw new Error(`it is truncated: ${String(bytes.byteLength)} of ${String(claimed)} bytes`);
  }
  let json: unknown;
  let body: Uint8Array<ArrayBuffer> | null = null;
  for (let at = HEADER; at + CHUNK_HEADER <= claimed;) {
    const size = view.getUint32(at, true);
    const type = view.getUint32(at + 4, true);
    const start = at + CHUNK_HEADER;
    if (start + size > claimed) throw new Error('a chunk reaches beyond the end');
    const chunk = bytes.subarray(start, start + size);
    if (type === CHUNK_JSON && json === undefined) json = await parseJson(chunk, budget, slices);
    if (type === CHUNK_BIN && body === null) body = chunk;
    at = start + size;
  }
  if (json === undefined) throw new Error('it has no JSON chunk');
  return { json, body };
}
