// Recognises STL files of both kinds. Many binary files begin with `solid` too: the size decides
// first.

/** Bytes before the first triangle: a comment of 80 bytes and the number of triangles. */
export const STL_HEADER = 84;
/**
 * Bytes of a triangle: normal and corners as 12 floats, and 16 bits that some programs use for a
 * colour.
 */
export const STL_TRIANGLE = 50;

/** The triangles that its header claims, if it has them; a text's letters would claim 1e8. */
function claimed(bytes: Uint8Array): number {
  if (bytes.byteLength < STL_HEADER + STL_TRIANGLE) return 0;
  return new DataView(bytes.buffer, bytes.byteOffset).getUint32(STL_HEADER - 4, true);
}

const sizeOf = (triangles: number) => STL_HEADER + triangles * STL_TRIANGLE;

/** Whether the size is exactly that of the triangles it claims. */
export const isBinaryStl = (bytes: Uint8Array) =>
  claimed(bytes) > 0 && bytes.byteLength === sizeOf(claimed(bytes));

/** Whether an STL file is binary by that, with other bytes behind or without. */
export const holdsTriangles = (bytes: Uint8Array) =>
  claimed(bytes) > 0 && bytes.byteLength >= sizeOf(claimed(bytes));

/**
 * Comments before `solid`, which some programs write although the format has none. Lines of other
 * words may follow it, no bytes of numbers; or `solid` is missing.
 */
const TEXT =
  /^(ï»¿)?(\s*(#|;|!|\/\/)[^\r\n]*[\r\n])*\s*(solid\b[^\0]*?([\r\n][^\S\r\n]*(facet|endsolid)|\s(facet\s+normal|endsolid))|facet\s+normal)\b/i;

/**
 * Whether it begins as a text file does, with a byte order mark or without, with lines or in one.
 */
export function isTextStl(bytes: Uint8Array) {
  // A byte order mark of UTF-8 reads as three characters.
  return TEXT.test(new TextDecoder('latin1').decode(bytes.subarray(0, 4096)));
}
