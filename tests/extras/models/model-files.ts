// What the tests of file formats share: a model loaded from files in memory, as if a server had
// sent them, and its numbers.
import { deflateSync } from 'node:zlib';
import { afterEach, beforeEach, vi } from 'vitest';
import { imageSize } from '../../../src/extras/models/image.js';
import { modelContent, type ReadOptions } from '../../../src/extras/models/model-content.js';
import { type Content, ModelError } from '../../../src/phong/model/model.js';
import { pngWith } from '../../fuzz/glb.js';
import { requestFile } from '../../../src/viewer/model/request-model.js';

/** A load that nothing aborts. */
/** As of a mesh without `crossorigin`. */
export const loadWith = (signal: AbortSignal): ReadOptions => ({
  signal,
  request: (url, redirect) => requestFile(url, redirect, { signal, crossOrigin: null }),
  anywhere: false,
});

export const OPTIONS = loadWith(new AbortController().signal);

/** In the place of a file: the connection breaks after its first byte. */
export const BREAKS_OFF = null;

export type FileContent = string | Uint8Array<ArrayBuffer> | null;

function bytesOf(content: FileContent) {
  if (content !== BREAKS_OFF) {
    return typeof content === 'string' ? new TextEncoder().encode(content) : content;
  }
  return new ReadableStream({
    start: (controller) => controller.enqueue(new Uint8Array(1)),
    pull: (controller) => controller.error(new TypeError('network error')),
  });
}

/**
 * How often the running test's work has let other tasks run. Every look at the clock says that a
 * task has taken long enough. Needs {@link heardWarnings}, which ends the stand-ins.
 */
export function countedPauses(): { count: number } {
  const pauses = { count: 0 };
  beforeEach(() => {
    let now = 0;
    vi.spyOn(performance, 'now').mockImplementation(() => (now += 100));
    pauses.count = 0;
    vi.stubGlobal(
      'MessageChannel',
      class extends MessageChannel {
        constructor() {
          super();
          pauses.count += 1;
        }
      },
    );
  });
  return pauses;
}

/**
 * The texts of the running test's warnings, which are not shown. Ends the test's stand-ins and
 * spies after it.
 */
export function heardWarnings(): readonly string[] {
  const warnings: string[] = [];
  beforeEach(() => {
    warnings.length = 0;
    vi.spyOn(console, 'warn').mockImplementation(
      (line: unknown) => void warnings.push(String(line)),
    );
  });
  afterEach(() => {
    vi.unstubAllGlobals();
    vi.restoreAllMocks();
  });
  return warnings;
}

/** Loads the first of these files; the others are beside it, but for those that are undefined. */
export function loadFiles(
  files: Readonly<Record<string, FileContent | undefined>>,
  options: Partial<ReadOptions> = {},
): Promise<Content> {
  const base = 'https://shop.example/models/';
  const [first = ''] = Object.keys(files);
  vi.spyOn(globalThis, 'fetch').mockImplementation((input) => {
    const content = files[decodeURIComponent((input as URL).href.slice(base.length))];
    return Promise.resolve(
      content === undefined ? new Response(null, { status: 404 }) : new Response(bytesOf(content)),
    );
  });
  return modelContent(new URL(first, base), { ...OPTIONS, ...options });
}

/** The error that loading these files ends with. */
export async function failureOf(files: Readonly<Record<string, FileContent>>): Promise<ModelError> {
  const result: unknown = await loadFiles(files).catch((error: unknown) => error);
  if (result instanceof ModelError) return result;
  throw result instanceof Error ? result : new Error('it loaded');
}

/** A glTF accessor of a buffer view, by default of floats. */
export const view = (bufferView: number, type: string, componentType = 5126, count = 3) => ({
  bufferView,
  type,
  componentType,
  count,
});

/** An attribute of a part as plain numbers, rounded to what float32 holds. */
export const numbersOf = (model: Content, name: string, part = 0): number[] =>
  Array.from(
    model.parts[part]?.geometry.getAttribute(name).array ?? [],
    (value) => Math.round(value * 1e6) / 1e6 + 0,
  );

export const indexOf = (model: Content, part = 0): number[] =>
  Array.from(model.parts[part]?.geometry.index?.array ?? []);

/** An attribute in the order of the corners, an item each. */
export function cornersOf(model: Content, name: string): number[][] {
  const size = model.parts[0]?.geometry.getAttribute(name).itemSize ?? 0;
  const values = numbersOf(model, name);
  return indexOf(model).map((vertex) => values.slice(vertex * size, (vertex + 1) * size));
}

/** A PNG image of this size by its header, whose data end early. */
export const png = (width = 2, height = 2) =>
  new Uint8Array(pngWith(width, height, 32, deflateSync(Buffer.alloc(10))));

export const pngHeader = () => png().subarray(0, 41);

/** Node has no createImageBitmap: gives an image of the size in the header. */
export async function bitmapOf(blob: Blob, close: () => void = () => undefined) {
  return { ...imageSize(new Uint8Array(await blob.arrayBuffer())), close };
}

/** Decodes every PNG but a mere header. */
export function standInImages(): { readonly closed: () => number; readonly decoded: () => number } {
  let decoded = 0;
  let closed = 0;
  vi.stubGlobal('createImageBitmap', async (blob: Blob) => {
    if ((await blob.arrayBuffer()).byteLength <= pngHeader().length) throw new Error('no content');
    decoded += 1;
    return bitmapOf(blob, () => (closed += 1));
  });
  return { closed: () => closed, decoded: () => decoded };
}
