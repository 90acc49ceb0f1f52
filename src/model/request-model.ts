// Requests a model's first file, and the code that reads it. Imports nothing that takes long to run.
import { FORMAT_NAMES, type FormatNames } from './format-names.js';
import { lazyCode } from './lazy-code.js';
import { type CrossOrigin, type FileRequest, isDataUri, requestFile } from './request-file.js';

/** The code that loads models. */
export const modelCode = /* @__PURE__ */ lazyCode(() => import('./model-content.js'), 'models');

/**
 * Requests the code for a model beside its file, not after it: each request that waits for another is a delay that the
 * user sees. The file's name says which format; the content decides what is read. What both chunks import is not
 * requested here: after a failure Firefox would never fetch it again.
 */
export function requestCode({ pathname }: URL): void {
  const path = pathname.toLowerCase();
  const named = Object.values<FormatNames>(FORMAT_NAMES).filter(({ extensions }) =>
    extensions.some((extension) => path.endsWith(`.${extension}`)),
  );
  for (const { code } of [{ code: modelCode }, ...named]) code().catch(() => undefined); // reported when it is used
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
export function requestModelFile(
  url: URL,
  options: { readonly signal: AbortSignal; readonly crossOrigin: CrossOrigin },
): FileRequest {
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
    end.abort();
  }
  early.clear();
}
