// Finds the model among files that were dropped or chosen together. The others are kept with it, for the names in it.
// Knows the formats' extensions only.
import { listed } from '../fields/clip.js';
import { setFileGroup } from './file-group.js';
import { modelExtensions, supportedFormats } from './format.js';
import { ModelError } from './model.js';

/** Most files of a dropped folder. Models come with hundreds at most; a whole disk should not be walked. */
const FILE_LIMIT = 5000;

type Files = ReadonlyMap<string, File>;

/**
 * The model among what was dropped; null if there is nothing. Set it as `src`: its files come with it, and if it cannot
 * be shown, loading it says why.
 * @param entries files and folders, as browsers give them for a drop; empty elsewhere.
 * @param files the same without folders.
 */
export async function droppedModel(entries: readonly FileSystemEntry[], files: readonly File[]): Promise<File | null> {
  const found = new Map<string, File>();
  try {
    for (const entry of entries) await collect(entry, found);
  } catch {
    // Some browsers refuse to read entries of pages opened from disk: the list of files is left.
  }
  return modelAmong(found.size > 0 ? found : new Map(files.map((file) => [pathOf(file), file])));
}

/** Files chosen by a folder picker have a path. */
const pathOf = (file: File): string => file.webkitRelativePath || file.name;

async function collect(entry: FileSystemEntry, found: Map<string, File>): Promise<void> {
  if (found.size >= FILE_LIMIT) return;
  if (entry.isFile) {
    found.set(entry.fullPath.replace(/^\//, ''), await fileOf(entry as FileSystemFileEntry));
  } else if (entry.isDirectory) {
    const reader = (entry as FileSystemDirectoryEntry).createReader();
    // Some browsers give a hundred at a time.
    for (let batch = await nextBatch(reader); batch.length > 0; batch = await nextBatch(reader)) {
      for (const inner of batch) await collect(inner, found);
    }
  }
}

const fileOf = (entry: FileSystemFileEntry): Promise<File> =>
  new Promise((resolve, reject) => entry.file(resolve, reject));

const nextBatch = (reader: FileSystemDirectoryReader): Promise<readonly FileSystemEntry[]> =>
  new Promise((resolve, reject) => reader.readEntries(resolve, reject));

function modelAmong(files: Files): File | null {
  const models = [...files].filter(([path]) => isModel(path));
  const [path, model] = models[0] ?? [...files][0] ?? [];
  if (path === undefined || model === undefined) return null;
  setFileGroup(model, { files, path, problem: problemOf(files, models.map(([name]) => name)) }); // prettier-ignore
  return model;
}

const isModel = (path: string): boolean =>
  modelExtensions.some((extension) => path.toLowerCase().endsWith(`.${extension}`));

/** Null if it is clear what to show. A single file of an unknown name may still be a model. */
function problemOf(files: Files, models: readonly string[]): ModelError | null {
  if (models.length === 1 || files.size === 1) return null;
  if (models.length === 0) {
    return new ModelError('bad-model', `None of the ${String(files.size)} files is a model: ${supportedFormats}.`);
  }
  return new ModelError('bad-model', `There are ${String(models.length)} models: ${listed(models)}. Drop one of them, with its own files.`); // prettier-ignore
}
