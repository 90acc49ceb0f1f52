// The files of a model from the user's disk, dropped or chosen together: which of them is the
// model, and which ones it names. Found by their paths; nothing is fetched.
import { listed } from '../../phong/fields/clip.js';
import { requireContent } from './fetch-bytes.js';
import { modelExtensions, supportedFormats } from './format.js';
import type { FileBytes } from './model-reader.js';
import { ModelError } from '../../phong/model/model.js';
import type { ModelBudget } from '../../phong/model/model-budget.js';
import { fileName } from '../../phong/fields/file-names.js';

/**
 * Most files of a dropped folder. Models come with hundreds at most; a whole disk should not be
 * walked.
 */
const FILE_LIMIT = 5000;

interface FileGroup {
  /** All files by their paths, which have no slash in front. The model is one of them. */
  readonly files: ReadonlyMap<string, Blob>;
  /** The model's own path. */
  readonly path: string;
  /** Why none of them can be shown, if so. */
  readonly problem: ModelError | null;
}

/** By the model. */
const groups = new WeakMap<Blob, FileGroup>();

/**
 * The model among what was dropped; null if there is nothing. Set it as `src`: its files come with
 * it, and if it cannot be shown, loading it says why. A picture that holds a scene gives what opens
 * that in a viewer.
 * @param entries files and folders, as browsers give them for a drop; empty elsewhere.
 * @param files the same without folders.
 */
export async function droppedModel(
  entries: readonly FileSystemEntry[],
  files: readonly File[],
): Promise<File | ((viewer: HTMLElement) => void) | null> {
  const found = new Map<string, File>();
  try {
    for (const entry of entries) {
      await collect(entry, found);
    }
  } catch {
    // Some browsers refuse to read entries of pages opened from disk: the list of files is left.
  }
  // Files chosen by a folder picker have a path.
  if (found.size === 0) {
    for (const file of files) {
      found.set(file.webkitRelativePath || file.name, file);
    }
  }
  const models = [...found].filter(([path]) =>
    modelExtensions.some((extension) => path.toLowerCase().endsWith(`.${extension}`)),
  );
  const [path, model] = models[0] ?? [...found][0] ?? [];
  if (path === undefined || model === undefined) return null;
  const names = models.map(([name]) => name);
  let problem = problemOf(found.size, names);
  if (names.length === 0 && problem === null) {
    try {
      const { sceneOpener } = await import('../png/open-scene.js');
      const opener = await sceneOpener(model);
      if (opener !== null) return opener;
    } catch (cause) {
      problem = new ModelError('no-scene', `${(cause as Error).message} (${fileName(model)})`, {
        cause,
      });
    }
  }
  groups.set(model, { files: found, path, problem });
  return model;
}

async function collect(entry: FileSystemEntry, found: Map<string, File>) {
  if (found.size >= FILE_LIMIT) return;
  if (entry.isFile) {
    const file = new Promise<File>((resolve, reject) =>
      (entry as FileSystemFileEntry).file(resolve, reject),
    );
    found.set(entry.fullPath.replace(/^\//, ''), await file);
  } else if (entry.isDirectory) {
    const reader = (entry as FileSystemDirectoryEntry).createReader();
    const nextBatch = (): Promise<readonly FileSystemEntry[]> =>
      new Promise((resolve, reject) => reader.readEntries(resolve, reject));
    // Some browsers give a hundred at a time.
    for (let batch = await nextBatch(); batch.length > 0; batch = await nextBatch()) {
      for (const inner of batch) {
        await collect(inner, found);
      }
    }
  }
}

/** Null if it is clear what to show. A single file of an unknown name may still be a model. */
function problemOf(files: number, models: readonly string[]): ModelError | null {
  if (models.length === 1 || files === 1) return null;
  const fact =
    models.length === 0
      ? `None of the ${String(files)} files is a model: ${supportedFormats}.`
      : `There are ${String(models.length)} models: ${listed(models)}. Drop one of them, with its own files.`;
  return new ModelError('bad-model', fact);
}

/** Where a model's bytes come from. */
export interface OpenedModel {
  /** Its address or name, for messages and for the extension. */
  readonly name: string;
  readonly read: () => Promise<FileBytes>;
  /** Reads a file that the model names. */
  readonly linked: (uri: string) => Promise<Uint8Array<ArrayBuffer>>;
}

/** A file, and the files of its group that it names. */
export function openFile(model: Blob, budget: ModelBudget): OpenedModel {
  const name = fileName(model);
  const group = groups.get(model) ?? { files: new Map([[name, model]]), path: name, problem: null };
  const missing = new Set<string>();

  const bytesOf = async (file: Blob): Promise<Uint8Array<ArrayBuffer>> => {
    budget.add({ bytes: file.size });
    let bytes: Uint8Array<ArrayBuffer>;
    try {
      bytes = new Uint8Array(await file.arrayBuffer());
    } catch (cause) {
      // Files can be changed or deleted after they were chosen.
      const fact = `${fileName(file)} could not be read. Was it moved or changed? Choose it again.`;
      throw new ModelError('load-failed', fact, { cause });
    }
    requireContent(bytes, fileName(file));
    return bytes;
  };

  return {
    name,
    read: async () => {
      if (group.problem) throw group.problem;
      return { bytes: await bytesOf(model), type: model.type };
    },
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
    super(
      'load-failed',
      `${model} names files that did not come with it: ${listed(names)}. ${DROP_TOGETHER}`,
    );
  }
}

/**
 * Exactly the path named; else that path, then the only file of that name in any folder, in
 * whatever case.
 */
function fileNamed(uri: string, { files, path }: FileGroup): Blob | undefined {
  const wanted = pathOf(uri, path);
  if (wanted === null) return undefined;
  const exact = files.get(wanted);
  if (exact) return exact;
  const lower = wanted.toLowerCase();
  const named = [...files].filter(([name]) => lastOf(name).toLowerCase() === lastOf(lower));
  return (
    named.length === 1 ? named[0] : named.find(([name]) => name.toLowerCase() === lower)
  )?.[1];
}

/**
 * The path that an address names, seen from the file at `base`; null if it is no relative address.
 */
function pathOf(uri: string, base: string): string | null {
  try {
    const folder = base.split('/').map(encodeURIComponent).join('/');
    const url = new URL(uri, new URL(folder, 'file:///'));
    return url.protocol === 'file:' ? decodeURIComponent(url.pathname.slice(1)) : null;
  } catch {
    return null;
  }
}

/** A path's last part. Paths from Windows have backslashes. */
const lastOf = (path: string): string =>
  path.slice(Math.max(path.lastIndexOf('/'), path.lastIndexOf('\\')) + 1);
