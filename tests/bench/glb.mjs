// @ts-check
// Writes glTF, as GLB or as JSON with a buffer beside it. Positions and normals have no unit;
// counter-clockwise triangles face outward.

const FLOAT = 5126;
const UNSIGNED_SHORT = 5123;
const UNSIGNED_INT = 5125;

/**
 * @typedef {{ positions: Float32Array, normals: Float32Array, indices: Uint16Array | Uint32Array }}
 * Triangles
 * @typedef {Triangles & { uvs?: Float32Array }} Grid
 */

/** A glTF file under construction: adds pieces to the JSON and their bytes to one buffer. */
export class Gltf {
  /** @type {{ start: number, bytes: Uint8Array }[]} */
  #parts = [];
  #length = 0;
  json = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: /** @type {number[]} */ ([]) }],
    nodes: /** @type {object[]} */ ([]),
    meshes: /** @type {object[]} */ ([]),
    accessors: /** @type {object[]} */ ([]),
    bufferViews: /** @type {object[]} */ ([]),
  };

  /** @param {ArrayBufferView} data @param {object} [more] @returns {number} index of the view */
  view(data, more = {}) {
    const bytes = new Uint8Array(data.buffer, data.byteOffset, data.byteLength);
    const start = this.#length;
    this.#parts.push({ start, bytes });
    this.#length += padded(bytes.length);
    const view = { buffer: 0, byteOffset: start, byteLength: bytes.length, ...more };
    return this.json.bufferViews.push(view) - 1;
  }

  /**
   * @param {ArrayBufferView} data @param {object} accessor @param {object} [view] @returns {number}
   */
  accessor(data, accessor, view) {
    return this.json.accessors.push({ bufferView: this.view(data, view), ...accessor }) - 1;
  }

  /**
   * One mesh of one primitive, at a node. @param {Grid} grid @param {object} [more] of the
   * primitive @param {object} [node]
   */
  add({ positions, normals, uvs, indices }, more = {}, node = {}) {
    const vector = { componentType: FLOAT, count: positions.length / 3, type: 'VEC3' };
    const attributes = {
      POSITION: this.accessor(positions, { ...vector, ...bounds(positions) }),
      NORMAL: this.accessor(normals, vector),
      ...(uvs &&
        'material' in more && { TEXCOORD_0: this.accessor(uvs, { ...vector, type: 'VEC2' }) }),
    };
    this.addPrimitive(attributes, indices, more, node);
  }

  /**
   * @param {object} attributes @param {Uint16Array | Uint32Array} list @param {object} [more]
   * @param {object} [node]
   */
  addPrimitive(attributes, list, more = {}, node = {}) {
    const componentType = list instanceof Uint32Array ? UNSIGNED_INT : UNSIGNED_SHORT;
    const indices = this.accessor(list, { componentType, count: list.length, type: 'SCALAR' });
    const mesh = this.json.meshes.push({ primitives: [{ attributes, indices, ...more }] }) - 1;
    this.json.scenes[0]?.nodes.push(this.json.nodes.push({ mesh, ...node }) - 1);
  }

  #bin() {
    const bin = new Uint8Array(this.#length);
    for (const { start, bytes } of this.#parts) {
      bin.set(bytes, start);
    }
    return bin;
  }

  glb() {
    return glbFile({ ...this.json, buffers: [{ byteLength: this.#length }] }, this.#bin());
  }

  /** The JSON and its buffer apart. @param {string} uri @returns {readonly [string, Uint8Array]} */
  pair(uri) {
    return [
      JSON.stringify({ ...this.json, buffers: [{ byteLength: this.#length, uri }] }),
      this.#bin(),
    ];
  }
}

/** @param {Float32Array | Int16Array} positions */
export function bounds(positions) {
  /** @type {number[]} */
  const min = [];
  /** @type {number[]} */
  const max = [];
  positions.forEach((x, i) => {
    min[i % 3] = Math.min(min[i % 3] ?? x, x);
    max[i % 3] = Math.max(max[i % 3] ?? x, x);
  });
  return { min, max };
}

/** @param {Grid} grid */
export function gltfOf(grid) {
  const gltf = new Gltf();
  gltf.add(grid);
  return gltf;
}

/** @param {Triangles} triangles */
export const glbOf = (triangles) => gltfOf(triangles).glb();

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

const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BINARY_CHUNK = 0x004e4942;

/** To whole words. @param {number} bytes */
const padded = (bytes) => Math.ceil(bytes / 4) * 4;
