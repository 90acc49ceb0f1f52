// How does an address become a model? Download, detect the format, read. Every failure is a ModelError with a code and a sentence.
// Works under a strict CSP: fetches no blob: or data: URL, needs no worker and no eval. Must not know elements or the renderer.
import { isOutOfMemory } from '../out-of-memory.js';
import { measureModel } from './bounds.js';
import { byteFetcher } from './fetch-bytes.js';
import { openFile, type OpenedModel } from './file-group.js';
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
  /** The format, as a word such as `obj` or a media type. Empty, the default: as content, extension and server tell. */
  readonly type?: string;
}

/**
 * Loads a model and the files it refers to. `data:` addresses are decoded, not fetched.
 * @param from the request of the file at `url`, if it was requested already; or a file, whose `url` is for messages only.
 * @throws ModelError, or the signal's reason after an abort. Nothing leaks then.
 */
export async function loadModel(
  url: URL,
  options: LoadOptions,
  from: FileRequest | Blob | null = null,
): Promise<Model> {
  const { signal, type = '' } = options;
  const isRequest = from === null || 'response' in from;
  const { name, read, linked, mediaType, complete } = isRequest
    ? openAddress(url, options, from)
    : openFile(from);
  const missing: string[] = [];
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
    const bytes = await read();
    const format = formatOf(name, bytes, { type, mediaType: mediaType() });
    const readModel = await format.reader().catch((cause: unknown) => {
      const message = `The code that reads ${format.name} files could not be fetched.`;
      throw new ModelError('load-failed', message, { cause });
    });
    signal.throwIfAborted();
    const model = await readModel({ url, bytes, signal, linked, optional });
    try {
      if (missing.length > 0) {
        if (complete) throw new ModelError('load-failed', missing.at(-1) ?? '');
        warnOfMissing(name, missing);
      }
      await measureModel(model, signal);
    } catch (error) {
      model.dispose();
      throw error;
    }
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

function openAddress(url: URL, options: LoadOptions, request: FileRequest | null): OpenedModel {
  let mediaType = '';
  const fetchBytes = byteFetcher(options, (type) => {
    mediaType ||= type; // the first file is the model
  });
  const anywhere = options.crossOrigin !== null;
  return {
    name: nameOf(url),
    read: () => fetchBytes(url, 'follow', request),
    // A redirect could lead out of the folder. If any address is allowed, it does no harm.
    linked: async (uri) => fetchBytes(linkedUrl(uri, url, anywhere), anywhere ? 'follow' : 'error'),
    mediaType: () => mediaType,
    complete: false,
  };
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
