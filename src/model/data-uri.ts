// The bytes of a data: URI. Decoded here, because fetching one needs `connect-src data:`, which a strict CSP refuses.
import { ModelError } from './model.js';
import { isDataUri } from './request-file.js';

export interface DataUri {
  /** Media type without parameters, lower case; default `text/plain`. */
  readonly type: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
}

/** Percent-encoded or base64 (padding and white space optional). Throws a `bad-model` error for anything else. */
export function decodeDataUri(uri: string): DataUri {
  const comma = uri.indexOf(',');
  if (!isDataUri(uri) || comma < 0)
    throw new ModelError('bad-model', 'A data: URI has no comma before its data.');
  const [type, ...parameters] = uri.slice('data:'.length, comma).split(';');
  const base64 = parameters.at(-1)?.trim().toLowerCase() === 'base64';
  // A fragment identifier is not part of the data.
  const [body = ''] = uri.slice(comma + 1).split('#', 1);
  // Skip unescaping for base64, which has no percent signs: a model's data is long.
  const octets = body.includes('%') ? unescapeOctets(body) : body;
  return {
    type: (type ?? '').trim().toLowerCase() || 'text/plain',
    bytes: base64 ? fromBase64(octets) : fromOctets(octets),
  };
}

function unescapeOctets(text: string): string {
  return text.replace(/%([0-9a-f]{2})/gi, (_, hex: string) => String.fromCharCode(parseInt(hex, 16)));
}

function fromBase64(text: string): Uint8Array<ArrayBuffer> {
  try {
    return fromOctets(atob(text));
  } catch (cause) {
    throw new ModelError('bad-model', 'A data: URI holds broken base64.', { cause });
  }
}

function fromOctets(text: string): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i += 1) bytes[i] = text.charCodeAt(i);
  return bytes;
}
