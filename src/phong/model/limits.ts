// The limits of a model's size, chosen so that the page's renderer and GPU process together grow by
// less than 1 GB; how a lack of memory is recognised.

/** What one model, and all meshes of one viewer, may hold at most. */
export const LIMITS = {
  /**
   * Most bytes of one model, all its files together, as they are after decompression: 256 MiB. The
   * reader holds the bytes and their copies as vertices, and the GPU holds the vertices once more.
   */
  bytes: 2 ** 28,

  /**
   * Most bytes of text in one model, 128 MiB: its characters become strings, lists and numbers that
   * take more than the bytes. Data in base64 is no text.
   */
  text: 2 ** 27,

  /**
   * Most items that are visited while a model is read, beyond its values: some seconds, in short
   * tasks.
   */
  work: 2 ** 28,

  /**
   * Most triangle corners in all draws of a model, repeated meshes counted each time: 5.6 million
   * triangles.
   */
  corners: 2 ** 24,

  /**
   * Most 4-byte values in a model's vertices and indices, each geometry counted once as it is drawn:
   * 400 MB in the page, and as much on the GPU. Enough for 5 million triangles with a position and a
   * normal per corner.
   */
  values: 100_000_000,

  /**
   * Most draws of a model. Each costs 10 to 30 µs of script per frame, so this many leave a few
   * frames per second.
   */
  parts: 10_000,

  /**
   * Most nodes of a model's tree, with or without meshes. Each takes 2 kB and 20 µs while the model
   * is read.
   */
  nodes: 30_000,

  /** Most values in a glTF's JSON, by its brackets and commas. A parsed one takes up to 200 bytes. */
  json: 2 ** 21,

  /**
   * Most steps of all poses of a frame, by the work of motions: 40 ms. What takes more stays in its
   * first pose.
   */
  pose: 2 ** 21,

  /**
   * Most pixels in all images of a model, as its files claim: one image of 8192 × 8192, or 64 of 1024
   * × 1024.
   */
  pixels: 2 ** 26,

  /**
   * Most pixels of an image; one with more is left out. While it is uploaded, its memory is needed
   * four times.
   */
  imagePixels: 2 ** 25,

  /** Most bytes in the page and the GPU process together, by the estimate in `budget.ts`. */
  memory: 950_000_000,

  /**
   * Most triangles that all meshes of a viewer hold, geometries that they share counted once: 0.94 GB
   * in the page and on the GPU together. All other limits are those of a viewer too, so every model
   * within them fits in alone.
   */
  triangles: 2 ** 24,
} as const;

/**
 * Values of 4 bytes that a triangle of a round shape takes: half a vertex of 8 and three indices.
 * 56 bytes in the page and on the GPU together. What has more values per triangle counts as more
 * triangles: a flat copy's triangle as 24/7, an STL file's as 18/7.
 */
export const VALUES_PER_TRIANGLE = 7;

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
