// Turns corners into a geometry that the GPU reads. Corners that agree in everything share a
// vertex.
import type { ModelBudget } from '../../../phong/model/model-budget.js';
import { BufferAttribute, BufferGeometry } from 'three';
import type { Slices } from '../slices.js';
import { itemAt, NONE, NOT_THERE, type CornerLists } from './corner-lists.js';
import { free } from '../limits.js';

/** Corners from `start` on, up to before `end`. */
export interface CornerRange {
  readonly start: number;
  readonly end: number;
}

/** Vertices at one position that are compared. With more, a vertex may be there twice. */
const MOST_COMPARED = 64;

/** Makes the geometries of a file. All triangles that are there must have normals. */
export class IndexedGeometries {
  readonly #lists: CornerLists;
  readonly #budget: ModelBudget;
  readonly #slices: Slices;
  readonly #byFace: boolean;
  /** By position: its latest vertex, counted from 1 over all geometries; 0 for none. */
  readonly #latest: Uint32Array;
  /** Vertices of the geometries before this one. */
  #before = 0;

  constructor(lists: CornerLists, budget: ModelBudget, slices: Slices) {
    this.#lists = lists;
    this.#budget = budget;
    this.#slices = slices;
    this.#byFace = lists.faceColors.length > 0;
    this.#latest = new Uint32Array(lists.places.count);
  }

  /** Null without triangles that are there. @throws ModelError `too-large`. */
  async of(ranges: readonly CornerRange[], withUvs: boolean): Promise<BufferGeometry | null> {
    const lists = this.#lists;
    const slices = this.#slices;
    const count = ranges.reduce((sum, { start, end }) => sum + end - start, 0);
    this.#budget.add({ parts: 1, corners: count, values: count });
    const corners = lists.corners.array;
    const index = new Uint32Array(count);
    /** A corner of each vertex: where its numbers are. */
    const firsts = new Uint32Array(count);
    /** The vertex before it at its position, counted as the latest. */
    const chain = new Uint32Array(count);
    let next = 0;
    let length = 0;
    for (const { start, end } of ranges) {
      await slices.over(end - start, (from, to) => {
        for (let corner = start + from; corner < start + to; corner += 1) {
          const position = corners[corner]!;
          if (position === NOT_THERE) continue;
          const latest = this.#latest[position]!;
          let vertex = latest - this.#before - 1;
          for (let i = 0; vertex >= 0 && !this.#agree(firsts[vertex]!, corner, withUvs); i += 1) {
            vertex = i < MOST_COMPARED ? chain[vertex]! - this.#before - 1 : NONE;
          }
          if (vertex < 0) {
            vertex = length++;
            firsts[vertex] = corner;
            chain[vertex] = latest;
            this.#latest[position] = this.#before + length;
          }
          index[next++] = vertex;
        }
      });
    }
    this.#before += length;
    if (next === 0) return null;
    const colors = this.#byFace ? lists.faceColors : lists.colors;
    const colored = colors.length > 0;
    this.#budget.add({ values: length * (6 + (withUvs ? 2 : 0) + (colored ? 3 : 0)) });
    const geometry = new BufferGeometry();
    const set = async (
      name: string,
      { array }: { readonly array: Float32Array },
      numberOf: (corner: number) => number,
      size: number,
    ): Promise<void> => {
      geometry.setAttribute(
        name,
        await gathered(array, firsts.subarray(0, length), numberOf, size, slices),
      );
    };
    const positionOf = (corner: number) => corners[corner]!;
    await set('position', lists.places, positionOf, 3);
    await set('normal', lists.normals, (corner) => itemAt(lists.cornerNormals, corner), 3);
    if (withUvs) {
      await set('uv', lists.uvs, (corner) => itemAt(lists.cornerUvs, corner), 2);
    }
    if (colored) {
      await set('color', colors, this.#byFace ? this.#faceColorOf : positionOf, 3);
    }
    const used = index.subarray(0, next);
    geometry.setIndex(new BufferAttribute(length > 0xffff ? used : new Uint16Array(used), 1));
    free(firsts, chain);
    return geometry;
  }

  /** Whether two corners at one position are one vertex. */
  #agree(a: number, b: number, withUvs: boolean): boolean {
    const { cornerNormals, cornerUvs } = this.#lists;
    return (
      itemAt(cornerNormals, a) === itemAt(cornerNormals, b) &&
      (!withUvs || itemAt(cornerUvs, a) === itemAt(cornerUvs, b)) &&
      (!this.#byFace || this.#faceColorOf(a) === this.#faceColorOf(b))
    );
  }

  /** The first colour is that of faces without one. */
  readonly #faceColorOf = (corner: number): number =>
    Math.max(itemAt(this.#lists.triangleColors, Math.floor(corner / 3)), 0);
}

/** Items of `source` by the numbers of these corners; zeros for {@link NONE}. */
async function gathered(
  source: Float32Array,
  corners: Uint32Array,
  numberOf: (corner: number) => number,
  size: number,
  slices: Slices,
): Promise<BufferAttribute> {
  const values = new Float32Array(corners.length * size);
  await slices.over(corners.length, (start, end) => {
    for (let i = start; i < end; i += 1) {
      const from = numberOf(corners[i]!) * size;
      if (from < 0) continue;
      for (let c = 0; c < size; c += 1) {
        values[i * size + c] = source[from + c]!;
      }
    }
  });
  return new BufferAttribute(values, size);
}
