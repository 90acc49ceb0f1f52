// Boxes around runs of a geometry's triangles in drawing order, and boxes around those, in the geometry's own space:
// most triangles are skipped without being read. Kept while the geometry is the same.
import type { BufferAttribute, BufferGeometry, InterleavedBufferAttribute } from 'three';

/**
 * Triangles in a box of the lowest level, and boxes in one of the next: a test of a box costs about as much as one of
 * a triangle.
 */
const IN_RUN = 16;

/** Centre and half sizes of each box, six numbers. */
export type BoxList = Float64Array;

interface Boxes {
  readonly position: BufferAttribute | InterleavedBufferAttribute;
  readonly positionVersion: number;
  readonly index: BufferAttribute | null;
  readonly indexVersion: number | undefined;
  /** From the runs of triangles up to a single box. */
  readonly levels: readonly BoxList[];
}

const known = new WeakMap<BufferGeometry, Boxes>();

/**
 * Calls `visit` with corners, first and end (excluded), of every run of triangles for whose box `meets` is true. In
 * drawing order. `meets` gets a list and where the box's six numbers begin.
 */
export function forEachRun(
  geometry: BufferGeometry,
  meets: (boxes: BoxList, at: number) => boolean,
  visit: (first: number, end: number) => void,
): void {
  const { levels } = boxesOf(geometry);
  const corners = (geometry.index ?? geometry.getAttribute('position')).count;
  walk(levels, levels.length - 1, 0, 1, corners, meets, visit);
}

/** The boxes `first` to `end` (excluded) of a level. */
function walk(
  levels: readonly BoxList[],
  level: number,
  first: number,
  end: number,
  corners: number,
  meets: (boxes: BoxList, at: number) => boolean,
  visit: (first: number, end: number) => void,
): void {
  const boxes = levels[level]!;
  const last = Math.min(end, boxes.length / 6);
  for (let box = first; box < last; box++) {
    if (!meets(boxes, 6 * box)) continue;
    if (level > 0) walk(levels, level - 1, IN_RUN * box, IN_RUN * (box + 1), corners, meets, visit);
    else visit(3 * IN_RUN * box, Math.min(3 * IN_RUN * (box + 1), corners));
  }
}

function boxesOf(geometry: BufferGeometry): Boxes {
  const { index } = geometry;
  const position = geometry.getAttribute('position');
  const positionVersion = versionOf(position);
  const indexVersion = index?.version;
  const present = known.get(geometry);
  if (
    present?.position === position &&
    present.index === index &&
    present.positionVersion === positionVersion &&
    present.indexVersion === indexVersion
  )
    return present;
  const levels = [runBoxes(position, index)];
  for (let below = levels[0]!; below.length > 6; below = levels.at(-1)!) levels.push(boxesAround(below));
  const boxes = { position, positionVersion, index, indexVersion, levels };
  known.set(geometry, boxes);
  return boxes;
}

/** The lowest level. */
function runBoxes(
  position: BufferAttribute | InterleavedBufferAttribute,
  index: BufferAttribute | null,
): BoxList {
  const corners = 3 * Math.floor((index ?? position).count / 3);
  const boxes = new Float64Array(6 * Math.ceil(corners / (3 * IN_RUN)));
  const low: [number, number, number] = [0, 0, 0];
  const high: [number, number, number] = [0, 0, 0];
  for (let at = 0, first = 0; first < corners; at += 6, first += 3 * IN_RUN) {
    low.fill(Infinity);
    high.fill(-Infinity);
    const end = Math.min(first + 3 * IN_RUN, corners);
    for (let corner = first; corner < end; corner++) {
      const vertex = index === null ? corner : index.getX(corner);
      extend(low, high, 0, position.getX(vertex), 0);
      extend(low, high, 1, position.getY(vertex), 0);
      extend(low, high, 2, position.getZ(vertex), 0);
    }
    write(boxes, at, low, high);
  }
  return boxes;
}

/** The next level. */
function boxesAround(below: BoxList): BoxList {
  const count = below.length / 6;
  const boxes = new Float64Array(6 * Math.ceil(count / IN_RUN));
  const low: [number, number, number] = [0, 0, 0];
  const high: [number, number, number] = [0, 0, 0];
  for (let box = 0; 6 * box < boxes.length; box++) {
    low.fill(Infinity);
    high.fill(-Infinity);
    for (let i = IN_RUN * box; i < Math.min(IN_RUN * (box + 1), count); i++)
      for (const axis of [0, 1, 2] as const) extend(low, high, axis, below[6 * i + axis]!, below[6 * i + 3 + axis]!); // prettier-ignore
    write(boxes, 6 * box, low, high);
  }
  return boxes;
}

type Corner = [number, number, number];

/** NaN stays in the box: its tests then skip nothing. */
function extend(low: Corner, high: Corner, axis: 0 | 1 | 2, center: number, half: number): void {
  low[axis] = Math.min(low[axis], center - half);
  high[axis] = Math.max(high[axis], center + half);
}

function write(boxes: BoxList, at: number, low: Corner, high: Corner): void {
  for (const axis of [0, 1, 2] as const) {
    boxes[at + axis] = (low[axis] + high[axis]) / 2;
    boxes[at + 3 + axis] = (high[axis] - low[axis]) / 2;
  }
}

const versionOf = (attribute: BufferAttribute | InterleavedBufferAttribute): number =>
  'data' in attribute ? attribute.data.version : attribute.version;
