// The JSON and the binary chunk of a .glb or .gltf file. Lengths are checked against the size of
// the file.
import { requireAtMost } from '../../../phong/model/budget.js';
import type { ModelBudget } from '../../../phong/model/model-budget.js';
import { fromBase64, dataHeader, decodeDataUri } from '../encodings.js';
import type { FileBytes } from '../model-reader.js';
import type { Slices } from '../slices.js';
import { JSON_TEXT_LIMIT } from '../limits.js';
import { isDataUri } from '../../../phong/fields/file-names.js';

export interface Container {
  readonly json: unknown;
  /** The data behind a data: URI in the JSON, long ones of which are only keys. Decoded once. */
  readonly data: (uri: string) => Promise<FileBytes>;
  /** The binary chunk, which is the first buffer, or null. */
  readonly body: Uint8Array<ArrayBuffer> | null;
}

/**
 * Words of a GLB file (glTF 2.0, GLB File Format Specification): `glTF`, `JSON` and `BIN`; and
 * bytes of the headers of the file and of a chunk.
 */
const MAGIC = 0x46546c67;
const CHUNK_JSON = 0x4e4f534a;
const CHUNK_BIN = 0x004e4942;
const HEADER = 12;
const CHUNK_HEADER = 8;

/** Bytes between two looks at the clock. Strings are skipped by the engine's own search. */
const STEP = 2 ** 18;

const [QUOTE, BACKSLASH, COMMA, OPEN_LIST, OPEN_OBJECT] = [0x22, 0x5c, 0x2c, 0x5b, 0x7b];

/** @param budget gets the values of the JSON. */
export async function openContainer(
  bytes: Uint8Array<ArrayBuffer>,
  budget: ModelBudget,
  slices: Slices,
): Promise<Container> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.byteLength < HEADER || view.getUint32(0, true) !== MAGIC) {
    return { ...(await parseText(bytes, budget, slices)), body: null };
  }
  const version = view.getUint32(4, true);
  if (version !== 2) {
    throw new Error(`it is a GLB of version ${String(version)}; only version 2 is supported`);
  }
  const claimed = view.getUint32(8, true);
  if (claimed > bytes.byteLength) {
    throw new Error(`it is truncated: ${String(bytes.byteLength)} of ${String(claimed)} bytes`);
  }
  let parsed: Omit<Container, 'body'> | undefined;
  let body: Uint8Array<ArrayBuffer> | null = null;
  for (let at = HEADER; at + CHUNK_HEADER <= claimed;) {
    const size = view.getUint32(at, true);
    const type = view.getUint32(at + 4, true);
    const end = at + CHUNK_HEADER + size;
    if (end > claimed) throw new Error('a chunk reaches beyond the end');
    const chunk = bytes.subarray(at + CHUNK_HEADER, end);
    if (type === CHUNK_JSON) {
      parsed ??= await parseText(chunk, budget, slices);
    }
    if (type === CHUNK_BIN) {
      body ??= chunk;
    }
    if (slices.took()) {
      await slices.pause();
    }
    at = end;
  }
  if (parsed === undefined) throw new Error('it has no JSON chunk');
  return { ...parsed, body };
}

/**
 * Parses JSON without its data in base64: they stay bytes, and a key stands for each. The rest is
 * parsed in one task.
 * @param budget gets its values, counted by brackets and commas.
 * @throws ModelError `too-large`, a plain Error if it is no JSON.
 */
async function parseText(
  bytes: Uint8Array<ArrayBuffer>,
  budget: ModelBudget,
  slices: Slices,
): Promise<Omit<Container, 'body'>> {
  const cuts: Cut[] = [];
  const texts: Uint8Array[] = [];
  /** Bytes before this one are in `texts` or in `cuts`. */
  let from = 0;
  let cutBytes = 0;
  let values = 0;
  /** Where the string begins that is being read; -1 between strings. */
  let start = -1;
  let next = STEP;
  for (let at = 0; at < bytes.length; at += 1) {
    if (at >= next) {
      next = at + STEP;
      await slices.pauseIfDue();
    }
    if (start < 0) {
      const byte = bytes[at];
      if (byte === QUOTE) {
        start = at + 1;
      } else if (byte === COMMA || byte === OPEN_LIST || byte === OPEN_OBJECT) {
        values += 1;
      }
      continue;
    }
    const found = bytes.subarray(at, at + STEP).indexOf(QUOTE);
    at += found < 0 ? STEP - 1 : found;
    if (found < 0 || isEscaped(bytes, at)) continue;
    const cut = at - start < LEAST_CUT ? null : await base64In(bytes.subarray(start, at), slices);
    if (cut !== null) {
      texts.push(bytes.subarray(from, start), new TextEncoder().encode(keyOf(cuts.length)));
      from = at;
      cutBytes += at - start;
      cuts.push(cut);
    }
    start = -1;
  }
  const length = bytes.length - cutBytes;
  requireAtMost(length, JSON_TEXT_LIMIT, 'bytes of JSON, without data in base64');
  budget.add({ text: length, json: values });
  texts.push(bytes.subarray(from));
  return { json: parsed(await slices.joined(texts)), data: dataByKey(cuts, slices) };
}

/** Whether the character is preceded by an odd number of backslashes. */
function isEscaped(bytes: Uint8Array, at: number): boolean {
  let first = at;
  while (bytes[first - 1] === BACKSLASH) {
    first -= 1;
  }
  return (at - first) % 2 === 1;
}

function parsed(utf8: Uint8Array): unknown {
  try {
    return JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(utf8)) as unknown;
  } catch (cause) {
    throw new Error('its JSON is broken', { cause });
  }
}

/** A data: URI in base64, as bytes of the file. */
interface Cut {
  readonly header: string;
  readonly text: Uint8Array<ArrayBuffer>;
}

const keyOf = (index: number) => `data:;part-of-file,${String(index)}`;

function dataByKey(cuts: readonly Cut[], slices: Slices): Container['data'] {
  const decoded = new Map<string, Promise<FileBytes>>();
  const byKey = new Map(cuts.map((cut, i) => [keyOf(i), cut]));
  return (key) => {
    const present = decoded.get(key);
    if (present !== undefined) return present;
    const cut = byKey.get(key);
    const data =
      cut === undefined
        ? decodeDataUri(key, slices)
        : fromBase64(cut.text, slices).then((bytes) => ({ ...dataHeader(cut.header), bytes }));
    decoded.set(key, data);
    return data;
  };
}

/** Bytes of a string; shorter ones may be text. */
const LEAST_CUT = 2 ** 12;

/** Null for any other text, and where the data are escaped. */
async function base64In(text: Uint8Array<ArrayBuffer>, slices: Slices): Promise<Cut | null> {
  const start = new TextDecoder('latin1').decode(text.subarray(0, 256));
  const comma = start.indexOf(',');
  const header = start.slice(0, comma);
  if (comma < 0 || !isDataUri(header) || !dataHeader(header).base64) return null;
  for (let from = 0; from < text.length; from += STEP) {
    const piece = text.subarray(from, from + STEP);
    if (ESCAPES.some((character) => piece.includes(character))) return null;
    await slices.pauseIfDue();
  }
  return { header, text: text.subarray(comma + 1) };
}

/** Backslash, percent sign, and the hash of a fragment. */
const ESCAPES = [BACKSLASH, 0x25, 0x23];
