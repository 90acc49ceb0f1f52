// Requests a model's files, and the code that reads them; and what a file is called in messages.
// Imports nothing that takes long to run.
import { FORMAT_NAMES, type FormatNames } from './format-names.js';
import { lazyCode } from './lazy-code.js';

/** The code that loads models. */
export const modelCode = /* @__PURE__ */ lazyCode(
  () => import('../../extras/models/model-content.js'),
  'models',
);

/**
 * Requests the code for a model beside its file, not after it: each request that waits for another
 * is a delay that the user sees. The file's name says which format; the content decides what is
 * read. What both chunks import is not requested here: after a failure Firefox 153 never fetches it
 * again (https://bugzilla.mozilla.org/show_bug.cgi?id=2055211).
 */
export function requestCode({ pathname }: URL): void {
  const path = pathname.toLowerCase();
  const named = Object.values<FormatNames>(FORMAT_NAMES).filter(({ extensions }) =>
    extensions.some((extension) => path.endsWith(`.${extension}`)),
  );
  for (const { code } of [{ code: modelCode }, ...named]) {
    code().catch(() => undefined); // reported when it is used
  }
}

/** Requests that no element has taken yet, by address and credentials. */
const early = new Map<string, { readonly request: FileRequest; readonly end: AbortController }>();

const earlyKey = (url: URL, crossOrigin: CrossOrigin): string =>
  `${url.href} ${String(crossOrigin === 'use-credentials')}`;

/** Requests a model's file and its code for an element that is about to be defined. */
export function requestEarly(url: URL, crossOrigin: CrossOrigin): void {
  const key = earlyKey(url, crossOrigin);
  if (early.has(key) || isDataUri(url.href)) return;
  const end = new AbortController();
  early.set(key, { request: requestFile(url, 'follow', { signal: end.signal, crossOrigin }), end });
  requestCode(url);
}

/** The request of a model's first file: the early one, if there is one. */
export function requestModelFile(url: URL, options: RequestOptions): FileRequest {
  requestCode(url);
  const key = earlyKey(url, options.crossOrigin);
  const found = early.get(key);
  if (found === undefined) return requestFile(url, 'follow', options);
  early.delete(key);
  const { signal } = options;
  signal.addEventListener('abort', () => found.end.abort(signal.reason));
  return found.request;
}

/** Ends the early requests that no element has taken. */
export function endEarly(): void {
  for (const { request, end } of early.values()) {
    request.stop();
    end.abort('unclaimed');
  }
  early.clear();
}

export type CrossOrigin = 'anonymous' | 'use-credentials' | null;

export type Fetch = (url: URL, init: RequestInit) => Promise<Response>;

interface RequestOptions {
  readonly signal: AbortSignal;
  readonly crossOrigin: CrossOrigin;
  /** In place of the browser's. */
  readonly fetch?: Fetch | undefined;
}

export interface FileRequest {
  readonly response: Promise<Response>;
  /**
   * The directive of the page's Content-Security-Policy that refused the request. Stays pending
   * otherwise.
   */
  readonly refusal: Promise<string>;
  /** Stops waiting for a refusal. */
  stop(): void;
}

/** Not requested: a strict policy forbids fetching it, and what it holds is there already. */
export const isDataUri = (uri: string): boolean => /^data:/i.test(uri);

export function requestFile(
  url: URL,
  redirect: RequestRedirect,
  { signal, crossOrigin, fetch: request = fetch }: RequestOptions,
): FileRequest {
  const credentials = crossOrigin === 'use-credentials' ? 'include' : 'same-origin';
  const watch = new AbortController();
  const refusal = refusalOf(url, watch.signal);
  const response = request(url, { signal, redirect, credentials });
  response.catch(() => undefined); // the code that awaits it reports the error
  const stop = (): void => watch.abort('answered');
  return { response, refusal, stop };
}

/**
 * A fetch refused by the policy rejects like a network failure. Only an event distinguishes the
 * two.
 */
function refusalOf(url: URL, signal: AbortSignal): Promise<string> {
  const address = url.href.split('#', 1)[0];
  return new Promise((resolve) => {
    if (typeof document === 'undefined') return;
    const listener = (event: SecurityPolicyViolationEvent): void => {
      const mine = event.blockedURI === address || event.blockedURI === url.origin;
      if (event.disposition === 'enforce' && mine) {
        resolve(event.effectiveDirective);
      }
    };
    document.addEventListener('securitypolicyviolation', listener, { signal });
  });
}

/** The name of a `File`; `model` for a `Blob`, which has none. */
export const fileName = (file: Blob): string =>
  ('name' in file ? String(file.name) : '') || 'model';

/**
 * The last part of an address, for messages: addresses can be long. Those that have none give their
 * host.
 */
export function nameOf(url: URL): string {
  if (url.protocol === 'data:') return 'the data: URI';
  const last = url.pathname.slice(url.pathname.lastIndexOf('/') + 1);
  if (last === '') return url.host === '' ? 'the file' : url.host;
  try {
    return decodeURIComponent(last);
  } catch {
    return last; // a percent sign that escapes nothing
  }
}
