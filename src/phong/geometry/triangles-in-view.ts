// Skips most triangles of a large geometry that are out of view or too far. Fetched with the first
// such geometry: without it all of them are read, with the same result.
import type { BufferGeometry } from 'three';
import { type ClipRows, coordinate, depthOf } from './frustum-clip.js';
import { type BoxList, type BvhQuery, queryBvh } from './triangle-bvh.js';

/** Visits runs of triangles whose boxes are in view before the depth `nearest`. */
export interface InViewQuery extends Pick<BvhQuery, 'visit'> {
  /** May become less with each visit. */
  readonly nearest: number;
  /** From the geometry's own space to clip coordinates. */
  readonly matrix: ClipRows;
}

export function visitInView(geometry: BufferGeometry, query: InViewQuery): void {
  inView.query = query;
  queryBvh(geometry, inView);
}

/** Used within one call: nothing is allocated in a frame. */
const inView = {
  query: null as unknown as InViewQuery,

  meets(boxes: BoxList, at: number): boolean {
    const { matrix, nearest } = this.query;
    return boxIsInView(matrix, boxes, at, nearest);
  },

  visit(first: number, end: number): boolean {
    return this.query.visit(first, end);
  },
};

/** False only if a box of the object's own space has nothing in view before this depth. */
function boxIsInView(m: ClipRows, boxes: BoxList, at: number, before: number): boolean {
  const cx = boxes[at]!;
  const cy = boxes[at + 1]!;
  const cz = boxes[at + 2]!;
  const w = depthOf(m, cx, cy, cz);
  if (w - extent(m, 0, 0, boxes, at) >= before) return false;
  const x = coordinate(m, 0, cx, cy, cz);
  const y = coordinate(m, 4, cx, cy, cz);
  return !(
    x - w > extent(m, 0, -1, boxes, at) ||
    -x - w > extent(m, 0, 1, boxes, at) ||
    y - w > extent(m, 4, -1, boxes, at) ||
    -y - w > extent(m, 4, 1, boxes, at)
  );
}

/**
 * How much w plus `share` of a coordinate changes from a box's centre to a corner, and a little for
 * rounding.
 */
function extent(m: ClipRows, row: number, share: number, boxes: BoxList, at: number): number {
  const sum =
    Math.abs(m[8]! + share * m[row]!) * boxes[at + 3]! +
    Math.abs(m[9]! + share * m[row + 1]!) * boxes[at + 4]! +
    Math.abs(m[10]! + share * m[row + 2]!) * boxes[at + 5]!;
  // Far more than float64 loses, 1e-16 of each product.
  return sum + 1e-12 * (sum + Math.abs(m[11]!) + Math.abs(m[row + 3]!));
}
