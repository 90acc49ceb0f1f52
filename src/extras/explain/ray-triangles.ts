// Where the ray through a pixel meets a geometry's triangles, in float64, in a space whose third
// axis is the ray: neighbouring triangles leave no gap (Woop, Benthin, Wald, "Watertight
// Ray/Triangle Intersection", JCGT 2(1), 2013), and flattened, mirrored or huge matrices need no
// inverse.
import type { BufferGeometry, Matrix4 } from 'three';
import type { ShadingFrame } from '../../phong/material/shading-space.js';
import {
  add,
  clamp,
  cross,
  dot,
  length,
  scale,
  subtract,
  type Vec3,
} from '../../phong/math/vector.js';
import {
  type BoxList,
  type BvhQuery,
  bvhInSteps,
  walkBvh,
} from '../../phong/geometry/triangle-bvh.js';
import { writeModelViewProjection } from '../../phong/geometry/frustum-clip.js';

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

export interface TrianglePoint {
  /** Index of the triangle in drawing order, from 0. */
  readonly triangle: number;
  /** The corners' vertex indices, and their barycentric weights, which add up to 1. */
  readonly corners: readonly [number, number, number];
  readonly weights: Vec3;
  /** Seen from the front: the corners appear counter-clockwise. */
  readonly front: boolean;
}

export interface TriangleHit extends TrianglePoint {
  /** Distance from the eye along the view direction. */
  readonly depth: number;
  /**
   * Each corner's distance right of the ray and above it, at the corner's depth, and that depth.
   */
  readonly rayPlaces: readonly [Vec3, Vec3, Vec3];
}

/** Coefficients of x, y, z and 1: an affine function of a vertex in its geometry's own space. */
type MatrixRow = readonly [number, number, number, number];

/** A search by rays, in steps. */
export type RaySearch<Answer> = Generator<undefined, Answer, undefined>;

/** Triangles in a step: about a millisecond. */
const STEP = 2 ** 14;

/**
 * A hit counts as {@link HIT} more triangles, and as {@link READ} more if it is read: a miss takes
 * 60 ns, a hit 160, and reading one 250, or more with a texture.
 */
const HIT = 2;
const READ = 16;

/** A triangle near the point that {@link searchNear} starts from counts as this many more: 2 µs. */
const NEAR = 32;

/** The numbers of a hit: first corner, vertices, weights, depth, front, and nine of its corners. */
type HitNumbers = Float64Array;

/**
 * Tests the triangles whose corners are `first` to `end` (excluded) in drawing order, and returns
 * the last hit that `keeps` has kept. Millions can lie on one ray: only that hit and those that
 * `keeps` reads become objects.
 */
export function* searchTriangles(
  ray: ViewRay,
  geometry: BufferGeometry,
  matrixWorld: Matrix4,
  [first, end]: readonly [first: number, end: number],
  keeps: (depth: number, front: boolean, read: () => TriangleHit) => boolean,
): RaySearch<TriangleHit | null> {
  const { index } = geometry;
  const position = geometry.getAttribute('position');
  const [rowX, rowY, rowDepth] = rowsOf(ray, matrixWorld);
  const along = (row: MatrixRow, i: number): number =>
    row[0] * position.getX(i) + row[1] * position.getY(i) + row[2] * position.getZ(i) + row[3];
  // As three.js does: a mirroring matrix swaps front and back.
  const mirrored = matrixWorld.determinant() < 0;
  let here: HitNumbers = new Float64Array(18);
  let kept: HitNumbers = new Float64Array(18);
  let found = false as boolean;
  let tested = 0;
  const read = (): TriangleHit => {
    tested += READ;
    return hitOf(here);
  };
  /** True ends a step. */
  const test = (from: number, to: number): boolean => {
    tested += (to - from) / 3;
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
      // As areas() below, without a list.
      const atA = bx * cy - by * cx;
      const atB = cx * ay - cy * ax;
      const atC = ax * by - ay * bx;
      const area = atA + atB + atC;
      const inside = area > 0 ? atA >= 0 && atB >= 0 && atC >= 0 : atA <= 0 && atB <= 0 && atC <= 0;
      if (!inside || area === 0) continue;
      const az = along(rowDepth, a);
      const bz = along(rowDepth, b);
      const cz = along(rowDepth, c);
      const depth = (atA / area) * az + (atB / area) * bz + (atC / area) * cz;
      if (!(depth >= ray.near && depth <= ray.far)) continue;
      const front = area > 0 !== mirrored;
      tested += HIT;
      here[0] = corner;
      here[1] = a;
      here[2] = b;
      here[3] = c;
      here[4] = atA / area;
      here[5] = atB / area;
      here[6] = atC / area;
      here[7] = depth;
      here[8] = front ? 1 : 0;
      here[9] = ax;
      here[10] = ay;
      here[11] = az;
      here[12] = bx;
      here[13] = by;
      here[14] = bz;
      here[15] = cx;
      here[16] = cy;
      here[17] = cz;
      if (!keeps(depth, front, read)) continue;
      found = true;
      const free = kept;
      kept = here;
      here = free;
    }
    if (tested < STEP) return false;
    tested = 0;
    return true;
  };
  const meets = (boxes: BoxList, at: number): boolean =>
    hasZero(rowX, boxes, at) && hasZero(rowY, boxes, at);
  yield* inSteps(geometry, [first, end], meets, test);
  return found ? hitOf(kept) : null;
}

/**
 * Tests runs of triangles of the corners `first` to `end` (excluded), but for boxes that do not
 * meet, until `test` ends a step.
 */
function* inSteps(
  geometry: BufferGeometry,
  [first, end]: readonly [first: number, end: number],
  meets: BvhQuery['meets'],
  test: (from: number, to: number) => boolean,
): RaySearch<void> {
  // Runs begin at whole triangles of the index.
  const bvh = first % 3 === 0 ? yield* bvhInSteps(geometry) : null;
  const visit = (from: number, to: number): boolean =>
    test(Math.max(from, first), Math.min(to, end));
  for (let at = first; at < end;) {
    if (bvh === null) {
      const from = at;
      at += 3 * STEP;
      test(from, Math.min(at, end));
    } else {
      at = walkBvh(bvh, { meets, visit }, at);
    }
    yield;
  }
}

/** A point of a triangle, and its place relative to the one that was searched from. */
interface NearPoint extends TrianglePoint {
  readonly away: Vec3;
}

/**
 * The point of any triangle that is nearest to a place, at most `most` away from it: of the same
 * triangles as {@link searchTriangles}, and the last of equal ones that `allows` does not refuse.
 */
export function* searchNear(
  { origin, eye }: ShadingFrame,
  place: Vec3,
  geometry: BufferGeometry,
  matrixWorld: Matrix4,
  range: readonly [first: number, end: number],
  most: number,
  allows: (near: NearPoint) => boolean,
): RaySearch<NearPoint | null> {
  const { index } = geometry;
  const position = geometry.getAttribute('position');
  const rows = rowsOf(
    { frame: { origin, eye: place, ...WORLD_AXES }, slopeX: 0, slopeY: 0, near: 0, far: 0 },
    matrixWorld,
  );
  const [rowX, rowY, rowZ] = rows;
  const along = (row: MatrixRow, i: number): number =>
    row[0] * position.getX(i) + row[1] * position.getY(i) + row[2] * position.getZ(i) + row[3];
  const vertex = (corner: number): number => (index === null ? corner : index.getX(corner));
  const placeOf = (i: number): Vec3 => [along(rowX, i), along(rowY, i), -along(rowZ, i)];
  const fromEye = subtract(place, eye);
  const mirrored = matrixWorld.determinant() < 0;
  const pointOf = (corner: number): NearPoint => {
    const corners = [vertex(corner), vertex(corner + 1), vertex(corner + 2)] as const;
    const [a, b, c] = [placeOf(corners[0]), placeOf(corners[1]), placeOf(corners[2])];
    const weights = nearestWeights(a, b, c);
    const normal = cross(subtract(b, a), subtract(c, a));
    const front = dot(normal, add(a, fromEye)) < 0 !== mirrored;
    return { triangle: corner / 3, corners, weights, front, away: weighted(weights, [a, b, c]) };
  };
  let found: NearPoint | null = null;
  let reach = most;
  let tested = 0;
  const test = (from: number, to: number): boolean => {
    tested += (to - from) / 3;
    for (let corner = from; corner + 2 < to; corner += 3) {
      const [a, b, c] = [vertex(corner), vertex(corner + 1), vertex(corner + 2)];
      // Most triangles are rejected here.
      if (rows.some((row) => isBeyond(along(row, a), along(row, b), along(row, c), reach)))
        continue;
      tested += NEAR;
      const near = pointOf(corner);
      const away = length(near.away);
      if (!(away <= reach)) continue; // NaN for one of no area
      tested += READ;
      if (!allows(near)) continue;
      found = near;
      reach = away;
    }
    if (tested < STEP) return false;
    tested = 0;
    return true;
  };
  const meets = (boxes: BoxList, at: number): boolean => {
    const x = distanceToZero(rowX, boxes, at);
    const y = distanceToZero(rowY, boxes, at);
    const z = distanceToZero(rowZ, boxes, at);
    return !(x * x + y * y + z * z > reach * reach);
  };
  yield* inSteps(geometry, range, meets, test);
  return found;
}

const WORLD_AXES = { right: [1, 0, 0], up: [0, 1, 0], back: [0, 0, 1] } as const;

const isBeyond = (a: number, b: number, c: number, reach: number): boolean =>
  (a > reach && b > reach && c > reach) || (a < -reach && b < -reach && c < -reach);

export const weighted = (weights: Vec3, [a, b, c]: readonly [Vec3, Vec3, Vec3]): Vec3 =>
  add(add(scale(a, weights[0]), scale(b, weights[1])), scale(c, weights[2]));

/**
 * Weights of the point of a triangle that is nearest to the origin: inside it where the origin lies
 * above it, else the nearest of its sides.
 */
function nearestWeights(a: Vec3, b: Vec3, c: Vec3): Vec3 {
  const normal = cross(subtract(b, a), subtract(c, a));
  // Twice the areas that the origin's foot on the plane spans with each side, times the normal's
  // length.
  const inside: Vec3 = [
    dot(normal, cross(b, c)),
    dot(normal, cross(c, a)),
    dot(normal, cross(a, b)),
  ];
  if (Math.min(...inside) >= 0) return scale(inside, 1 / (inside[0] + inside[1] + inside[2]));
  const sides: readonly Vec3[] = [
    ((t: number): Vec3 => [1 - t, t, 0])(shareAlong(a, b)),
    ((t: number): Vec3 => [0, 1 - t, t])(shareAlong(b, c)),
    ((t: number): Vec3 => [t, 0, 1 - t])(shareAlong(c, a)),
  ];
  const distances = sides.map((weights) => length(weighted(weights, [a, b, c])));
  return sides[distances.indexOf(Math.min(...distances))]!;
}

/** Share of the way between two points at which it is nearest to the origin. */
function shareAlong(from: Vec3, to: Vec3): number {
  const way = subtract(to, from);
  return clamp(-dot(from, way) / dot(way, way), 0, 1);
}

const hitOf = (n: HitNumbers): TriangleHit => ({
  triangle: n[0]! / 3,
  corners: [n[1]!, n[2]!, n[3]!],
  weights: [n[4]!, n[5]!, n[6]!],
  depth: n[7]!,
  front: n[8] === 1,
  rayPlaces: [
    [n[9]!, n[10]!, n[11]!],
    [n[12]!, n[13]!, n[14]!],
    [n[15]!, n[16]!, n[17]!],
  ],
});

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
const hasZero = (row: MatrixRow, boxes: BoxList, at: number): boolean =>
  !(distanceToZero(row, boxes, at) > 0);

/** The least absolute value of a function in a box, or a little less. */
function distanceToZero(row: MatrixRow, boxes: BoxList, at: number): number {
  const x = row[0] * boxes[at]!;
  const y = row[1] * boxes[at + 1]!;
  const z = row[2] * boxes[at + 2]!;
  const extent =
    Math.abs(row[0]) * boxes[at + 3]! +
    Math.abs(row[1]) * boxes[at + 4]! +
    Math.abs(row[2]) * boxes[at + 5]!;
  // Far more than the roundings of float64 at a vertex, 1e-16 of each product.
  const slack = 1e-12 * (extent + Math.abs(x) + Math.abs(y) + Math.abs(z) + Math.abs(row[3]));
  return Math.max(Math.abs(x + y + z + row[3]) - (extent + slack), 0);
}
