// How does an address become a model? Download, detect the format, read. Every failure is a ModelError with a code and a sentence.
// Works under a strict CSP: fetches no blob: or data: URL, uses no worker and no eval. Must not know elements or the renderer.
import { isOutOfMemory } from '../out-of-memory.js';
import { byteFetcher } from './fetch-bytes.js';
import { formatOf, nameOf, type ModelSource } from './format.js';
import { linkedUrl } from './linked-url.js';
import { ModelError, type Model } from './model.js';
import type { CrossOrigin, FileRequest } from './request-file.js';

export {
  ModelError,
  type Model,
  type ModelErrorCode,
  type ModelLook,
  type ModelMotion,
  type ModelPart,
} from './model.js';
export type { CrossOrigin } from './request-file.js';

export interface LoadOptions {
  /** Aborts the load; the promise then rejects with the signal's reason. */
  readonly signal: AbortSignal;
  /** Bytes received and expected, over all files requested so far; `total` is 0 while unknown. */
  readonly onProgress?: (loaded: number, total: number) => void;
  /** Null: the model may only refer to files in its own folder or below. Otherwise: on any http(s) origin. */
  readonly crossOrigin: CrossOrigin;
}

/**
 * Loads the model at `url` and the files it refers to. `data:` addresses are decoded, not fetched.
 * @param request of the file at `url`, if it was requested already.
 * @throws ModelError, or the signal's reason after an abort. Nothing leaks then.
 */
export async function loadModel(
  url: URL,
  options: LoadOptions,
  request: FileRequest | null = null,
): Promise<Model> {
  const { signal, crossOrigin } = options;
  const fetchBytes = byteFetcher(options);
  try {
    const bytes = await fetchBytes(url, 'follow', request);
    const source: ModelSource = {
      url,
      bytes,
      signal,
      linked: async (uri) => {
        const anywhere = crossOrigin !== null;
        // A redirect could lead out of the folder. If any address is allowed, it does no harm.
        return fetchBytes(linkedUrl(uri, url, anywhere), anywhere ? 'follow' : 'error');
      },
    };
    const format = formatOf(url, bytes);
    const read = await format.reader().catch((cause: unknown) => {
      const message = `The code that reads ${format.name} files could not be fetched.`;
      throw new ModelError('load-failed', message, { cause });
    });
    signal.throwIfAborted();
    return await read(source);
  } catch (cause) {
    signal.throwIfAborted();
    if (cause instanceof ModelError) throw cause;
    if (isOutOfMemory(cause)) {
      const message = `The browser has not enough memory to read ${nameOf(url)}.`;
      throw new ModelError('too-large', message, { cause });
    }
    const reason = cause instanceof Error ? cause.message : String(cause);
    throw new ModelError('bad-model', `${nameOf(url)} is not a readable model: ${reason}`, { cause });
  }
}
