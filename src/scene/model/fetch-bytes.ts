// How are a model's files downloaded? With progress, abort, a size limit, and errors that a page's author understands. Must not know
// what the bytes mean.
import { decodeDataUri, isDataUri } from './data-uri.js';
import { ModelError } from './model.js';

/** Largest size of one model in bytes, all its files together. Browsers' largest buffers are about twice this. */
export const BYTE_LIMIT = 2 ** 30;

export type CrossOrigin = 'anonymous' | 'use-credentials' | null;

export interface Transfer {
  readonly signal: AbortSignal;
  readonly crossOrigin: CrossOrigin;
  /** Bytes received and expected, over all files requested so far; `total` is 0 while unknown. */
  readonly onProgress?: ((loaded: number, total: number) => void) | undefined;
}

export type FetchBytes = (url: URL, redirect: RequestRedirect) => Promise<Uint8Array<ArrayBuffer>>;

/** A model's file being downloaded, and the download function for the files that it refers to. */
export interface ModelRequest {
  readonly bytes: Promise<Uint8Array<ArrayBuffer>>;
  readonly fetchBytes: FetchBytes;
}

/** Requests a model's file at once, in parallel with the code that reads it. */
export function requestModel(url: URL, transfer: Transfer): ModelRequest {
  const fetchBytes = byteFetcher(transfer);
  const bytes = fetchBytes(url, 'follow');
  bytes.catch(() => undefined); // the code that awaits it reports the error
  return { bytes, fetchBytes };
}

/** A download function for the files of one model, which share size limit and progress. */
export function byteFetcher(transfer: Transfer): FetchBytes {
  let loaded = 0;
  let total = 0;
  let known = true;
  return async (url, redirect) => {
    const { signal } = transfer;
    signal.throwIfAborted();
    if (isDataUri(url.href)) return decodeDataUri(url.href).bytes;
    const response = await open(url, redirect, transfer);
    const expected = expectedLength(response);
    if (expected === 0) known = false;
    total += expected;
    if (total > BYTE_LIMIT) throw await tooLarge(url, response);
    const chunks: Uint8Array[] = [];
    let size = 0;
    const reader = response.body?.getReader();
    for (let chunk = await read(url, signal, reader); chunk; chunk = await read(url, signal, reader)) {
      chunks.push(chunk);
      size += chunk.byteLength;
      loaded += chunk.byteLength;
      if (loaded > BYTE_LIMIT) {
        await reader?.cancel();
        throw await tooLarge(url, null);
      }
      transfer.onProgress?.(loaded, known && loaded <= total ? total : 0);
    }
    return joined(chunks, size);
  };
}

async function open(url: URL, redirect: RequestRedirect, transfer: Transfer): Promise<Response> {
  const { signal, crossOrigin } = transfer;
  const credentials = crossOrigin === 'use-credentials' ? 'include' : 'same-origin';
  const policy = watchPolicy(url);
  let response: Response;
  try {
    response = await fetch(url, { signal, redirect, credentials });
  } catch (cause) {
    signal.throwIfAborted();
    const directive = await policy.refusal();
    signal.throwIfAborted();
    if (directive !== null) {
      throw new ModelError(
        'csp',
        `The page's Content-Security-Policy (${directive}) does not let it fetch ${url.href}. ` +
          'Allow that address there, or serve the file from an address that is allowed.',
        { cause },
      );
    }
    throw new ModelError('load-failed', `${url.href} could not be fetched. ${adviceFor(url)}`, { cause });
  } finally {
    policy.stop();
  }
  if (response.ok) return response;
  await response.body?.cancel();
  throw new ModelError(
    'load-failed',
    `${url.href} could not be fetched: the server answered ${String(response.status)} ${response.statusText}`.trim() +
      '. Check the address.',
  );
}

/** What can be done where fetching an address gave no answer. */
const adviceFor = (url: URL): string =>
  url.protocol === 'file:'
    ? 'A page opened from disk may not read files: serve the folder, with `npx serve` or `python3 -m http.server`.'
    : 'Is the server reachable, and does it send CORS headers if it is another origin than the page?';

/** The announced length of the body, or 0 if unknown. For a compressed body the header gives the compressed length. */
function expectedLength(response: Response): number {
  if (response.headers.has('content-encoding')) return 0;
  const length = Number(response.headers.get('content-length') ?? 0);
  return Number.isFinite(length) && length > 0 ? length : 0;
}

async function tooLarge(url: URL, response: Response | null): Promise<ModelError> {
  await response?.body?.cancel();
  return new ModelError(
    'too-large',
    `${url.href} makes the model larger than 1 GiB, the most that can be loaded.`,
  );
}

async function read(
  url: URL,
  signal: AbortSignal,
  reader: ReadableStreamDefaultReader<Uint8Array> | undefined,
): Promise<Uint8Array | undefined> {
  try {
    return (await reader?.read())?.value;
  } catch (cause) {
    signal.throwIfAborted();
    throw new ModelError('load-failed', `The connection broke while ${url.href} was read.`, { cause });
  }
}

function joined(chunks: readonly Uint8Array[], size: number): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(size);
  let at = 0;
  for (const chunk of chunks) {
    bytes.set(chunk, at);
    at += chunk.byteLength;
  }
  return bytes;
}

// A fetch refused by CSP rejects like a network failure. The event that tells them apart is queued and can arrive later.
const POLICY_EVENT_WAIT_MS = 100;

interface PolicyWatch {
  /** The directive that refused the fetch, or null. */
  refusal(): Promise<string | null>;
  stop(): void;
}

function watchPolicy(url: URL): PolicyWatch {
  if (typeof document === 'undefined') return { refusal: () => Promise.resolve(null), stop: () => undefined };
  let report: (directive: string) => void = () => undefined;
  const directive = new Promise<string>((resolve) => {
    report = resolve;
  });
  const address = url.href.split('#', 1)[0];
  const listener = (event: SecurityPolicyViolationEvent): void => {
    const mine = event.blockedURI === address || event.blockedURI === url.origin;
    if (event.disposition === 'enforce' && mine) report(event.effectiveDirective);
  };
  document.addEventListener('securitypolicyviolation', listener);
  return {
    refusal: () => {
      const late = new Promise<null>((resolve) => {
        setTimeout(() => {
          resolve(null);
        }, POLICY_EVENT_WAIT_MS);
      });
      return Promise.race([directive, late]);
    },
    stop: () => {
      document.removeEventListener('securitypolicyviolation', listener);
    },
  };
}
