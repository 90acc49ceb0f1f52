// Requests a model's files, and the code that reads them.
// Imports nothing that takes long to run.
import { FORMAT_NAMES, type FormatNames } from '../../phong/model/format-names.js';
import { isDataUri } from '../../phong/fields/file-names.js';
import { type ExtraCode, extraCode } from './provided-code.js';
import type { Amounts } from '../../phong/model/budget.js';
import type { Content } from '../../phong/model/model.js';

/** What loads of models need of their code. */
interface ModelCode {
  /**
   * Loads a model and the files it refers to. @param from the request of the file at `url`, if
   * there is one already; or a file, whose `url` is for messages.
   * @throws ModelError, or the signal's reason after an abort. Nothing leaks then.
   */
  readonly modelContent: (
    url: URL,
    options: LoadOptions,
    from?: FileRequest | Blob | null,
  ) => Promise<Content>;
  /**
   * The model among files that were dropped or chosen; null for none. Where it is a picture that
   * holds a scene: what opens that in a viewer.
   */
  readonly droppedModel: (
    entries: readonly FileSystemEntry[],
    files: readonly File[],
  ) => Promise<File | ((viewer: HTMLElement) => void) | null>;
  /** Its `dispose` frees geometries and textures, but no images. */
  readonly ownedModel: (parts: Content['parts']) => Content;
  /** A content in a pose of its own, and the values of 4 bytes that it takes. */
  readonly movingCopy: (content: Content) => Content;
  readonly movingValues: (content: Content) => number;
  readonly Slices: new (signal: AbortSignal) => Slices;
}

/** Lets other tasks run between the steps of a loop. */
export interface Slices {
  map<Item, Result>(
    items: readonly Item[],
    work: (item: Item, i: number) => Result,
  ): Promise<Result[]>;
  pause(): Promise<void>;
}

export interface LoadOptions {
  /** Aborts the load; the promise then rejects with the signal's reason. */
  readonly signal: AbortSignal;
  /** Requests a file, until the signal is aborted. */
  readonly request: (url: URL, redirect: RequestRedirect) => FileRequest;
  /** Bytes received and expected, over all files requested so far; `total` is 0 while unknown. */
  readonly onProgress?: (loaded: number, total: number) => void;
  /**
   * Called with all that the model claims so far, before anything is allocated; what it throws ends
   * the load.
   */
  readonly onClaim?: (claimed: Amounts) => void;
  /** Sends WebGL's commands to the GPU. Call after an upload: the browser keeps its copy until then. */
  readonly flush?: () => void;
  /**
   * The model may refer to files on any http(s) origin. Otherwise: in its own folder or below only.
   */
  readonly anywhere: boolean;
  /**
   * The format, as a word such as `obj` or a media type. Empty, the default: as content, extension
   * and server tell.
   */
  readonly type?: string;
}

/** The code that loads models. */
export const modelCode = /* @__PURE__ */ extraCode<ModelCode>('models');

/** The code that reads a format. What it reads from is the extra's own. */
interface ReaderCode {
  readonly read: (source: never) => Promise<Content>;
}

export const readerCode = {
  glTF: /* @__PURE__ */ extraCode<ReaderCode>('glTF models'),
  PLY: /* @__PURE__ */ extraCode<ReaderCode>('PLY files'),
  STL: /* @__PURE__ */ extraCode<ReaderCode>('STL files'),
  OBJ: /* @__PURE__ */ extraCode<ReaderCode>('OBJ files'),
} as const satisfies Readonly<Record<FormatNames['name'], ExtraCode<ReaderCode>>>;

/**
 * Requests the code for a model beside its file, not after it: each request that waits for another
 * is a delay that the user sees. The file's name says which format; the content decides what is
 * read. What both chunks import is requested by the build (.ci/retried-imports.ts): by `import()`
 * Firefox 153 would never fetch it again after a failure
 * (https://bugzilla.mozilla.org/show_bug.cgi?id=2055211).
 */
function requestCode({ pathname }: URL) {
  const path = pathname.toLowerCase();
  const named = Object.values<FormatNames>(FORMAT_NAMES).filter(({ extensions }) =>
    extensions.some((extension) => path.endsWith(`.${extension}`)),
  );
  for (const code of [modelCode, ...named.map(({ name }) => readerCode[name])]) {
    code().catch(() => undefined); // reported when it is used
  }
}

/** Requests that no element has taken yet, by address and credentials. */
const early = new Map<string, { readonly request: FileRequest; readonly end: AbortController }>();

const earlyKey = (url: URL, crossOrigin: CrossOrigin) =>
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

interface RequestOptions {
  readonly signal: AbortSignal;
  readonly crossOrigin: CrossOrigin;
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

export function requestFile(
  url: URL,
  redirect: RequestRedirect,
  { signal, crossOrigin }: RequestOptions,
): FileRequest {
  const credentials = crossOrigin === 'use-credentials' ? 'include' : 'same-origin';
  const watch = new AbortController();
  const refusal = refusalOf(url, watch.signal);
  const response = fetch(url, { signal, redirect, credentials });
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
    const listener = (event: SecurityPolicyViolationEvent) => {
      const mine = event.blockedURI === address || event.blockedURI === url.origin;
      if (event.disposition === 'enforce' && mine) {
        resolve(event.effectiveDirective);
      }
    };
    document.addEventListener('securitypolicyviolation', listener, { signal });
  });
}
