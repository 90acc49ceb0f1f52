// How do a file's vertex attributes become what the shaders read? Finite floats, normals of unit length, encoded colours. The source
// can be quantised, normalised or interleaved. Must not know the file format.
import { BufferAttribute, type InterleavedBufferAttribute } from 'three';
import { srgbEncode } from '../../../math/color.js';

export type Attribute = BufferAttribute | InterleavedBufferAttribute;

/** Domain of coordinates: products of two stay finite in float32. */
const COORDINATE_LIMIT = 1e15;

/** @throws Error if a coordinate is not a number or beyond ±1e15. */
export function floatPositions(source: Attribute): BufferAttribute {
  const positions = asFloats(source, 3);
  for (const value of positions.array) {
    if (!(Math.abs(value) <= COORDINATE_LIMIT)) {
      throw new Error(`a vertex has the coordinate ${String(value)}; ±1e15 is the limit`);
    }
  }
  return positions;
}

/** Unit vectors, normalised in float64. A normal without direction (zero, NaN, Infinity) becomes zero: only ambient light. */
export function unitNormals(source: Attribute): BufferAttribute {
  const values = new Float32Array(source.count * 3);
  for (let i = 0; i < source.count; i += 1) {
    const x = source.getX(i);
    const y = source.getY(i);
    const z = source.getZ(i);
    const length = Math.hypot(x, y, z);
    if (!(length > 0 && length < Infinity)) continue;
    values[i * 3] = x / length;
    values[i * 3 + 1] = y / length;
    values[i * 3 + 2] = z / length;
  }
  return new BufferAttribute(values, 3);
}

/** Texture coordinates; values that are not finite become 0. */
export function floatUvs(source: Attribute): BufferAttribute {
  const uvs = asFloats(source, 2);
  if (uvs.array.every(Number.isFinite)) return uvs;
  return new BufferAttribute(
    Float32Array.from(uvs.array, (value) => (Number.isFinite(value) ? value : 0)),
    2,
  );
}

/** Encodes linear colours as sRGB, clamped to 0–1. Alpha is only clamped. */
export function encodedColors(source: Attribute): BufferAttribute {
  const items = source.itemSize === 4 ? 4 : 3;
  const values = new Float32Array(source.count * items);
  for (let i = 0; i < source.count; i += 1) {
    for (let c = 0; c < items; c += 1) {
      const value = source.getComponent(i, c);
      const inside = value > 0 ? Math.min(value, 1) : 0;
      values[i * items + c] = c === 3 ? inside : srgbEncode(inside);
    }
  }
  return new BufferAttribute(values, items);
}

function asFloats(source: Attribute, items: number): BufferAttribute {
  if (source.itemSize < items)
    throw new Error(`an attribute has ${String(source.itemSize)} of ${String(items)} parts`);
  const plain = source instanceof BufferAttribute && source.array instanceof Float32Array;
  if (plain && source.itemSize === items && !source.normalized) return source;
  const values = new Float32Array(source.count * items);
  for (let i = 0; i < source.count; i += 1) {
    for (let c = 0; c < items; c += 1) values[i * items + c] = source.getComponent(i, c);
  }
  return new BufferAttribute(values, items);
}
