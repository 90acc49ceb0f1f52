// Parses the text of a glTF document. A document's lists can be millions of values long, so they are parsed in pieces
// of some objects each, with pauses in between.
import { JSON_LIMIT, JSON_PIECE_BYTES, JSON_PIECE_LIMIT } from '../limits.js';
import { type ModelBudget, requireAtMost } from '../model-budget.js';
import type { Slices } from '../slices.js';

/** Values in a piece, and bytes: a few milliseconds. */
const PIECE = 2 ** 14;
const PIECE_BYTES = 2 ** 20;

/** Bytes between two looks at the clock. Strings are skipped by the engine's own search. */
const STEP = 2 ** 18;

const [QUOTE, BACKSLASH, COMMA] = [0x22, 0x5c, 0x2c];
const [OPEN_LIST, CLOSE_LIST, OPEN_OBJECT, CLOSE_OBJECT] = [0x5b, 0x5d, 0x7b, 0x7d];

/**
 * The value of a text in UTF-8.
 * @param budget gets its values, counted by brackets and commas.
 * @throws ModelError `too-large`, a plain Error if it is no JSON.
 */
export async function parseJson(bytes: Uint8Array, budget: ModelBudget, slices: Slices): Promise<unknown> {
  const lists: unknown[][] = [];
  // The document without the items of the lists directly in it: such a list holds its place in `lists` instead.
  let rest = '';
  let list: unknown[] | null = null;
  // Where the text begins that is in no piece yet.
  let from = 0;
  let depth = 0;
  let values = 0;
  const claim = (): void => {
    requireAtMost(values, JSON_PIECE_LIMIT, 'values in one part of its JSON');
    budget.add({ json: values });
    values = 0;
  };
  let inString = false;
  let next = STEP;
  for (let at = 0; at < bytes.length; at += 1) {
    if (at >= next) {
      next = at + STEP;
      // A text that ends no list is refused before all of it is read.
      requireAtMost(values, JSON_LIMIT, 'values in its JSON');
      await slices.pauseIfDue();
    }
    if (inString) {
      at = bytes.indexOf(QUOTE, at);
      if (at < 0) break; // a text that ends in a string
      inString = isEscaped(bytes, at);
      continue;
    }
    const byte = bytes[at];
    inString = byte === QUOTE;
    const opens = byte === OPEN_LIST || byte === OPEN_OBJECT;
    const closes = byte === CLOSE_LIST || byte === CLOSE_OBJECT;
    if (opens) depth += 1;
    if (closes) depth -= 1;
    if (opens || byte === COMMA) values += 1;
    const isLong = values > PIECE || at - from > PIECE_BYTES;
    if (list !== null && ((closes && depth === 1) || (byte === COMMA && depth === 2 && isLong))) {
      claim();
      for (const item of parsed(`[${textOf(bytes, from, at)}]`) as unknown[]) list.push(item);
      if (closes) list = null;
      from = closes ? at : at + 1;
      await slices.pauseIfDue();
    } else if (list === null && byte === OPEN_LIST && depth === 2) {
      rest += `${textOf(bytes, from, at + 1)}${String(lists.length)}`;
      lists.push((list = []));
      from = at + 1;
    }
  }
  claim();
  const document = parsed(rest + textOf(bytes, from));
  if (typeof document !== 'object' || document === null || Array.isArray(document)) return document;
  return Object.fromEntries(
    Object.entries(document).map(([key, value]: [string, unknown]) => [
      key,
      Array.isArray(value) ? lists[Number(value[0])] : value,
    ]),
  );
}

/** Whether the character is preceded by an odd number of backslashes. */
export function isEscaped(bytes: Uint8Array, at: number): boolean {
  let first = at;
  while (bytes[first - 1] === BACKSLASH) first -= 1;
  return (at - first) % 2 === 1;
}

function textOf(bytes: Uint8Array, from: number, to?: number): string {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes.subarray(from, to));
  } catch (cause) {
    throw new Error('its JSON is broken', { cause });
  }
}

function parsed(text: string): unknown {
  requireAtMost(text.length, JSON_PIECE_BYTES, 'bytes in one part of its JSON');
  try {
    return JSON.parse(text) as unknown;
  } catch (cause) {
    throw new Error('its JSON is broken', { cause });
  }
}
