// @ts-check
// Writes binary glTF: the container, and a triangle mesh as the smallest file that holds it. Positions and normals have no unit;
// counter-clockwise triangles face outward.

/**
 * @typedef {{ positions: Float32Array, normals: Float32Array, indices: Uint16Array | Uint32Array }} Triangles
 * @param {Triangles} triangles
 * @returns {Uint8Array<ArrayBuffer>}
 */
export function glbOf({ positions, normals, indices }) {
  let total = 0;
  const parts = [positions, normals, indices].map((part) => {
    const start = total;
    total = padded(start + part.byteLength);
    return { start, bytes: new Uint8Array(part.buffer, part.byteOffset, part.byteLength) };
  });
  const coordinates = [0, 1, 2].map((axis) => positions.filter((_, i) => i % 3 === axis));
  const count = positions.length / 3;
  const json = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1 }, indices: 2 }] }],
    accessors: [
      {
        ...{ bufferView: 0, componentType: FLOAT, count, type: 'VEC3' },
        min: coordinates.map((values) => values.reduce((a, b) => Math.min(a, b))),
        max: coordinates.map((values) => values.reduce((a, b) => Math.max(a, b))),
      },
      { bufferView: 1, componentType: FLOAT, count, type: 'VEC3' },
      {
        bufferView: 2,
        componentType: indices instanceof Uint32Array ? UNSIGNED_INT : UNSIGNED_SHORT,
        count: indices.length,
        type: 'SCALAR',
      },
    ],
    bufferViews: parts.map(({ start, bytes }) => ({
      buffer: 0,
      byteOffset: start,
      byteLength: bytes.length,
    })),
    buffers: [{ byteLength: total }],
  };
  const bin = new Uint8Array(total);
  for (const { start, bytes } of parts) bin.set(bytes, start);
  return glbFile(json, bin);
}

/**
 * The container: JSON, or a text in its place, and one binary chunk.
 * @param {object | string} json @param {Uint8Array} bin
 * @returns {Uint8Array<ArrayBuffer>}
 */
export function glbFile(json, bin) {
  const text = new TextEncoder().encode(typeof json === 'string' ? json : JSON.stringify(json));
  const file = new Uint8Array(12 + 8 + padded(text.length) + 8 + padded(bin.length));
  const view = new DataView(file.buffer);
  let at = 0;
  /** @param {number} word */
  const put = (word) => {
    view.setUint32(at, word, true);
    at += 4;
  };
  [MAGIC, 2, file.length, padded(text.length), JSON_CHUNK].forEach(put);
  file.fill(0x20, at, at + padded(text.length)); // JSON is padded with spaces
  file.set(text, at);
  at += padded(text.length);
  [padded(bin.length), BINARY_CHUNK].forEach(put);
  file.set(bin, at);
  return file;
}

const FLOAT = 5126;
const UNSIGNED_SHORT = 5123;
const UNSIGNED_INT = 5125;
const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BINARY_CHUNK = 0x004e4942;

/** To whole words. @param {number} bytes */
const padded = (bytes) => Math.ceil(bytes / 4) * 4;
