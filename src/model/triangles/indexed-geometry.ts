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
  const vertices = new Vertices(lists.places.count);
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

const NO_LISTS: readonly [] = [];

/** Vertices at one position that are compared. With more, a vertex may be there twice. */
const MOST_COMPARED = 64;

/** Distinct quadruples of numbers, in the order in which they first come; those of a position are chained. */
class Vertices {
  readonly positions = new Growing(Int32Array);
  readonly uvs = new Growing(Int32Array);
  readonly normals = new Growing(Int32Array);
  readonly colors = new Growing(Int32Array);
  /** By position: number plus 1 of its latest vertex; 0 for none. */
  readonly #latest: Uint32Array;
  /** By vertex: number plus 1 of the one before it at its position. */
  readonly #before = new Growing(Uint32Array);

  constructor(positions: number) {
    this.#latest = new Uint32Array(positions);
  }

  get length(): number {
    return this.positions.length;
  }

  /** The lists that the next vertex makes grow, to be grown one by one. */
  get full(): readonly Pick<Growing<Int32Array>, 'grow'>[] {
    const { positions, uvs, normals, colors } = this;
    return positions.isFull ? [positions, uvs, normals, colors, this.#before] : NO_LISTS;
  }

  numberOf(position: number, uv: number, normal: number, color: number): number {
    const latest = this.#latest[position] ?? 0;
    for (
      let next = latest, i = 0;
      next > 0 && i < MOST_COMPARED;
      next = this.#before.array[next - 1] ?? 0, i++
    ) {
      const known = next - 1;
      const { uvs, normals, colors } = this;
      if (uvs.array[known] === uv && normals.array[known] === normal && colors.array[known] === color)
        return known;
    }
    this.#before.push(latest);
    this.positions.push(position);
    this.uvs.push(uv);
    this.normals.push(normal);
    this.colors.push(color);
    this.#latest[position] = this.length;
    return this.length - 1;
  }
}
