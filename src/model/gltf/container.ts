// The JSON and the binary chunk of a .glb or .gltf file. Lengths are checked against the size of the file.
import { fromBase64 } from '../base64.js';
import { dataHeader, type DataUri, decodeDataUri } from '../data-uri.js';
import { JSON_TEXT_LIMIT } from '../limits.js';
import { type ModelBudget, requireAtMost } from '../model-budget.js';
import { isDataUri } from '../request-file.js';
import type { Slices } from '../slices.js';
import { isEscaped, parseJson } from './json-text.js';

export interface Container {
  readonly json: unknown;
  /** The data behind a data: URI in the JSON, long ones of which are only keys. Decoded once. */
  readonly data: (uri: string) => Promise<DataUri>;
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
    return { ...(await parseText(bytes, budget, slices)), body: null };
  }
  const version = view.getUint32(4, true);
  if (version !== 2) throw new Error(`it is a GLB of version ${String(version)}; only version 2 is supported`);
  const claimed = view.getUint32(8, true);
  if (claimed > bytes.byteLength) {
    throw new Error(`it is truncated: ${String(bytes.byteLength)} of ${String(claimed)} bytes`);
  }
  let parsed: Omit<Container, 'body'> | undefined;
  let body: Uint8Array<ArrayBuffer> | null = null;
  for (let at = HEADER; at + CHUNK_HEADER <= claimed;) {
    const size = view.getUint32(at, true);
    const type = view.getUint32(at + 4, true);
    const start = at + CHUNK_HEADER;
    if (start + size > claimed) throw new Error('a chunk reaches beyond the end');
    const chunk = bytes.subarray(start, start + size);
    if (type === CHUNK_JSON) parsed ??= await parseText(chunk, budget, slices);
    if (type === CHUNK_BIN && body === null) body = chunk;
    at = start + size;
  }
  if (parsed === undefined) throw new Error('it has no JSON chunk');
  return { ...parsed, body };
}

/**
 * Parses JSON without its data in base64: they stay bytes, and a key stands for each.
 * @throws ModelError `too-large`, an Error for broken JSON.
 */
async function parseText(
  bytes: Uint8Array<ArrayBuffer>,
  budget: ModelBudget,
  slices: Slices,
): Promise<Omit<Container, 'body'>> {
  const { texts, data } = await cutData(bytes, slices);
  const size = texts.reduce((sum, { byteLength }) => sum + byteLength, 0);
  requireAtMost(size, JSON_TEXT_LIMIT, 'bytes of JSON, without data in base64');
  budget.add({ text: size });
  const encoder = new TextEncoder();
  const pieces = texts.flatMap((text, i) => (i === 0 ? [text] : [encoder.encode(keyOf(i - 1)), text]));
  const [whole] = pieces;
  const text = whole !== undefined && pieces.length === 1 ? whole : await slices.joined(pieces);
  return { json: await parseJson(text, budget, slices), data: dataByKey(data, slices) };
}

const LATIN1 = new TextDecoder('latin1');

/** A data: URI in base64, as bytes of the file. */
interface Cut {
  readonly header: string;
  readonly text: Uint8Array<ArrayBuffer>;
}

const keyOf = (index: number): string => `data:;part-of-file,${String(index)}`;

function dataByKey(cuts: readonly Cut[], slices: Slices): Container['data'] {
  const decoded = new Map<string, Promise<DataUri>>();
  return (key) => {
    const known = decoded.get(key);
    if (known !== undefined) return known;
    const cut = cuts.find((_, i) => keyOf(i) === key);
    const data =
      cut === undefined
        ? decodeDataUri(key, slices)
        : fromBase64(cut.text, slices).then((bytes) => ({ ...dataHeader(cut.header), bytes }));
    decoded.set(key, data);
    return data;
  };
}

/** Shorter ones may be text. */
const LEAST_CUT = 2 ** 12;

/** Bytes between two looks at the clock. */
const STEP = 2 ** 16;

/** The JSON's text before, between and after its data in base64. */
async function cutData(
  bytes: Uint8Array<ArrayBuffer>,
  slices: Slices,
): Promise<{ texts: readonly Uint8Array[]; data: readonly Cut[] }> {
  const texts: Uint8Array[] = [];
  const data: Cut[] = [];
  let kept = 0;
  let next = STEP;
  /** Where the string begins that is being read; -1 between strings. */
  let start = -1;
  for (let at = bytes.indexOf(QUOTE); at >= 0; at = bytes.indexOf(QUOTE, at + 1)) {
    if (at >= next) {
      next = at + STEP;
      await slices.pauseIfDue();
    }
    if (start >= 0 && isEscaped(bytes, at)) continue;
    if (start < 0) {
      start = at + 1;
      continue;
    }
    const cut = at - start < LEAST_CUT ? null : await base64In(bytes.subarray(start, at), slices);
    if (cut !== null) {
      data.push(cut);
      texts.push(bytes.subarray(kept, start));
      kept = at;
    }
    start = -1;
  }
  texts.push(bytes.subarray(kept));
  return { texts, data };
}

/** Null for any other text, and where the data are escaped. */
async function base64In(text: Uint8Array<ArrayBuffer>, slices: Slices): Promise<Cut | null> {
  const start = LATIN1.decode(text.subarray(0, 256));
  const comma = start.indexOf(',');
  const header = start.slice(0, comma);
  if (comma < 0 || !isDataUri(header) || !dataHeader(header).base64) return null;
  for (let from = 0; from < text.length; from += PIECE) {
    const piece = text.subarray(from, from + PIECE);
    if (ESCAPES.some((character) => piece.includes(character))) return null;
    await slices.pauseIfDue();
  }
  return { header, text: text.subarray(comma + 1) };
}

const QUOTE = 0x22;
/** Bytes of a string that are searched in one piece. */
const PIECE = 2 ** 20;
/** Backslash, percent sign, and the hash of a fragment. */
const ESCAPES = [0x5c, 0x25, 0x23];
