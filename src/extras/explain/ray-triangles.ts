// Where the ray through a pixel meets a geometry's triangles, in float64, in a space whose third
// axis is the ray: neighbouring triangles leave no gap (Woop, Benthin, Wald, "Watertight
// Ray/Triangle Intersection", JCGT 2(1), 2013), and flattened, mirrored or huge matrices need no
// inverse.
import type { BufferGeometry, Matrix4 } from 'three';
import type { ShadingFrame } from '../../phong/material/lighting.js';
import { dot, scale, type Vec3 } from '../../phong/math/vector.js';
import { writeModelViewProjection } from '../../viewer/scene/frustum-clip.js';
import { type BoxList, queryBvh } from '../../viewer/scene/triangle-bvh.js';

/** A ray from the eye: along right · slopeX + up · slopeY − back. */
export interface ViewRay {
  readonly frame: ShadingFrame;
  readonly slopeX: number;
  readonly slopeY: number;
  /**
   * Depths between which anything is drawn, measured along the view direction, not along the ray.
   */
  readonly near: number;
  readonly far: number;
}

export interface TriangleHit {
  /** Index of the triangle in drawing order, from 0. */
  readonly triangle: number;
  /** The corners' vertex indices, and their barycentric weights, which add up to 1. */
  readonly corners: readonly [number, number, number];
  readonly weights: Vec3;
  /** Distance from the eye along the view direction. */
  readonly depth: number;
  /** Seen from the front: the corners appear counter-clockwise. */
  readonly front: boolean;
  /**
   * Each corner's distance right of the ray and above it, at the corner's depth, and that depth.
   */
  readonly rayPlaces: readonly [Vec3, Vec3, Vec3];
}

/** Coefficients of x, y, z and 1: an affine function of a vertex in its geometry's own space. */
type MatrixRow = readonly [number, number, number, number];

/**
 * Calls `visit` with every hit of the triangles whose corners are `first` to `end` (excluded) in
 * drawing order.
 */
export function forEachHit(
  ray: ViewRay,
  geometry: BufferGeometry,
  matrixWorld: Matrix4,
  [first, end]: readonly [first: number, end: number],
  visit: (hit: TriangleHit) => void,
): void {
  const { index } = geometry;
  const position = geometry.getAttribute('position');
  const [rowX, rowY, rowDepth] = rowsOf(ray, matrixWorld);
  const along = (row: MatrixRow, i: number): number =>
    row[0] * position.getX(i) + row[1] * position.getY(i) + row[2] * position.getZ(i) + row[3];
  // As three.js does: a mirroring matrix swaps front and back.
  const mirrored = matrixWorld.determinant() < 0;
  const test = (from: number, to: number): void => {
    for (let corner = from; corner + 2 < to; corner += 3) {
      const a = index === null ? corner : index.getX(corner);
      const b = index === null ? corner + 1 : index.getX(corner + 1);
      const c = index === null ? corner + 2 : index.getX(corner + 2);
      const ax = along(rowX, a);
      const bx = along(rowX, b);
      const cx = along(rowX, c);
      if ((ax > 0 && bx > 0 && cx > 0) || (ax < 0 && bx < 0 && cx < 0)) continue; // most triangles are rejected here
      const ay = along(rowY, a);
      const by = along(rowY, b);
      const cy = along(rowY, c);
      // Needed besides the areas below, which can underflow to 0 for a triangle seen edge-on.
      if ((ay > 0 && by > 0 && cy > 0) || (ay < 0 && by < 0 && cy < 0)) continue;
      const [atA, atB, atC] = areas(ax, ay, bx, by, cx, cy);
      const area = atA + atB + atC;
      const inside = area > 0 ? atA >= 0 && atB >= 0 && atC >= 0 : atA <= 0 && atB <= 0 && atC <= 0;
      if (!inside || area === 0) continue;
      const weights: Vec3 = [atA / area, atB / area, atC / area];
      const [az, bz, cz] = [along(rowDepth, a), along(rowDepth, b), along(rowDepth, c)];
      const depth = dot(weights, [az, bz, cz]);
      if (!(depth >= ray.near && depth <= ray.far)) continue;
      const front = area > 0 !== mirrored;
      const rayPlaces = [[ax, ay, az], [bx, by, bz], [cx, cy, cz]] as const; // oxfmt-ignore
      visit({ triangle: corner / 3, corners: [a, b, c], weights, depth, front, rayPlaces });
    }
  };
  // Runs begin at whole triangles of the index.
  if (first % 3 !== 0) {
    test(first, end);
  } else {
    queryBvh(geometry, {
      meets: (boxes, at) => hasZero(rowX, boxes, at) && hasZero(rowY, boxes, at),
      visit: (from, to) => test(Math.max(from, first), Math.min(to, end)),
    });
  }
}

/**
 * The weights where a ray whose slopes are larger by x and y meets the triangle's plane, inside it
 * or not.
 */
export function weightsBeside({ rayPlaces }: TriangleHit, x: number, y: number): Vec3 {
  const [a, b, c] = rayPlaces.map(
    ([right, up, depth]) => [right - x * depth, up - y * depth] as const,
  );
  const beside = areas(...a!, ...b!, ...c!);
  return scale(beside, 1 / (beside[0] + beside[1] + beside[2]));
}

/** Twice the signed areas between the ray and each side; their sum is twice the triangle's area. */
const areas = (ax: number, ay: number, bx: number, by: number, cx: number, cy: number): Vec3 => [
  bx * cy - by * cx,
  cx * ay - cy * ax,
  ax * by - ay * bx,
];

/**
 * Vertex to ray space: distance right of the ray and above it, along the picture's axes, and depth.
 * The eye is subtracted first, so that accuracy does not depend on the distance from the world's
 * origin.
 */
function rowsOf(
  { frame, slopeX, slopeY }: ViewRay,
  { elements }: Matrix4,
): readonly [MatrixRow, MatrixRow, MatrixRow] {
  const m = writeModelViewProjection(
    { frame, slopeX: 1, slopeY: 1 },
    elements,
    new Float64Array(12),
  );
  const row = (at: number, slope: number): MatrixRow => {
    const of = (i: number): number => m[at + i]! - slope * m[8 + i]!;
    return [of(0), of(1), of(2), of(3)];
  };
  return [row(0, slopeX), row(4, slopeY), row(8, 0)];
}

/** False only if the function is above 0, or below, in the whole box; NaN counts as 0. */
function hasZero(row: MatrixRow, boxes: BoxList, at: number): boolean {
  const x = row[0] * boxes[at]!;
  const y = row[1] * boxes[at + 1]!;
  const z = row[2] * boxes[at + 2]!;
  const extent =
    Math.abs(row[0]) * boxes[at + 3]! +
    Math.abs(row[1]) * boxes[at + 4]! +
    Math.abs(row[2]) * boxes[at + 5]!;
  // Far more than the roundings of float64 at a vertex, 1e-16 of each product.
  const slack = 1e-12 * (extent + Math.abs(x) + Math.abs(y) + Math.abs(z) + Math.abs(row[3]));
  return !(Math.abs(x + y + z + row[3]) > extent + slack);
}
