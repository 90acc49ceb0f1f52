// Downloads a model's files with progress, abort, limits of size and silence, and errors for the
// page's author.
import { decodeDataUri } from './encodings.js';
import type { FileBytes } from './model-reader.js';
import { requireAtMost } from '../../phong/model/budget.js';
import { ModelError } from '../../phong/model/model.js';
import type { ModelBudget } from '../../phong/model/model-budget.js';
import type { LoadOptions } from '../../viewer/extra.js';
import { Slices } from './slices.js';
import { FILE_LIMIT } from './limits.js';
import { turnsOf } from './turns.js';
import { clip } from '../../phong/fields/clip.js';
import { isDataUri, nameOf } from '../../phong/fields/file-names.js';

/**
 * How long a server may send nothing, in milliseconds: before its answer, and between two parts of
 * a file. Long enough for a server that has to wake up first; a page that stays open for hours
 * should not hold its connections for good.
 */
export const SILENCE_LIMIT_MS = 60_000;

/** `signal`: to be aborted after a failure too, which ends the other requests of the model. */
type Transfer = Pick<LoadOptions, 'signal' | 'request' | 'onProgress'>;

type FileRequest = ReturnType<Transfer['request']>;

/** Downloads a file; `request` if it was requested already. */
type FetchBytes = (
  url: URL,
  redirect: RequestRedirect,
  request?: FileRequest | null,
) => Promise<FetchedBytes>;

interface FetchedBytes extends FileBytes {
  /** The address that answered: another one after a redirect. */
  readonly from: URL;
}

/** A download function for the files of one model, which share budget and progress. */
export function byteFetcher(transfer: Transfer, budget: ModelBudget): FetchBytes {
  const { signal } = transfer;
  let loaded = 0;
  let total = 0;
  let isTotalKnown = true;
  let claimed = 0;
  /** When data came last, for any of the files: the others may wait for their turn. */
  const heard = { at: 0 };
  /**
   * What is announced, or has come without that. A compressed file counts as what it unpacks to.
   */
  const claim = (bytes: number): void => {
    if (bytes <= claimed) return;
    budget.add({ bytes: bytes - claimed });
    claimed = bytes;
  };
  let files = 0;
  const inTurn = turnsOf(AT_ONCE);
  const load: FetchBytes = async (url, redirect, request) => {
    signal.throwIfAborted();
    if (isDataUri(url.href)) {
      const file = await decodeDataUri(url.href, new Slices(signal));
      budget.add({ bytes: file.bytes.byteLength });
      return { ...file, from: url };
    }
    requireAtMost(++files, FILE_LIMIT, 'files');
    const response = await answerTo(url, request ?? transfer.request(url, redirect), signal, heard);
    const type = response.headers.get('content-type') ?? '';
    const from = new URL(response.url || url);
    const expected = expectedLength(response);
    if (expected === 0) {
      isTotalKnown = false;
    }
    total += expected;
    const reader = response.body?.getReader();
    try {
      claim(total);
      // As long as announced: joining chunks takes as much memory again, and 140 ms for 200 MB.
      const whole = new Uint8Array(expected);
      const chunks: Uint8Array[] = [];
      let size = 0;
      const next = () => read(url, signal, heard, reader);
      for (let chunk = await next(); chunk; chunk = await next()) {
        if (chunks.length === 0 && size + chunk.byteLength <= expected) {
          whole.set(chunk, size);
        } else {
          chunks.push(chunk);
        }
        size += chunk.byteLength;
        loaded += chunk.byteLength;
        claim(loaded);
        transfer.onProgress?.(loaded, isTotalKnown && loaded <= total ? total : 0);
      }
      // Another length may have been announced than came, or none.
      const begun = size - chunks.reduce((sum, { byteLength }) => sum + byteLength, 0);
      const pieces = [whole.subarray(0, begun), ...chunks];
      const bytes = size === expected ? whole : await new Slices(signal).joined(pieces);
      requireContent(bytes, nameOf(url));
      return { bytes, type, from };
    } catch (error) {
      reader?.cancel().catch(ignored); // the rest is neither sent nor unpacked
      throw error;
    }
  };
  return (...request) => inTurn(1, () => load(...request));
}

/** The first words of a pointer in the version control of a file that is kept elsewhere. */
const POINTER = /^version https?:\/\/(git-lfs|hawser)\.github\.com\//;

/** @throws ModelError `bad-model` for a file of Git LFS that was published without its content. */
export function requireContent(bytes: Uint8Array, name: string): void {
  if (!POINTER.test(String.fromCharCode(...bytes.subarray(0, 64)))) return;
  throw new ModelError('bad-model', `${name} is only a pointer of Git LFS to the file.`, {
    advice: 'Publish the file itself: `git lfs pull` fetches it.',
  });
}

/** Files of one model that are requested at a time. Browsers open six connections to a host. */
const AT_ONCE = 8;

async function answerTo(
  url: URL,
  request: FileRequest,
  signal: AbortSignal,
  heard: { at: number },
): Promise<Response> {
  let response: Response;
  try {
    response = await inTime(url, heard, request.response);
  } catch (cause) {
    signal.throwIfAborted();
    if (cause instanceof ModelError) throw cause;
    const directive = await Promise.race([request.refusal, later(POLICY_EVENT_WAIT_MS)]);
    signal.throwIfAborted();
    if (directive !== null) {
      const what = `${nameOf(url)} from ${url.origin}`;
      const fact = `The page's Content-Security-Policy (${directive}) does not let it fetch ${what}.`;
      const advice = 'Allow that address there, or serve the file from an address that is allowed.';
      throw new ModelError('csp', fact, { cause, advice });
    }
    throw unanswered(url, cause);
  } finally {
    request.stop();
  }
  if (response.ok) return response;
  response.body?.cancel().catch(ignored); // its connection may have broken off already
  const status = `${String(response.status)} ${response.statusText}`.trim();
  throw new ModelError('load-failed', `The server answered ${status} for ${nameOf(url)}.`);
}

const ignored = (): void => undefined;

/** Fetching an address gave no answer: why that may be, and what can be done. */
function unanswered(url: URL, cause: unknown): ModelError {
  if (url.protocol === 'file:') {
    const fact = `A page opened from disk may not read files, such as ${nameOf(url)}.`;
    const advice = 'Serve the folder, with `npx serve` or `python3 -m http.server`.';
    return new ModelError('load-failed', fact, { cause, advice });
  }
  if (url.protocol === 'blob:') {
    const fact = 'This blob: address leads to no data: it was revoked, or another page made it.';
    return new ModelError('load-failed', fact, { cause });
  }
  if (!/^https?:$/.test(url.protocol)) {
    const fact = `No file can be fetched from an address that begins with "${clip(url.protocol)}".`;
    return new ModelError('load-failed', fact, { cause });
  }
  return new ModelError('load-failed', `No answer came for ${nameOf(url)}.`, {
    cause,
    advice: `Is the server ${url.host} reachable, and does it send CORS headers if it is another origin than the page?`,
    logged: true,
  });
}

// The event of a refusal is queued and can arrive after the fetch has rejected.
const POLICY_EVENT_WAIT_MS = 100;

const later = (milliseconds: number): Promise<null> =>
  new Promise((resolve) => setTimeout(resolve, milliseconds, null));

/**
 * The announced length of the body, or 0 if unknown. For a compressed body the header gives the
 * compressed length.
 */
function expectedLength(response: Response): number {
  if (response.headers.has('content-encoding')) return 0;
  const length = Number(response.headers.get('content-length') ?? 0);
  return Number.isFinite(length) && length > 0 ? length : 0;
}

async function read(
  url: URL,
  signal: AbortSignal,
  heard: { at: number },
  reader: ReadableStreamDefaultReader<Uint8Array> | undefined,
): Promise<Uint8Array | undefined> {
  if (reader === undefined) return undefined;
  try {
    return (await inTime(url, heard, reader.read())).value;
  } catch (cause) {
    signal.throwIfAborted();
    if (cause instanceof ModelError) throw cause;
    throw new ModelError('load-failed', `The connection broke while ${nameOf(url)} was read.`, {
      cause,
    });
  }
}

/**
 * What the server sends next. Rejects after {@link SILENCE_LIMIT_MS} without data for any file of
 * the load.
 */
async function inTime<T>(url: URL, heard: { at: number }, next: Promise<T>): Promise<T> {
  let timer: ReturnType<typeof setTimeout> | undefined;
  const fact = `No data came for ${String(SILENCE_LIMIT_MS / 1000)} seconds, so ${nameOf(url)} was given up.`;
  const begun = performance.now();
  const silence = new Promise<never>((_, reject) => {
    const wait = (): void => {
      const rest = Math.max(begun, heard.at) + SILENCE_LIMIT_MS - performance.now();
      if (rest > 0) {
        timer = setTimeout(wait, rest);
      } else {
        reject(new ModelError('load-failed', fact));
      }
    };
    wait();
  });
  try {
    const data = await Promise.race([next, silence]);
    heard.at = performance.now();
    return data;
  } finally {
    clearTimeout(timer);
  }
}
