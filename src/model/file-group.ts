// The files of a model that comes from the user's disk. Files dropped together are found by the paths that the model
// names; nothing is fetched.
import { listed } from '../fields/clip.js';
import { fileName } from './file-name.js';
import type { ModelBudget } from './model-budget.js';
import { ModelError } from './model.js';

interface FileGroup {
  /** All files by their paths, which have no slash in front. The model is one of them. */
  readonly files: ReadonlyMap<string, Blob>;
  /** The model's own path. */
  readonly path: string;
  /** Why none of them can be shown, if so. */
  readonly problem: ModelError | null;
}

const groups = new WeakMap<Blob, FileGroup>();

/** From now on `model` is loaded with these files. */
export function setFileGroup(model: Blob, group: FileGroup): void {
  groups.set(model, group);
}

/** Where a model's bytes come from. */
export interface OpenedModel {
  /** Its address or name, for messages and for the extension. */
  readonly name: string;
  readonly read: () => Promise<Uint8Array<ArrayBuffer>>;
  /** Reads a file that the model names. */
  readonly linked: (uri: string) => Promise<Uint8Array<ArrayBuffer>>;
  /** The media type that came with the bytes, once they are there; empty if none did. */
  readonly mediaType: () => string;
}

/** A file, and the files of its group that it names. */
export function openFile(model: Blob, budget: ModelBudget): OpenedModel {
  const name = fileName(model);
  const group = groups.get(model) ?? { files: new Map([[name, model]]), path: name, problem: null };
  const missing = new Set<string>();

  const bytesOf = async (file: Blob): Promise<Uint8Array<ArrayBuffer>> => {
    budget.add({ bytes: file.size });
    try {
      return new Uint8Array(await file.arrayBuffer());
    } catch (cause) {
      // Files can be changed or deleted after they were chosen.
      throw new ModelError('load-failed', `${name} could not be read. Was it moved or changed? Choose it again.`, {
        cause,
      });
    }
  };

  return {
    name,
    read: async () => {
      if (group.problem) throw group.problem;
      return bytesOf(model);
    },
    mediaType: () => model.type,
    linked: async (uri) => {
      const file = fileNamed(uri, group);
      if (file) return bytesOf(file);
      missing.add(lastOf(pathOf(uri, group.path) ?? uri));
      // Files that the model asks for at the same time are listed too.
      await new Promise((resolve) => setTimeout(resolve));
      throw new MissingFileError(name, [...missing]);
    },
  };
}

export const DROP_TOGETHER = 'Drop them together with it, or drop the folder that holds them all.';

/** Files that a model from the user's disk names did not come with it. */
export class MissingFileError extends ModelError {
  constructor(model: string, names: readonly string[]) {
    super('load-failed', `${model} names files that did not come with it: ${listed(names)}. ${DROP_TOGETHER}`);
  }
}

/** Exactly the path named; else one that differs in case; else the only file of that name, in whatever folder. */
function fileNamed(uri: string, { files, path }: FileGroup): Blob | undefined {
  const wanted = pathOf(uri, path);
  if (wanted === null) return undefined;
  const exact = files.get(wanted);
  if (exact) return exact;
  const entries = [...files];
  const lower = wanted.toLowerCase();
  const sameLetters = entries.find(([known]) => known.toLowerCase() === lower);
  if (sameLetters) return sameLetters[1];
  const sameName = entries.filter(([known]) => lastOf(known).toLowerCase() === lastOf(lower));
  return sameName.length === 1 ? sameName[0]?.[1] : undefined;
}

/** The path that an address names, seen from the file at `base`; null if it is no relative address. */
function pathOf(uri: string, base: string): string | null {
  try {
    const root = 'file:///';
    const folder = base.split('/').map(encodeURIComponent).join('/');
    const url = new URL(uri, new URL(folder, root));
    return url.protocol === 'file:' ? decodeURIComponent(url.pathname.slice(1)) : null;
  } catch {
    return null;
  }
}

/** A path's last part. Paths from Windows have backslashes. */
const lastOf = (path: string): string => path.slice(Math.max(path.lastIndexOf('/'), path.lastIndexOf('\\')) + 1);
