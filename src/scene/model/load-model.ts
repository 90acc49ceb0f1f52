// How does an address become a model? Download, detect the format, read. Every failure is a ModelError with a code and a sentence.
// Works under a strict CSP: fetches no blob: or data: URL, uses no worker and no eval. Must not know elements or the renderer.
import { isOutOfMemory } from '../out-of-memory.js';
import { type CrossOrigin, type ModelRequest, requestModel } from './fetch-bytes.js';
import type { FileRequest } from './file-group.js';
import { formatOf, nameOf, type ModelSource } from './format.js';
import { linkedUrl } from './linked-url.js';
import { ModelError, type Model } from './model.js';

export { ModelError, type Model, type ModelErrorCode, type ModelLook, type ModelPart } from './model.js';
export type { CrossOrigin } from './fetch-bytes.js';

export interface LoadOptions {
  /** Aborts the load; the promise then rejects with the signal's reason. */
  readonly signal: AbortSignal;
  /** Bytes received and expected, over all files requested so far; `total` is 0 while unknown. */
  readonly onProgress?: (loaded: number, total: number) => void;
  /** Null: the model may only refer to files in its own folder or below. Otherwise: on any http(s) origin. */
  readonly crossOrigin: CrossOrigin;
  /** The format, as a word such as `obj` or a media type. Empty, the default: as content, extension and server tell. */
  readonly type?: string;
}

/**
 * Loads the model at `url` and the files it refers to. `data:` addresses are decoded, not fetched.
 * @throws ModelError, or the signal's reason after an abort. Nothing leaks then.
 */
export async function loadModel(
  url: URL,
  options: LoadOptions,
  request: ModelRequest | FileRequest = requestModel(url, options),
): Promise<Model> {
  const { signal, crossOrigin, type = '' } = options;
  const name = 'name' in request ? request.name : nameOf(url);
  const missing: string[] = [];
  const linked: ModelSource['linked'] = async (uri) => {
    if ('linked' in request) return request.linked(uri);
    const { fetchBytes } = request;
    const anywhere = crossOrigin !== null;
    // A redirect could lead out of the folder. If any address is allowed, it does no harm.
    return fetchBytes(linkedUrl(uri, url, anywhere), anywhere ? 'follow' : 'error');
  };
  const optional: ModelSource['optional'] = async (uri) => {
    try {
      return await linked(uri);
    } catch (error) {
      if (!(error instanceof ModelError && error.code === 'load-failed')) throw error;
      missing.push(error.message);
      return null;
    }
  };
  try {
    const bytes = await request.bytes;
    const format = formatOf(name, bytes, { type, mediaType: request.mediaType() });
    const read = await format.reader().catch((cause: unknown) => {
      const message = `The code that reads ${format.name} files could not be fetched.`;
      throw new ModelError('load-failed', message, { cause });
    });
    signal.throwIfAborted();
    const model = await read({ url, bytes, signal, linked, optional });
    if (missing.length === 0) return model;
    if ('complete' in request && request.complete) {
      model.dispose();
      throw new ModelError('load-failed', missing.at(-1) ?? '');
    }
    warnOfMissing(name, missing);
    return model;
  } catch (cause) {
    signal.throwIfAborted();
    if (cause instanceof ModelError) throw cause;
    if (isOutOfMemory(cause)) {
      const message = `The browser has not enough memory to read ${name}.`;
      throw new ModelError('too-large', message, { cause });
    }
    const reason = cause instanceof Error ? cause.message : String(cause);
    throw new ModelError('bad-model', `${name} is not a readable model: ${reason}`, { cause });
  }
}

/** A material library can name thousands of images. */
const MOST_LISTED = 10;

function warnOfMissing(name: string, messages: readonly string[]): void {
  const more = messages.length - MOST_LISTED;
  console.warn(
    `${name} is shown without ${String(messages.length)} of the files that it names. ` +
      messages.slice(0, MOST_LISTED).join(' ') +
      (more > 0 ? ` And ${String(more)} more.` : ''),
  );
}
