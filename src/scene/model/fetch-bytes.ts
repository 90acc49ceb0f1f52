// How are a model's files downloaded? With progress, abort, a size limit, and errors that a page's author understands. Must not know
// what the bytes mean.
import { decodeDataUri, isDataUri } from './data-uri.js';
import { BYTE_LIMIT } from './limits.js';
import { ModelError } from './model.js';

/**
 * How long a server may send nothing, in milliseconds: before its answer, and between two parts of a file. Long enough for a server
 * that has to wake up first; a page that stays open for hours should not hold its connections for good.
 */
export const SILENCE_LIMIT_MS = 60_000;

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
  /** The media type that came with the bytes, once they are there; empty if none did. */
  readonly mediaType: () => string;
}

/** Requests a model's file at once, in parallel with the code that reads it. */
export function requestModel(url: URL, transfer: Transfer): ModelRequest {
  let mediaType = '';
  const fetchBytes = byteFetcher(transfer, (type) => {
    mediaType ||= type;
  });
  const bytes = fetchBytes(url, 'follow');
  bytes.catch(() => undefined); // the code that awaits it reports the error
  return { bytes, fetchBytes, mediaType: () => mediaType };
}

/**
 * A download function for the files of one model, which share size limit and progress.
 * @param onType called with the media type of each file that arrives; empty if it has none.
 */
export function byteFetcher(
  transfer: Transfer,
  onType: (type: string) => void = () => undefined,
): FetchBytes {
  let loaded = 0;
  let total = 0;
  let known = true;
  return async (url, redirect) => {
    transfer.signal.throwIfAborted();
    if (isDataUri(url.href)) {
      const { type, bytes } = decodeDataUri(url.href);
      onType(type);
      return bytes;
    }
    const download = new Download(url, transfer.signal);
    try {
      const response = await open(download, redirect, transfer);
      onType(response.headers.get('content-type') ?? '');
      const expected = expectedLength(response);
      if (expected === 0) known = false;
      total += expected;
      if (total > BYTE_LIMIT) throw tooLarge(url);
      const chunks: Uint8Array[] = [];
      let size = 0;
      const reader = response.body?.getReader();
      for (let chunk = await read(download, reader); chunk; chunk = await read(download, reader)) {
        chunks.push(chunk);
        size += chunk.byteLength;
        loaded += chunk.byteLength;
        // A compressed file counts as what it unpacks to. It is not unpacked any further.
        if (loaded > BYTE_LIMIT) throw tooLarge(url);
        transfer.onProgress?.(loaded, known && loaded <= total ? total : 0);
      }
      return joined(chunks, size);
    } finally {
      download.end();
    }
  };
}

/** One request. Ends when the load is aborted, and after {@link SILENCE_LIMIT_MS} without data. */
class Download {
  readonly url: URL;
  readonly #load: AbortSignal;
  readonly #request = new AbortController();
  #timer: ReturnType<typeof setTimeout> | undefined;
  #silent = false;

  constructor(url: URL, load: AbortSignal) {
    this.url = url;
    this.#load = load;
    load.addEventListener('abort', this.end);
    this.heard();
  }

  get signal(): AbortSignal {
    return this.#request.signal;
  }

  /** The server has sent something. */
  heard(): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => {
      this.#silent = true;
      this.end();
    }, SILENCE_LIMIT_MS);
  }

  /** Ends the request, and with it the connection if the file is not complete. */
  readonly end = (): void => {
    clearTimeout(this.#timer);
    this.#load.removeEventListener('abort', this.end);
    this.#request.abort();
  };

  /** Throws if that is why the request has failed. */
  throwIfEnded(): void {
    this.#load.throwIfAborted();
    if (!this.#silent) return;
    const seconds = String(SILENCE_LIMIT_MS / 1000);
    throw new ModelError(
      'load-failed',
      `${this.url.href} was given up: the server sent nothing for ${seconds} seconds.`,
    );
  }
}

async function open(
  download: Download,
  redirect: RequestRedirect,
  { crossOrigin }: Transfer,
): Promise<Response> {
  const { url, signal } = download;
  const credentials = crossOrigin === 'use-credentials' ? 'include' : 'same-origin';
  const policy = watchPolicy(url);
  let response: Response;
  try {
    response = await fetch(url, { signal, redirect, credentials });
  } catch (cause) {
    download.throwIfEnded();
    const directive = await policy.refusal();
    download.throwIfEnded();
    if (directive !== null) {
      throw new ModelError(
        'csp',
        `The page's Content-Security-Policy (${directive}) does not let it fetch ${url.href}. ` +
          'Allow that address there, or serve the file from an address that is allowed.',
        { cause },
      );
    }
    throw new ModelError(
      'load-failed',
      `${url.href} could not be fetched. Is the server reachable, and does it send CORS headers ` +
        'if it is another origin than the page?',
      { cause },
    );
  } finally {
    policy.stop();
  }
  download.heard();
  if (response.ok) return response;
  throw new ModelError(
    'load-failed',
    `${url.href} could not be fetched: the server answered ${String(response.status)} ${response.statusText}`.trim() +
      '. Check the address.',
  );
}

/** The announced length of the body, or 0 if unknown. For a compressed body the header gives the compressed length. */
function expectedLength(response: Response): number {
  if (response.headers.has('content-encoding')) return 0;
  const length = Number(response.headers.get('content-length') ?? 0);
  return Number.isFinite(length) && length > 0 ? length : 0;
}

function tooLarge(url: URL): ModelError {
  const limit = String(BYTE_LIMIT / 2 ** 20);
  return new ModelError(
    'too-large',
    `${url.href} makes the model larger than ${limit} MiB, the most that can be loaded.`,
  );
}

async function read(
  download: Download,
  reader: ReadableStreamDefaultReader<Uint8Array> | undefined,
): Promise<Uint8Array | undefined> {
  try {
    const value = (await reader?.read())?.value;
    download.heard();
    return value;
  } catch (cause) {
    download.throwIfEnded();
    throw new ModelError('load-failed', `The connection broke while ${download.url.href} was read.`, {
      cause,
    });
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
