// Turns a file's vertex attributes into what the shaders read: finite floats, normals of unit length, encoded colours.
// The source can be quantised, normalised or interleaved.
import { BufferAttribute, type InterleavedBufferAttribute } from 'three';
import { srgbEncode } from '../../math/color.js';
import type { Slices } from '../slices.js';

export type Attribute = BufferAttribute | InterleavedBufferAttribute;
export type Conversion = (source: Attribute, slices: Slices) => Promise<BufferAttribute>;

/** Domain of coordinates: products of two stay finite in float32. */
export const COORDINATE_LIMIT = 1e15;

/** Rejects with an Error if a coordinate is not a number or beyond ±1e15. */
export const floatPositions: Conversion = async (source, slices) => {
  const positions = await asFloats(source, 3, slices);
  const { array } = positions;
  await slices.over(array.length, (from, to) => {
    for (let i = from; i < to; i += 1) {
      const value = array[i]!;
      if (Math.abs(value) <= COORDINATE_LIMIT) continue;
      throw new Error(`a vertex has the coordinate ${String(value)}; ±1e15 is the limit`);
    }
  });
  return positions;
};

/** Unit vectors. A normal without direction becomes zero. */
export const unitNormals: Conversion = async (source, slices) => {
  const values = new Float32Array(source.count * 3);
  await slices.over(source.count, (from, to) => {
    for (let i = from; i < to; i += 1) setUnit(values, i * 3, source, i);
  });
  return new BufferAttribute(values, 3);
};

/**
 * Writes the vector of vertex `i` to `values` from index `at`, normalised in float64. Leaves them where it has no
 * direction (zero, NaN, Infinity).
 */
export function setUnit(values: Float32Array, at: number, source: Attribute, i: number): void {
  const x = source.getX(i);
  const y = source.getY(i);
  const z = source.getZ(i);
  const length = Math.hypot(x, y, z);
  if (!(length > 0 && length < Infinity)) return;
  values[at] = x / length;
  values[at + 1] = y / length;
  values[at + 2] = z / length;
}

/** Texture coordinates; values that are not finite become 0. */
export const floatUvs: Conversion = async (source, slices) => {
  const uvs = await asFloats(source, 2, slices);
  const { array } = uvs;
  await slices.over(array.length, (from, to) => {
    for (let i = from; i < to; i += 1) if (!Number.isFinite(array[i])) array[i] = 0;
  });
  return uvs;
};

/** Encodes linear colours as sRGB, clamped to 0–1. Alpha is only clamped. */
export const encodedColors: Conversion = async (source, slices) => {
  const items = source.itemSize === 4 ? 4 : 3;
  const values = new Float32Array(source.count * items);
  await slices.over(source.count, (from, to) => {
    for (let i = from; i < to; i += 1) {
      for (let c = 0; c < items; c += 1) {
        const value = source.getComponent(i, c);
        const inside = value > 0 ? Math.min(value, 1) : 0;
        values[i * items + c] = c === 3 ? inside : srgbEncode(inside);
      }
    }
  });
  return new BufferAttribute(values, items);
};

/** The unconverted numbers of the vertices that the corners refer to. */
export async function gathered(
  source: Attribute,
  corners: ArrayLike<number>,
  slices: Slices,
): Promise<BufferAttribute> {
  const { itemSize } = source;
  const values = new Float32Array(corners.length * itemSize);
  await slices.over(corners.length, (from, to) => {
    for (let i = from; i < to; i += 1) {
      for (let c = 0; c < itemSize; c += 1) values[i * itemSize + c] = source.getComponent(corners[i]!, c);
    }
  });
  return new BufferAttribute(values, itemSize);
}

async function asFloats(source: Attribute, items: number, slices: Slices): Promise<BufferAttribute> {
  if (source.itemSize < items) throw new Error(`an attribute has ${String(source.itemSize)} of ${String(items)} parts`);
  const plain = source instanceof BufferAttribute && source.array instanceof Float32Array;
  if (plain && source.itemSize === items && !source.normalized) return source;
  const values = new Float32Array(source.count * items);
  await slices.over(source.count, (from, to) => {
    for (let i = from; i < to; i += 1) {
      for (let c = 0; c < items; c += 1) values[i * items + c] = source.getComponent(i, c);
    }
  });
  return new BufferAttribute(values, items);
}
