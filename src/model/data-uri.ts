// The bytes of a data: URI. Decoded here, because fetching one needs `connect-src data:`, which a strict CSP refuses.
import { fromBase64 } from './base64.js';
import { ModelError } from './model.js';
import { isDataUri } from './request-file.js';
import type { Slices } from './slices.js';

export interface DataUri {
  /** Media type without parameters, lower case; default `text/plain`. */
  readonly type: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
}

/** Percent-encoded or base64 (padding and white space optional). Rejects with a `bad-model` error for anything else. */
export async function decodeDataUri(uri: string, slices: Slices): Promise<DataUri> {
  const comma = uri.indexOf(',');
  if (!isDataUri(uri) || comma < 0) throw new ModelError('bad-model', 'A data: URI has no comma before its data.');
  // A fragment identifier is not part of the data.
  const end = uri.indexOf('#', comma);
  const { type, base64 } = dataHeader(uri.slice(0, comma));
  const octets = await octetsOf(uri.slice(comma + 1, end < 0 ? uri.length : end), slices);
  return { type, bytes: base64 ? await fromBase64(octets, slices) : octets };
}

/** What stands before the comma. */
export function dataHeader(header: string): { readonly type: string; readonly base64: boolean } {
  const [type, ...parameters] = header.slice('data:'.length).split(';');
  return {
    type: (type ?? '').trim().toLowerCase() || 'text/plain',
    base64: parameters.at(-1)?.trim().toLowerCase() === 'base64',
  };
}

/** Characters between two looks at the clock. */
const SLICE = 2 ** 16;

async function octetsOf(text: string, slices: Slices): Promise<Uint8Array<ArrayBuffer>> {
  const bytes = new Uint8Array(text.length);
  let length = 0;
  for (let at = 0; at < text.length;) {
    for (const end = Math.min(at + SLICE, text.length); at < end; length += 1) {
      const escaped = text[at] === '%' && /^[0-9a-f]{2}$/i.test(text.slice(at + 1, at + 3));
      bytes[length] = escaped ? parseInt(text.slice(at + 1, at + 3), 16) : text.charCodeAt(at);
      at += escaped ? 3 : 1;
    }
    await slices.pauseIfDue();
  }
  return bytes.subarray(0, length);
}
