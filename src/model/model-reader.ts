// What the reader of a format gets and gives.
import type { Content } from './model.js';
import type { ModelBudget } from './model-budget.js';

export interface ModelSource {
  readonly url: URL;
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly signal: AbortSignal;
  /** Downloads a file that the model names, if it is allowed to name it. */
  readonly linked: (uri: string) => Promise<Uint8Array<ArrayBuffer>>;
  readonly optional: ReadOptional;
  /** Has the bytes of the files; the reader claims everything else. */
  readonly budget: ModelBudget;
}

/**
 * Reads something that the model can be shown without: an image, or a library of materials. Null if it is missing or
 * broken, which is then reported. Limits, a policy and missing code of the package are errors here too.
 * @param name as the model names it, for reports.
 * @param read gets its bytes, by `linked` or from the model itself.
 * @param use decodes them. A ModelError is not the file's fault.
 */
export type ReadOptional = <Bytes, Result>(
  name: string,
  read: () => Promise<Bytes>,
  use: (bytes: Bytes) => Result | Promise<Result>,
) => Promise<Result | null>;

/** Reads a whole model, or throws and leaks nothing. An error other than ModelError means a broken file. */
export type ModelReader = (source: ModelSource) => Promise<Content>;
