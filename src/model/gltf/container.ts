// The JSON and the binary chunk of a .glb or .gltf file. Lengths are checked against the size of the file.
import type { ModelBudget } from '../model-budget.js';

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
export function openContainer(bytes: Uint8Array<ArrayBuffer>, budget: ModelBudget): Container {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.byteLength < HEADER || view.getUint32(0, true) !== MAGIC) {
    return { json: parseText(bytes, budget), body: null };
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
    if (type === CHUNK_JSON && json === undefined) json = parseText(chunk, budget);
    if (type === CHUNK_BIN && body === null) body = chunk;
    at = start + size;
  }
  if (json === undefined) throw new Error('it has no JSON chunk');
  return { json, body };
}

function parseText(bytes: Uint8Array, budget: ModelBudget): unknown {
  budget.add({ json: countValues(bytes) });
  try {
    return JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes)) as unknown;
  } catch (cause) {
    throw new Error('its JSON is broken', { cause });
  }
}

/** A value follows each opening bracket and comma. Those within strings count too; base64 has none. */
function countValues(bytes: Uint8Array): number {
  let count = 0;
  for (let i = 0; i < bytes.length; i += 1) {
    const byte = bytes[i];
    if (byte === COMMA || byte === BRACKET || byte === BRACE) count += 1;
  }
  return count;
}

const COMMA = 0x2c;
const BRACKET = 0x5b;
const BRACE = 0x7b;
