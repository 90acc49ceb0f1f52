// Turns a file's vertex attributes, of any layout, into finite floats, normals of unit length and
// colours from 0 to 1.
import { BufferAttribute, type InterleavedBufferAttribute } from 'three';
import { LIMITS } from '../../../phong/light/light-state.js';
import type { Slices } from '../slices.js';

export type Attribute = BufferAttribute | InterleavedBufferAttribute;
export type Conversion = (source: Attribute, slices: Slices) => Promise<BufferAttribute>;

/** Rejects with an Error if a coordinate is not a number or beyond ±1e15. */
export async function requireCoordinates(
  coordinates: ArrayLike<number>,
  slices: Slices,
): Promise<void> {
  await slices.over(coordinates.length, (from, to) => {
    for (let i = from; i < to; i += 1) {
      const value = coordinates[i]!;
      if (Math.abs(value) <= LIMITS.coordinate) continue;
      throw new Error(`a vertex has the coordinate ${String(value)}; ±1e15 is the limit`);
    }
  });
}

export const floatPositions: Conversion = async (source, slices) => {
  const positions = await asFloats(source, 3, slices);
  await requireCoordinates(positions.array, slices);
  return positions;
};

/**
 * Unit vectors, normalised in float64, or zero for one without direction (zero, NaN, Infinity).
 * Then ±1, if `items` is 4.
 */
const unitVectors =
  (items: 3 | 4): Conversion =>
  async (source, slices) => {
    const values = new Float32Array(source.count * items);
    await slices.over(source.count, (from, to) => {
      for (let i = from; i < to; i += 1) {
        const at = i * items;
        const x = source.getX(i);
        const y = source.getY(i);
        const z = source.getZ(i);
        if (items === 4) {
          values[at + 3] = source.getW(i) < 0 ? -1 : 1;
        }
        const length = Math.sqrt(x * x + y * y + z * z);
        if (!(length > 0 && length < Infinity)) continue;
        values[at] = x / length;
        values[at + 1] = y / length;
        values[at + 2] = z / length;
      }
    });
    return new BufferAttribute(values, items);
  };

export const unitNormals = unitVectors(3);

/** A tangent without direction leaves the normal as it is. */
export const unitTangents = unitVectors(4);

/** Texture coordinates; values that are not finite become 0. */
export const floatUvs: Conversion = async (source, slices) => {
  const uvs = await asFloats(source, 2, slices);
  const { array } = uvs;
  await slices.over(array.length, (from, to) => {
    for (let i = from; i < to; i += 1) {
      if (!Number.isFinite(array[i])) {
        array[i] = 0;
      }
    }
  });
  return uvs;
};

/** Linear colours, and alpha, clamped to 0–1. */
export const clampedColors: Conversion = async (source, slices) => {
  const items = source.itemSize === 4 ? 4 : 3;
  const values = new Float32Array(source.count * items);
  await slices.over(source.count, (from, to) => {
    for (let i = from; i < to; i += 1) {
      for (let c = 0; c < items; c += 1) {
        const value = source.getComponent(i, c);
        values[i * items + c] = value > 0 ? Math.min(value, 1) : 0;
      }
    }
  });
  return new BufferAttribute(values, items);
};

async function asFloats(
  source: Attribute,
  items: number,
  slices: Slices,
): Promise<BufferAttribute> {
  if (source.itemSize < items) {
    throw new Error(`an attribute has ${String(source.itemSize)} of ${String(items)} parts`);
  }
  const plain = source instanceof BufferAttribute && source.array instanceof Float32Array;
  if (plain && source.itemSize === items && !source.normalized) return source;
  return gathered(source, null, slices, items);
}

/** The unconverted numbers of the vertices that the corners refer to; of all vertices for null. */
export async function gathered(
  source: Attribute,
  corners: ArrayLike<number> | null,
  slices: Slices,
  items = source.itemSize,
): Promise<BufferAttribute> {
  const length = corners?.length ?? source.count;
  const values = new Float32Array(length * items);
  await slices.over(length, (from, to) => {
    for (let i = from; i < to; i += 1) {
      const vertex = corners === null ? i : corners[i]!;
      for (let c = 0; c < items; c += 1) {
        values[i * items + c] = source.getComponent(vertex, c);
      }
    }
  });
  return new BufferAttribute(values, items);
}
