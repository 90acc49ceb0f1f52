// The limits of a model's size, chosen so that the page's renderer and GPU process together grow by
// less than 1 GB; how memory is freed, and how a lack of it is recognised.

/**
 * Most bytes of one model, all its files together, as they are after decompression: 256 MiB. The
 * reader holds the bytes and their copies as vertices, and the GPU holds the vertices once more.
 */
export const BYTE_LIMIT = 2 ** 28;

/**
 * Most bytes of text in one model, 128 MiB: its characters become strings, lists and numbers that
 * take more than the bytes. Data in base64 is no text.
 */
export const TEXT_LIMIT = 2 ** 27;

/**
 * Most bytes of a glTF's JSON without base64: 16 MiB. It is parsed in one task: 6 ms a
 * megabyte of nodes or accessors, 60 ms where every value is a few bytes long.
 */
export const JSON_TEXT_LIMIT = 2 ** 24;

/**
 * Most items that are visited while a model is read, beyond its values: some seconds, in short
 * tasks.
 */
export const WORK_LIMIT = 2 ** 28;

/**
 * Most triangle corners in all draws of a model, repeated meshes counted each time: 5.6 million
 * triangles.
 */
export const CORNER_LIMIT = 2 ** 24;

/**
 * Most corners, and most vertices, of one Draco mesh: a million triangles. The decoder's heap and
 * what comes out of it take 500 MB for them, and 1.1 GB for two million. A larger model can have
 * several such meshes.
 */
export const DRACO_LIMIT = 3 * 2 ** 20;

/**
 * Most 4-byte values in a model's vertices and indices, each geometry counted once as it is drawn:
 * 400 MB in the page, and as much on the GPU. Enough for 5 million triangles with a position and a
 * normal per corner.
 */
export const VALUE_LIMIT = 100_000_000;

/**
 * Most draws of a model. Each costs 10 to 30 µs of script per frame, so this many leave a few
 * frames per second.
 */
export const PART_LIMIT = 10_000;

/**
 * Most nodes of a model's tree, with or without meshes. Each takes 2 kB and 20 µs while the model
 * is read.
 */
export const NODE_LIMIT = 30_000;

/** Most values in a glTF's JSON, by its brackets and commas. A parsed one takes up to 200 bytes. */
export const JSON_LIMIT = 2 ** 21;

/**
 * Most items of a list of that JSON that is read in one task, of joints or children for example.
 */
export const JSON_LIST_LIMIT = 2 ** 16;

/** Most names in one of its objects, and most morph targets of a primitive. One takes 5 µs. */
export const JSON_NAME_LIMIT = 2 ** 12;

/** Most files that a model names and are requested. Real ones have some dozens. */
export const FILE_LIMIT = 1000;

/**
 * Most steps of all poses of a frame, by the work of motions: 40 ms. What takes more stays in its
 * first pose.
 */
export const POSE_LIMIT = 2 ** 21;

/**
 * Most pixels in all images of a model, as its files claim: one image of 8192 × 8192, or 64 of 1024
 * × 1024.
 */
export const PIXEL_LIMIT = 2 ** 26;

/**
 * Longest side of an image as it is shown; larger ones are scaled down. All but old phones have
 * such textures.
 */
export const IMAGE_SIDE_LIMIT = 8192;

/**
 * Most pixels of an image as it is shown; larger ones are scaled down. While it is uploaded, its
 * memory is needed four times.
 */
export const IMAGE_PIXEL_LIMIT = 2 ** 25;

/** Most bytes in the page and the GPU process together, by the estimate in `budget.ts`. */
export const MEMORY_LIMIT = 950_000_000;

/**
 * Values of 4 bytes that a triangle of a round shape takes: half a vertex of 8 and three indices.
 * 56 bytes in the page and on the GPU together. What has more values per triangle counts as more
 * triangles: a flat copy's triangle as 24/7, an STL file's as 18/7.
 */
export const VALUES_PER_TRIANGLE = 7;

/**
 * Most triangles that all meshes of a viewer hold, geometries that they share counted once: 0.94 GB
 * in the page and on the GPU together. All other limits are those of a viewer too, so every model
 * within them fits in alone.
 */
export const TRIANGLE_LIMIT = 2 ** 24;

/**
 * Frees arrays that nothing reads any more, where the browser can: the collector may come after the
 * upload.
 */
export function free(...arrays: readonly ArrayBufferView[]): void {
  for (const { buffer } of arrays) {
    (buffer as { transfer?: (bytes: number) => void }).transfer?.(0);
  }
}

/**
 * Whether memory could not be allocated. Browsers throw a RangeError for that, Firefox also an
 * InternalError or a string. A RangeError can also mean an offset outside a buffer or a recursion
 * that is too deep.
 */
export function isOutOfMemory(error: unknown): boolean {
  const text = String(error);
  if (error instanceof RangeError) {
    return !/offset|bounds|multiple|call stack|recursion/i.test(text);
  }
  return /out of memory|allocation size/i.test(text);
}
