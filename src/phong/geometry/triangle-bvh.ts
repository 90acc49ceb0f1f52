// A bounding volume hierarchy of a geometry's triangles, in its own space: boxes around runs of
// triangles in drawing order, and boxes around those. Most triangles are skipped without being
// read. Kept while the geometry is the same.
import type { BufferAttribute, BufferGeometry, InterleavedBufferAttribute } from 'three';
import { ended, type Steps } from './geometry-size.js';

export type Position = BufferAttribute | InterleavedBufferAttribute;

/**
 * Triangles in a box of the lowest level, and boxes in one of the next: a test of a box costs about
 * as much as one of a triangle.
 */
const IN_BOX = 16;

/** Centre and half sizes of each box: six numbers. */
export type BoxList = Float64Array;

interface Bvh {
  readonly position: Position;
  readonly positionVersion: number;
  readonly index: BufferAttribute | null;
  readonly indexVersion: number | undefined;
  readonly corners: number;
  /** From the runs of triangles up to a single box. */
  readonly levels: readonly BoxList[];
}

export interface BvhQuery {
  /** False where nothing in the box counts. Its six numbers begin at `at`. */
  meets(boxes: BoxList, at: number): boolean;
  /**
   * A run of triangles whose boxes all meet: its corners `first` to `end` (excluded). `true` ends
   * the query.
   */
  visit(first: number, end: number): boolean;
}

const hierarchies = new WeakMap<BufferGeometry, Bvh>();

export function queryBvh(geometry: BufferGeometry, query: BvhQuery): void {
  walkBvh(ended(bvhInSteps(geometry)), query);
}

/**
 * Runs a query from a corner on that begins a run. Returns the corner after the run that ended it;
 * Infinity if none did.
 */
export const walkBvh = (bvh: Bvh, query: BvhQuery, from = 0): number =>
  walk(bvh, bvh.levels.length - 1, 0, 1, query, from);

/** The boxes `first` to `end` (excluded) of a level. */
function walk(
  bvh: Bvh,
  level: number,
  first: number,
  end: number,
  query: BvhQuery,
  from: number,
): number {
  const boxes = bvh.levels[level]!;
  const last = Math.min(end, boxes.length / 6);
  const inBox = 3 * IN_BOX ** (level + 1);
  for (let box = Math.max(first, Math.floor(from / inBox)); box < last; box++) {
    if (!query.meets(boxes, 6 * box)) continue;
    if (level > 0) {
      const stopped = walk(bvh, level - 1, IN_BOX * box, IN_BOX * (box + 1), query, from);
      if (stopped < Infinity) return stopped;
    } else {
      const after = Math.min(inBox * (box + 1), bvh.corners);
      if (query.visit(inBox * box, after)) return after;
    }
  }
  return Infinity;
}

/**
 * Triangles in a step of {@link bvhInSteps}: a millisecond. A multiple of {@link IN_BOX}.
 */
const STEP = 2 ** 14;

/** The geometry's boxes as it is now. */
export function* bvhInSteps(geometry: BufferGeometry): Steps<Bvh> {
  const { index } = geometry;
  const position = geometry.getAttribute('position');
  const positionVersion = 'data' in position ? position.data.version : position.version;
  const indexVersion = index?.version;
  const present = hierarchies.get(geometry);
  if (
    present?.position === position &&
    present.index === index &&
    present.positionVersion === positionVersion &&
    present.indexVersion === indexVersion
  ) {
    return present;
  }
  const corners = (index ?? position).count;
  const whole = 3 * Math.floor(corners / 3);
  const runs = new Float64Array(6 * Math.ceil(whole / (3 * IN_BOX)));
  for (let from = 0; from < whole; from += 3 * STEP) {
    writeBoxesOfRuns(runs, position, index, from, Math.min(from + 3 * STEP, whole));
    yield;
  }
  const levels: BoxList[] = [runs];
  for (let below = levels[0]!; below.length > 6; below = levels.at(-1)!) {
    levels.push(boxesAround(below));
  }
  const bvh = { position, positionVersion, index, indexVersion, corners, levels };
  hierarchies.set(geometry, bvh);
  return bvh;
}

/** Writes the boxes of the runs from corner `from` to `to` (excluded). */
function writeBoxesOfRuns(
  boxes: BoxList,
  position: Position,
  index: BufferAttribute | null,
  from: number,
  to: number,
) {
  for (let at = (6 * from) / (3 * IN_BOX), corner = from; corner < to; at += 6) {
    clear();
    for (const end = Math.min(corner + 3 * IN_BOX, to); corner < end; corner++) {
      const vertex = index === null ? corner : index.getX(corner);
      extend(0, position.getX(vertex), 0);
      extend(1, position.getY(vertex), 0);
      extend(2, position.getZ(vertex), 0);
    }
    write(boxes, at);
  }
}

function boxesAround(below: BoxList): BoxList {
  const boxes = new Float64Array(6 * Math.ceil(below.length / (6 * IN_BOX)));
  for (let at = 0, from = 0; from < below.length; at += 6) {
    clear();
    for (const end = Math.min(from + 6 * IN_BOX, below.length); from < end; from += 6) {
      for (let axis = 0; axis < 3; axis++) {
        extend(axis, below[from + axis]!, below[from + 3 + axis]!);
      }
    }
    write(boxes, at);
  }
  return boxes;
}

/** The box that is being measured. */
const low = [0, 0, 0];
const high = [0, 0, 0];

function clear() {
  low.fill(Infinity);
  high.fill(-Infinity);
}

/** NaN stays in the box: its tests then skip nothing. */
function extend(axis: number, center: number, half: number) {
  low[axis] = Math.min(low[axis]!, center - half);
  high[axis] = Math.max(high[axis]!, center + half);
}

function write(boxes: BoxList, at: number) {
  for (let axis = 0; axis < 3; axis++) {
    boxes[at + axis] = (low[axis]! + high[axis]!) / 2;
    boxes[at + 3 + axis] = (high[axis]! - low[axis]!) / 2;
  }
}
