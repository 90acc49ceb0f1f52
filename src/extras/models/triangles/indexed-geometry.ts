// Turns corners into a geometry that the GPU reads. Corners that agree in everything share a
// vertex.
import type { ModelBudget } from '../../../phong/model/model-budget.js';
import { BufferAttribute, BufferGeometry } from 'three';
import type { Slices } from '../slices.js';
import { NONE, NOT_THERE, type CornerLists } from './corner-lists.js';
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
    if (this.#byFace) {
      lists.triangleColors.fillTo(lists.triangles, 0);
    }
    this.#latest = new Uint32Array(lists.places.count);
  }

  /** Null without triangles that are there. @throws ModelError `too-large`. */
  async of(ranges: readonly CornerRange[], withUvs: boolean): Promise<BufferGeometry | null> {
    const lists = this.#lists;
    const slices = this.#slices;
    const count = ranges.reduce((sum, { start, end }) => sum + end - start, 0);
    this.#budget.add({ parts: 1, corners: count, values: count });
    const corners = lists.corners.array;
    if (withUvs) {
      lists.cornerUvs.fillTo(lists.corners.length, NONE);
    }
    const normals = lists.cornerNormals.array;
    const uvs = withUvs ? lists.cornerUvs.array : null;
    const triangleColors = this.#byFace ? lists.triangleColors.array : null;
    const faceColor = (corner: number) => triangleColors?.[Math.floor(corner / 3)];
    /** Whether two corners at one position are one vertex. */
    const agree = (a: number, b: number) =>
      normals[a] === normals[b] && uvs?.[a] === uvs?.[b] && faceColor(a) === faceColor(b);
    const { index, firsts, length } = await this.#joined(ranges, count, agree);
    if (index.length === 0) return null;
    const colors = this.#byFace ? lists.faceColors : lists.colors;
    const colored = colors.length > 0;
    this.#budget.add({ values: length * (6 + (withUvs ? 2 : 0) + (colored ? 3 : 0)) });
    const geometry = new BufferGeometry();
    const set = async (
      name: string,
      { array }: { readonly array: Float32Array },
      numbers: Int32Array | Uint32Array,
      size = 3,
      cornersEach = 1,
    ) => {
      const values = new Float32Array(length * size);
      await slices.over(length, (from, to) => {
        for (let vertex = from; vertex < to; vertex += 1) {
          const number = numbers[Math.floor(firsts[vertex]! / cornersEach)]!;
          if (number === NONE) continue;
          for (let c = 0; c < size; c += 1) {
            values[vertex * size + c] = array[number * size + c]!;
          }
        }
      });
      geometry.setAttribute(name, new BufferAttribute(values, size));
    };
    await set('position', lists.places, corners);
    await set('normal', lists.normals, normals);
    if (uvs) {
      await set('uv', lists.uvs, uvs, 2);
    }
    if (triangleColors) {
      await set('color', colors, triangleColors, 3, 3);
    } else if (colored) {
      await set('color', colors, corners);
    }
    geometry.setIndex(new BufferAttribute(length > 0xffff ? index : new Uint16Array(index), 1));
    free(firsts);
    return geometry;
  }

  /**
   * The vertices of `count` corners: those at one position that agree are one vertex. `index`: the
   * vertex of each corner that is there. `firsts`: a corner of each vertex.
   */
  async #joined(
    ranges: readonly CornerRange[],
    count: number,
    agree: (a: number, b: number) => boolean,
  ) {
    const corners = this.#lists.corners.array;
    const latestAt = this.#latest;
    const before = this.#before;
    const index = new Uint32Array(count);
    const firsts = new Uint32Array(count);
    /** The vertex before it at its position, counted as the latest. */
    const chain = new Uint32Array(count);
    let next = 0;
    let length = 0;
    for (const { start, end } of ranges) {
      await this.#slices.over(end - start, (from, to) => {
        for (let corner = start + from; corner < start + to; corner += 1) {
          const position = corners[corner]!;
          if (position === NOT_THERE) continue;
          const latest = latestAt[position]!;
          let vertex = latest - before - 1;
          for (let i = 0; vertex >= 0 && !agree(firsts[vertex]!, corner); i += 1) {
            vertex = i < MOST_COMPARED ? chain[vertex]! - before - 1 : NONE;
          }
          if (vertex < 0) {
            vertex = length++;
            firsts[vertex] = corner;
            chain[vertex] = latest;
            latestAt[position] = before + length;
          }
          index[next++] = vertex;
        }
      });
    }
    this.#before += length;
    free(chain);
    return { index: index.subarray(0, next), firsts, length };
  }
}
