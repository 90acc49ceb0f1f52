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

/**
 * Tests the triangles whose corners are `first` to `end` (excluded) in drawing order, and returns
 * the last hit that `keeps` has kept. Millions can lie on one ray: only that hit and those that
 * `keeps` reads become objects.
 */
export function* searchTriangles(
  ray: ViewRay,
  geometry: BufferGeometry,
  matrixWorld: Matrix4,
  range: readonly [first: number, end: number],
  keeps: (depth: number, front: boolean, read: () => TriangleHit) => boolean,
): RaySearch<TriangleHit | null> {
  const rows = rowsOf(ray, matrixWorld);
  const [rowX, rowY, rowDepth] = rows;
  const { vertex, along, trianglePlaces } = placesIn(geometry, rows);
  // As three.js does: a mirroring matrix swaps front and back.
  const mirrored = matrixWorld.determinant() < 0;
  const hitAt = (corner: number): TriangleHit => {
    const { corners, places } = trianglePlaces(corner);
    const [a, b, c] = places;
    const [atA, atB, atC] = areas(a, b, c);
    const area = atA + atB + atC;
    const weights: Vec3 = [atA / area, atB / area, atC / area];
    const depth = weights[0] * a[2] + weights[1] * b[2] + weights[2] * c[2];
    const front = area > 0 !== mirrored;
    return { triangle: corner / 3, corners, weights, front, depth, rayPlaces: places };
  };
  let here = 0;
  /** -1 for none. */
  let kept = -1;
  let reads = 0;
  const read = (): TriangleHit => {
    reads += READ;
    return hitAt(here);
  };
  const test = (corner: number): number => {
    const a = vertex(corner);
    const b = vertex(corner + 1);
    const c = vertex(corner + 2);
    const ax = along(rowX, a);
    const bx = along(rowX, b);
    const cx = along(rowX, c);
    if ((ax > 0 && bx > 0 && cx > 0) || (ax < 0 && bx < 0 && cx < 0)) return 0; // most triangles are rejected here
    const ay = along(rowY, a);
    const by = along(rowY, b);
    const cy = along(rowY, c);
    // Needed besides the areas below, which can underflow to 0 for a triangle seen edge-on.
    if ((ay > 0 && by > 0 && cy > 0) || (ay < 0 && by < 0 && cy < 0)) return 0;
    // As areas() below, without a list.
    const atA = bx * cy - by * cx;
    const atB = cx * ay - cy * ax;
    const atC = ax * by - ay * bx;
    const area = atA + atB + atC;
    const inside = area > 0 ? atA >= 0 && atB >= 0 && atC >= 0 : atA <= 0 && atB <= 0 && atC <= 0;
    if (!inside || area === 0) return 0;
    const az = along(rowDepth, a);
    const bz = along(rowDepth, b);
    const cz = along(rowDepth, c);
    const depth = (atA / area) * az + (atB / area) * bz + (atC / area) * cz;
    if (!(depth >= ray.near && depth <= ray.far)) return 0;
    here = corner;
    reads = 0;
    if (keeps(depth, area > 0 !== mirrored, read)) {
      kept = corner;
    }
    return HIT + reads;
  };
  const meets = (boxes: BoxList, at: number): boolean =>
    hasZero(rowX, boxes, at) && hasZero(rowY, boxes, at);
  yield* inSteps(geometry, range, meets, test);
  return kept < 0 ? null : hitAt(kept);
}

/** Reads a geometry's triangles in the space whose axes are the rows. */
function placesIn(
  geometry: BufferGeometry,
  [rowX, rowY, rowZ]: readonly [MatrixRow, MatrixRow, MatrixRow],
) {
  const { index } = geometry;
  const position = geometry.getAttribute('position');
  const vertex = (corner: number): number => (index === null ? corner : index.getX(corner));
  const along = (row: MatrixRow, i: number): number =>
    row[0] * position.getX(i) + row[1] * position.getY(i) + row[2] * position.getZ(i) + row[3];
  const placeOf = (i: number): Vec3 => [along(rowX, i), along(rowY, i), along(rowZ, i)];
  /** Of the triangle that begins at this corner. */
  const trianglePlaces = (corner: number) => {
    const [a, b, c] = [vertex(corner), vertex(corner + 1), vertex(corner + 2)];
    return {
      corners: [a, b, c] as const,
      places: [placeOf(a), placeOf(b), placeOf(c)] as const,
    };
  };
  return { vertex, along, trianglePlaces };
}

/**
 * Tests the triangles of the corners `first` to `end` (excluded), but for boxes that do not meet.
 * `test` returns how many more triangles it took the time of.
 */
function* inSteps(
  geometry: BufferGeometry,
  [first, end]: readonly [first: number, end: number],
  meets: BvhQuery['meets'],
  test: (corner: number) => number,
): RaySearch<void> {
  // Runs begin at whole triangles of the index.
  const bvh = first % 3 === 0 ? yield* bvhInSteps(geometry) : null;
  let tested = 0;
  /** True ends a step. */
  const visit = (from: number, to: number): boolean => {
    const last = Math.min(to, end) - 2;
    for (let corner = Math.max(from, first); corner < last; corner += 3) {
      tested += 1 + test(corner);
    }
    if (tested < STEP) return false;
    tested = 0;
    return true;
  };
  for (let at = first; at < end;) {
    if (bvh === null) {
      const from = at;
      at += 3 * STEP;
      visit(from, at);
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
  const rows = rowsOf(
    { frame: { origin, eye: place, ...WORLD_AXES }, slopeX: 0, slopeY: 0, near: 0, far: 0 },
    matrixWorld,
  );
  const [rowX, rowY, rowZ] = rows;
  const { vertex, along, trianglePlaces } = placesIn(geometry, rows);
  const fromEye = subtract(place, eye);
  const mirrored = matrixWorld.determinant() < 0;
  const pointOf = (corner: number): NearPoint => {
    const { corners, places } = trianglePlaces(corner);
    const [a, b, c] = places;
    const weights = nearestWeights(a, b, c);
    const normal = cross(subtract(b, a), subtract(c, a));
    const front = dot(normal, add(a, fromEye)) < 0 !== mirrored;
    return { triangle: corner / 3, corners, weights, front, away: weighted(weights, places) };
  };
  let found: NearPoint | null = null;
  let reach = most;
  const test = (corner: number): number => {
    const [a, b, c] = [vertex(corner), vertex(corner + 1), vertex(corner + 2)];
    // Most triangles are rejected here.
    if (rows.some((row) => isBeyond(along(row, a), along(row, b), along(row, c), reach))) return 0;
    const near = pointOf(corner);
    const away = length(near.away);
    if (!(away <= reach)) return NEAR; // NaN for one of no area
    if (allows(near)) {
      found = near;
      reach = away;
    }
    return NEAR + READ;
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

/** Depth is z: it grows against `back`. */
const WORLD_AXES = { right: [1, 0, 0], up: [0, 1, 0], back: [0, 0, -1] } as const;

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

/**
 * The weights where a ray whose slopes are larger by x and y meets the triangle's plane, inside it
 * or not.
 */
export function weightsBeside({ rayPlaces }: TriangleHit, x: number, y: number): Vec3 {
  const moved = ([right, up, depth]: Vec3): Vec3 => [right - x * depth, up - y * depth, depth];
  const [a, b, c] = rayPlaces;
  const beside = areas(moved(a), moved(b), moved(c));
  return scale(beside, 1 / (beside[0] + beside[1] + beside[2]));
}

/** Twice the signed areas between the ray and each side; their sum is twice the triangle's area. */
const areas = ([ax, ay]: Vec3, [bx, by]: Vec3, [cx, cy]: Vec3): Vec3 => [
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
