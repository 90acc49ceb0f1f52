// Limits that only the readers of models know, and how they free memory. Those of a whole viewer are
// in phong/model/limits.ts.

/**
 * Most bytes of a glTF's JSON without base64: 16 MiB. It is parsed in one task: 6 ms a
 * megabyte of nodes or accessors, 60 ms where every value is a few bytes long.
 */
export const JSON_TEXT_LIMIT = 2 ** 24;

/**
 * Most corners, and most vertices, of one Draco mesh: a million triangles. The decoder's heap and
 * what comes out of it take 500 MB for them, and 1.1 GB for two million. A larger model can have
 * several such meshes.
 */
export const DRACO_LIMIT = 3 * 2 ** 20;

/**
 * Most items of a list of that JSON that is read in one task, of joints or children for example.
 */
export const JSON_LIST_LIMIT = 2 ** 16;

/** Most names in one of its objects, and most morph targets of a primitive. One takes 5 µs. */
export const JSON_NAME_LIMIT = 2 ** 12;

/** Most files that a model names and are requested. Real ones have some dozens. */
export const FILE_LIMIT = 1000;

/**
 * Longest side of an image as it is shown; larger ones are scaled down. All but old phones have
 * such textures.
 */
export const IMAGE_SIDE_LIMIT = 8192;

/**
 * Frees arrays that nothing reads any more, where the browser can: the collector may come after the
 * upload.
 */
export function free(...arrays: readonly ArrayBufferView[]): void {
  for (const { buffer } of arrays) {
    (buffer as { transfer?: (bytes: number) => void }).transfer?.(0);
  }
}
