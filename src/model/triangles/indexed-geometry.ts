// Turns corners into a geometry that the GPU reads. Corners that agree in everything share a vertex.
import { BufferAttribute, BufferGeometry } from 'three';
import type { ModelBudget } from '../model-budget.js';
import type { Slices } from '../slices.js';
import { itemAt, NONE, NOT_THERE, type CornerLists, Growing } from './corner-lists.js';

/** Corners from `start` on, up to before `end`. */
export interface CornerRange {
  readonly start: number;
  readonly end: number;
}

/** Null without triangles that are there, all of which must have normals. @throws ModelError `too-large`. */
export async function indexedGeometry(
  lists: CornerLists,
  ranges: readonly CornerRange[],
  withUvs: boolean,
  budget: ModelBudget,
  slices: Slices,
): Promise<BufferGeometry | null> {
  const count = ranges.reduce((sum, { start, end }) => sum + end - start, 0);
  budget.add({ parts: 1, corners: count, values: count });
  const index = new Uint32Array(count);
  const vertices = new Vertices(count);
  const byFace = lists.faceColors.length > 0;
  let next = 0;
  for (const { start, end } of ranges) {
    for (let corner = start; corner < end; corner += 1) {
      if (slices.took(1 / 4)) await slices.pause();
      for (const list of vertices.full) {
        list.grow();
        await slices.pauseIfDue();
      }
      const position = lists.corners.array[corner] ?? 0;
      if (position === NOT_THERE) continue;
      index[next] = vertices.numberOf(
        position,
        withUvs ? itemAt(lists.cornerUvs, corner) : NONE,
        itemAt(lists.cornerNormals, corner),
        // The first colour is that of faces without one.
        byFace ? Math.max(itemAt(lists.triangleColors, Math.floor(corner / 3)), 0) : position,
      );
      next += 1;
    }
  }
  if (next === 0) return null;
  const { length } = vertices;
  const colors = byFace ? lists.faceColors : lists.colors;
  const colored = colors.length > 0;
  budget.add({ values: length * (6 + (withUvs ? 2 : 0) + (colored ? 3 : 0)) });
  const geometry = new BufferGeometry();
  const set = async (
    name: string,
    source: Float32Array,
    numbers: Growing<Int32Array>,
    size: number,
  ): Promise<void> => {
    geometry.setAttribute(name, await gathered(source, numbers, size, slices));
  };
  await set('position', lists.places.array, vertices.positions, 3);
  await set('normal', lists.normals.array, vertices.normals, 3);
  if (withUvs) await set('uv', lists.uvs.array, vertices.uvs, 2);
  if (colored) await set('color', colors.array, vertices.colors, 3);
  const used = index.subarray(0, next);
  geometry.setIndex(new BufferAttribute(length > 0xffff ? used : new Uint16Array(used), 1));
  return geometry;
}

/** Items of `source` by their numbers; zeros for {@link NONE}. */
async function gathered(
  source: Float32Array,
  { array: numbers, length: count }: Growing<Int32Array>,
  size: number,
  slices: Slices,
): Promise<BufferAttribute> {
  const values = new Float32Array(count * size);
  for (let i = 0; i < count; i += 1) {
    if (slices.took(1 / 16)) await slices.pause();
    const from = (numbers[i] ?? NONE) * size;
    if (from < 0) continue;
    for (let c = 0; c < size; c += 1) values[i * size + c] = source[from + c] ?? 0;
  }
  return new BufferAttribute(values, size);
}

const NO_LISTS: readonly Growing<Int32Array>[] = [];

/** Distinct quadruples of numbers, in the order in which they first come. A hash table with open addressing. */
class Vertices {
  readonly positions = new Growing(Int32Array);
  readonly uvs = new Growing(Int32Array);
  readonly normals = new Growing(Int32Array);
  readonly colors = new Growing(Int32Array);
  /** Number of a vertex plus 1; 0 is free. At least half of it stays free. */
  readonly #table: Uint32Array;

  constructor(most: number) {
    this.#table = new Uint32Array(2 ** Math.ceil(Math.log2(Math.max(2 * most, 16))));
  }

  get length(): number {
    return this.positions.length;
  }

  /** The lists that the next vertex makes grow, to be grown one by one. */
  get full(): readonly Growing<Int32Array>[] {
    return this.positions.isFull ? [this.positions, this.uvs, this.normals, this.colors] : NO_LISTS;
  }

  numberOf(position: number, uv: number, normal: number, color: number): number {
    const table = this.#table;
    const mask = table.length - 1;
    for (let slot = hash(position, uv, normal, color) & mask; ; slot = (slot + 1) & mask) {
      const known = (table[slot] ?? 0) - 1;
      if (known < 0) {
        table[slot] = this.length + 1;
        this.positions.push(position);
        this.uvs.push(uv);
        this.normals.push(normal);
        this.colors.push(color);
        return this.length - 1;
      }
      if (
        this.positions.array[known] === position &&
        this.uvs.array[known] === uv &&
        this.normals.array[known] === normal &&
        this.colors.array[known] === color
      ) {
        return known;
      }
    }
  }
}

/** Mixes four numbers to 32 bits. The constants are odd with irregular bits, as in MurmurHash3's final steps. */
function hash(a: number, b: number, c: number, d: number): number {
  let mixed =
    Math.imul(a, 0x9e3779b1) ^
    Math.imul(b + 1, 0x85ebca6b) ^
    Math.imul(c + 1, 0xc2b2ae35) ^
    Math.imul(d + 1, 0x27d4eb2f);
  mixed = Math.imul(mixed ^ (mixed >>> 16), 0x85ebca6b);
  return (mixed ^ (mixed >>> 13)) >>> 0;
}
