// Loads a model: downloads it, detects the format and reads it. Works under a strict CSP: fetches
// no blob: or data: URL, needs no worker and no eval. Entry point of the code that reads models,
// fetched with the first one.
import { clip, listed } from '../../phong/fields/clip.js';
import type { FormatNames } from '../../phong/model/format-names.js';
import { isOutOfMemory } from '../../phong/model/limits.js';
import { type Content, ModelError } from '../../phong/model/model.js';
import { ModelBudget } from '../../phong/model/model-budget.js';
import { readerCode, type LoadOptions } from '../../viewer/extra.js';
import { byteFetcher } from './fetch-bytes.js';
import { DROP_TOGETHER, MissingFileError, openFile, type OpenedModel } from './user-files.js';
import { formatOf } from './format.js';
import {
  type DecodeImage,
  type ModelReader,
  neededCode,
  type ReadOptional,
} from './model-reader.js';
import { asUtf8 } from './encodings.js';
import { isMoving } from './moving-copy.js';
import { Slices } from './slices.js';
import { free } from './limits.js';
import { nameOf } from '../../phong/fields/file-names.js';
import { measureInSlices } from '../../phong/geometry/geometry-size.js';

export { Slices };

export { droppedModel } from './user-files.js';
export { ownedModel } from './model-reader.js';
export { movingCopy, movingValues } from './moving-copy.js';

type FileRequest = ReturnType<LoadOptions['request']>;

export interface ReadOptions extends LoadOptions {
  readonly decodeImage?: DecodeImage;
  /** What the model is shown without. Default: the console's warnings. */
  readonly warn?: (message: string) => void;
}

/**
 * Loads a model and the files it refers to. `data:` addresses are decoded, not fetched.
 * @param from the request of the file at `url`, if there is one already; or a file, whose `url` is
 * for messages.
 * @throws ModelError, or the signal's reason after an abort. Nothing leaks then.
 */
export async function modelContent(
  url: URL,
  options: ReadOptions,
  from: FileRequest | Blob | null = null,
): Promise<Content> {
  const { signal, type = '', warn = (message) => console.warn(message) } = options;
  const budget = new ModelBudget(options.onClaim);
  const isRequest = from === null || 'response' in from;
  const { name, read, linked } = isRequest
    ? openAddress(url, options, budget, from)
    : openFile(from, budget);
  const missing = new Map<string, string>();
  const optional = optionalReader(signal, missing);
  try {
    const file = await read();
    const slices = new Slices(signal);
    const bytes = asUtf8(file.bytes);
    const format = formatOf(name, bytes, { type, mediaType: file.type, address: url.href });
    const reader = await readerOf(format);
    signal.throwIfAborted();
    const model = await reader.read({ ...options, url, bytes, linked, optional, budget });
    free(bytes);
    try {
      // The bounds that framing and culling will need: the first frame would find them in one task.
      // A mesh whose vertices move measures its copy in its first pose.
      const geometries = new Set(model.parts.map(({ geometry }) => geometry));
      for (const geometry of geometries) {
        if (!isMoving(geometry)) {
          await measureInSlices(geometry, slices);
        }
      }
    } catch (error) {
      model.dispose();
      throw error;
    }
    if (missing.size > 0) {
      warn(missingText(name, missing));
    }
    const dropped = [...(model.dropped ?? [])];
    if (model.parts.every(({ look }) => look.opacity === 0)) {
      dropped.push('all of its surfaces, whose opacity is 0');
    }
    if (dropped.length > 0) {
      warn(`${nameOf(url)} is shown without ${listed(dropped)}.`);
    }
    return { ...model, missing: [...missing.keys()] };
  } catch (cause) {
    signal.throwIfAborted();
    if (cause instanceof ModelError) throw cause;
    if (isOutOfMemory(cause)) {
      throw new ModelError('too-large', `There is not enough memory to read ${name}.`, { cause });
    }
    const reason = cause instanceof Error ? cause.message : String(cause);
    throw new ModelError('bad-model', `The model cannot be read: ${reason} (${name}).`, { cause });
  }
}

/** The readers are this folder's, whoever requested them. */
const readerOf = async ({ name }: FormatNames): Promise<{ readonly read: ModelReader }> =>
  neededCode(readerCode[name](), `The code that reads ${name} files`) as Promise<{
    readonly read: ModelReader;
  }>;

function openAddress(
  url: URL,
  options: ReadOptions,
  budget: ModelBudget,
  request: FileRequest | null,
): OpenedModel {
  const fetchBytes = byteFetcher(options, budget);
  const { anywhere } = options;
  /** Where the model is: the address that answered. */
  let model = url;
  return {
    name: nameOf(url),
    read: async () => {
      const file = await fetchBytes(url, 'follow', request);
      model = file.from;
      return file;
    },
    // A redirect could lead out of the folder. If any address is allowed, it does no harm.
    linked: async (uri) =>
      (await fetchBytes(linkedUrl(uri, model, anywhere), anywhere ? 'follow' : 'error')).bytes,
  };
}

/** @param missing gets the reason for everything that is left out, by its name. */
function optionalReader(signal: AbortSignal, missing: Map<string, string>): ReadOptional {
  return async (name, read, use) => {
    const leaveOut = (error: unknown): null => {
      signal.throwIfAborted();
      if (isOutOfMemory(error)) throw error;
      missing.set(clip(name), reasonOf(name, error));
      return null;
    };
    let bytes: Awaited<ReturnType<typeof read>>;
    try {
      bytes = await read();
    } catch (error) {
      if (error instanceof ModelError && /^(too-large|csp)$/.test(error.code)) throw error;
      return leaveOut(error);
    }
    try {
      return await use(bytes);
    } catch (error) {
      if (error instanceof ModelError) throw error;
      return leaveOut(error);
    }
  };
}

/** A sentence. Messages of decoders go on from the file's name. */
function reasonOf(name: string, error: unknown): string {
  if (error instanceof MissingFileError) return DROP_TOGETHER;
  if (error instanceof ModelError) return error.message;
  return `${clip(name)} ${error instanceof Error ? error.message : String(error)}.`;
}

/** Most reasons in the warning. A material library can name thousands of images. */
const MOST_REASONS = 10;

function missingText(model: string, missing: ReadonlyMap<string, string>): string {
  const names = [...missing.keys()];
  const reasons = [...new Set(missing.values())].slice(0, MOST_REASONS);
  return `${model} is shown without ${String(names.length)} of the files that it names: ${listed(names)}. ${reasons.join(' ')}`;
}

/**
 * What the URL parser leaves in a path and a server may still take for `..` or a slash: some
 * unescape, once or twice, and some drop `;` and what follows it in a part of the path.
 */
const CLIMBS = /%(25)*(2f|5c)|(^|\/)(\.|%(25)*2e){2}(;|%(25)*3b|\/|$)/i;

/**
 * The address of the file that the model at `model` refers to as `uri`.
 * @param anywhere whether any http(s) origin and folder is allowed (`crossorigin` is set).
 * @throws ModelError `load-failed` if it is not allowed, or no address.
 */
export function linkedUrl(uri: string, model: URL, anywhere: boolean): URL {
  if (!URL.canParse(uri, model)) {
    throw new ModelError(
      'load-failed',
      `The file "${clip(uri)}", which ${nameOf(model)} names, has no valid address.`,
    );
  }
  const url = new URL(uri, model);
  if (anywhere && /^https?:$/.test(url.protocol)) return url;
  const folder = model.pathname.slice(0, model.pathname.lastIndexOf('/') + 1);
  const below =
    url.origin === model.origin &&
    url.protocol === model.protocol &&
    url.username === model.username &&
    url.password === model.password &&
    /^(https?|file):$/.test(url.protocol) &&
    url.pathname.startsWith(folder) &&
    !CLIMBS.test(url.pathname.slice(folder.length));
  if (below) return url;
  const fact = `The file "${clip(uri)}" is not in the folder of ${nameOf(model)}, which names it.`;
  throw new ModelError('load-failed', fact, {
    advice: 'Put it beside the model, or set crossorigin to allow it.',
  });
}
