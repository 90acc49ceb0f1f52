// @ts-check
// A triangle mesh as the smallest binary glTF that holds it: what viewers that show only files are given. Used in Node and
// in pages; positions and normals are unitless, counter-clockwise is outside.

/**
 * @typedef {{ positions: Float32Array, normals: Float32Array, indices: Uint16Array }} Triangles
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
  const corners = [0, 1, 2].map((axis) => positions.filter((_, i) => i % 3 === axis));
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
        min: corners.map((values) => values.reduce((a, b) => Math.min(a, b))),
        max: corners.map((values) => values.reduce((a, b) => Math.max(a, b))),
      },
      { bufferView: 1, componentType: FLOAT, count, type: 'VEC3' },
      { bufferView: 2, componentType: UNSIGNED_SHORT, count: indices.length, type: 'SCALAR' },
    ],
    bufferViews: parts.map(({ start, bytes }) => ({
      buffer: 0,
      byteOffset: start,
      byteLength: bytes.length,
    })),
    buffers: [{ byteLength: total }],
  };
  const text = new TextEncoder().encode(JSON.stringify(json));
  const file = new Uint8Array(12 + 8 + padded(text.length) + 8 + total);
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
  [total, BINARY_CHUNK].forEach(put);
  for (const { start, bytes } of parts) file.set(bytes, at + start);
  return file;
}

const FLOAT = 5126;
const UNSIGNED_SHORT = 5123;
const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BINARY_CHUNK = 0x004e4942;

/** To whole words. @param {number} bytes */
const padded = (bytes) => Math.ceil(bytes / 4) * 4;

/** A cube of edge 1 about the origin, each face with corners of its own. @returns {Triangles} */
export function box() {
  const positions = [];
  const normals = [];
  const indices = [];
  for (const axis of [0, 1, 2]) {
    for (const sign of [1, -1]) {
      const first = positions.length / 3;
      for (const [u, v] of /** @type {const} */ ([
        [-1, -1],
        [1, -1],
        [1, 1],
        [-1, 1],
      ])) {
        const corner = [0, 0, 0];
        corner[axis] = sign / 2;
        corner[(axis + 1) % 3] = (sign * u) / 2; // turned round on the far side, so that it faces outwards too
        corner[(axis + 2) % 3] = v / 2;
        positions.push(...corner);
        normals.push(...[0, 1, 2].map((i) => (i === axis ? sign : 0)));
      }
      indices.push(...[0, 1, 2, 0, 2, 3].map((i) => first + i));
    }
  }
  return {
    positions: new Float32Array(positions),
    normals: new Float32Array(normals),
    indices: new Uint16Array(indices),
  };
}
