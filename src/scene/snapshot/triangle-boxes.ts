// Which triangles of a geometry can a ray meet? Boxes around runs of triangles in drawing order, and boxes around those, in the
// geometry's own space. Kept while the geometry is the same: one explanation is often followed by thousands. Knows no rays, only
// affine functions that are 0 on them.
import type { BufferAttribute, BufferGeometry, InterleavedBufferAttribute } from 'three';

/** Coefficients of x, y, z and 1: an affine function of a vertex in its geometry's own space. */
export type Row = readonly [number, number, number, number];

/** Triangles in a box of the lowest level, and boxes in one of the next: a test of a box costs about as much as one of a triangle. */
const IN_RUN = 16;

/** Boxes of a level: centre and half sizes of each, six numbers. */
type Level = Float64Array;

interface Boxes {
  readonly position: BufferAttribute | InterleavedBufferAttribute;
  readonly index: BufferAttribute | null;
  readonly versions: string;
  /** From the runs of triangles up to a single box. */
  readonly levels: readonly Level[];
}

const known = new WeakMap<BufferGeometry, Boxes>();

/**
 * Calls `visit` with corners, first and end (excluded), of every run of triangles in whose box both functions are 0 somewhere,
 * each at its own place. In drawing order.
 */
export function forEachRun(
  geometry: BufferGeometry,
  rowX: Row,
  rowY: Row,
  visit: (first: number, end: number) => void,
): void {
  const { levels } = boxesOf(geometry);
  const corners = (geometry.index ?? geometry.getAttribute('position')).count;
  const walk = (level: number, first: number, end: number): void => {
    const boxes = levels[level]!;
    for (let box = first; box < Math.min(end, boxes.length / 6); box++) {
      if (!hasZero(rowX, boxes, 6 * box) || !hasZero(rowY, boxes, 6 * box)) continue;
      if (level > 0) walk(level - 1, IN_RUN * box, IN_RUN * (box + 1));
      else visit(3 * IN_RUN * box, Math.min(3 * IN_RUN * (box + 1), corners));
    }
  };
  walk(levels.length - 1, 0, 1);
}

/** False only if the function is above 0, or below, in the whole box; NaN counts as 0. */
function hasZero(row: Row, boxes: Level, at: number): boolean {
  const x = row[0] * boxes[at]!;
  const y = row[1] * boxes[at + 1]!;
  const z = row[2] * boxes[at + 2]!;
  const extent =
    Math.abs(row[0]) * boxes[at + 3]! + Math.abs(row[1]) * boxes[at + 4]! + Math.abs(row[2]) * boxes[at + 5]!;
  // Far more than the roundings of float64 at a vertex, 1e-16 of each product.
  const slack = 1e-12 * (extent + Math.abs(x) + Math.abs(y) + Math.abs(z) + Math.abs(row[3]));
  return !(Math.abs(x + y + z + row[3]) > extent + slack);
}

function boxesOf(geometry: BufferGeometry): Boxes {
  const { index } = geometry;
  const position = geometry.getAttribute('position');
  const versions = `${String(versionOf(position))} ${String(index?.version)}`;
  const present = known.get(geometry);
  if (present?.position === position && present.index === index && present.versions === versions)
    return present;
  const corner = (i: number, axis: number): number =>
    position.getComponent(index === null ? i : index.getX(i), axis);
  const triangles = Math.floor((index ?? position).count / 3);
  const levels = [
    level(Math.ceil(triangles / IN_RUN), (run, axis, extend) => {
      const end = Math.min(3 * IN_RUN * (run + 1), 3 * triangles);
      for (let i = 3 * IN_RUN * run; i < end; i++) extend(corner(i, axis), 0);
    }),
  ];
  for (let below = levels[0]!; below.length > 6; below = levels.at(-1)!) {
    const count = below.length / 6;
    const inner = below;
    levels.push(
      level(Math.ceil(count / IN_RUN), (box, axis, extend) => {
        for (let i = IN_RUN * box; i < Math.min(IN_RUN * (box + 1), count); i++)
          extend(inner[6 * i + axis]!, inner[6 * i + 3 + axis]!);
      }),
    );
  }
  const boxes = { position, index, versions, levels };
  known.set(geometry, boxes);
  return boxes;
}

/** `fill` calls `extend` with centre and half size of everything in a box, along one axis. */
function level(
  count: number,
  fill: (box: number, axis: number, extend: (centre: number, half: number) => void) => void,
): Level {
  const boxes = new Float64Array(6 * count);
  for (let box = 0; box < count; box++) {
    for (let axis = 0; axis < 3; axis++) {
      let low = Infinity;
      let high = -Infinity;
      fill(box, axis, (centre, half) => {
        low = Math.min(low, centre - half);
        high = Math.max(high, centre + half);
      });
      boxes[6 * box + axis] = (low + high) / 2;
      boxes[6 * box + 3 + axis] = (high - low) / 2;
    }
  }
  return boxes;
}

const versionOf = (attribute: BufferAttribute | InterleavedBufferAttribute): number =>
  'data' in attribute ? attribute.data.version : attribute.version;
