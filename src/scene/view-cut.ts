// Cuts triangles by the four sides of a view. Points have the coordinates of a view whose sides have slope 1: x and y
// are divided by the sides' slopes, and the third is the depth, so a point is in view where neither |x| nor |y|
// exceeds its depth. Float64, relative to the eye. One view and one object at a time: nothing is allocated in a
// frame.
import type { BufferAttribute, InterleavedBufferAttribute } from 'three';
import type { ShadingFrame } from '../material/lighting.js';
import type { BoxList } from './triangle-boxes.js';

/** A view, its sides at slopes ±`slopeX` and ±`slopeY` from its axis. */
export interface View {
  readonly frame: ShadingFrame;
  readonly slopeX: number;
  readonly slopeY: number;
  /** The orbit's. */
  readonly radius: number;
}

/**
 * A share of the orbit's radius: about 4 roundings of a float32 of its size. The GPU places vertices relative to the
 * target, so a face whose plane passes nearer to the eye than this cannot be told from one seen edge-on, which covers
 * no pixel.
 */
const EDGE_ON = 2 ** -22;

const axes = { x: [0, 0, 0], y: [0, 0, 0], depth: [0, 0, 0] };
const eye = [0, 0, 0];
const origin = [0, 0, 0];
let slopeX = 1;
let slopeY = 1;
/** How much a sphere's radius counts at the sides. */
let reachX = 1;
let reachY = 1;
let edgeOn = 0;

/** Everything below is about this view from now on. */
export function setView(view: View): void {
  const { right, up, back } = view.frame;
  ({ slopeX, slopeY } = view);
  for (const i of [0, 1, 2] as const) {
    axes.x[i] = right[i] / slopeX;
    axes.y[i] = up[i] / slopeY;
    axes.depth[i] = -back[i];
    eye[i] = view.frame.eye[i];
    origin[i] = view.frame.origin[i];
  }
  reachX = Math.hypot(1, 1 / slopeX);
  reachY = Math.hypot(1, 1 / slopeY);
  edgeOn = EDGE_ON * view.radius;
}

/** Where a coordinate's four coefficients begin, of x, y, z and 1 in the object's own space. */
export const X = 0;
export const Y = 4;
export const DEPTH = 8;
const rows = new Float64Array(12);

/** Points are below an object with this world matrix from now on. */
export function setObject(m: ArrayLike<number>): void {
  const dx = m[12]! - origin[0]! - eye[0]!;
  const dy = m[13]! - origin[1]! - eye[1]!;
  const dz = m[14]! - origin[2]! - eye[2]!;
  writeRow(X, axes.x, m, dx, dy, dz);
  writeRow(Y, axes.y, m, dx, dy, dz);
  writeRow(DEPTH, axes.depth, m, dx, dy, dz);
}

function writeRow(
  at: number,
  axis: readonly number[],
  m: ArrayLike<number>,
  dx: number,
  dy: number,
  dz: number,
): void {
  const x = axis[0]!;
  const y = axis[1]!;
  const z = axis[2]!;
  rows[at] = x * m[0]! + y * m[1]! + z * m[2]!;
  rows[at + 1] = x * m[4]! + y * m[5]! + z * m[6]!;
  rows[at + 2] = x * m[8]! + y * m[9]! + z * m[10]!;
  rows[at + 3] = x * dx + y * dy + z * dz;
}

/** A coordinate of a point in the object's own space. */
export const along = (row: number, x: number, y: number, z: number): number =>
  rows[row]! * x + rows[row + 1]! * y + rows[row + 2]! * z + rows[row + 3]!;

/**
 * Less than the depth of whatever a sphere has in view; Infinity where it is out of view. Its centre is in the
 * object's own space, its radius in world units.
 */
export function leastDepth(x: number, y: number, z: number, radius: number): number {
  const depth = along(DEPTH, x, y, z);
  if (Math.abs(along(X, x, y, z)) - depth > radius * reachX) return Infinity;
  if (Math.abs(along(Y, x, y, z)) - depth > radius * reachY) return Infinity;
  return depth - radius;
}

/** False only if a box of the object's own space has nothing in view before this depth. */
export function isInView(boxes: BoxList, at: number, before: number): boolean {
  const x = boxes[at]!;
  const y = boxes[at + 1]!;
  const z = boxes[at + 2]!;
  const depth = along(DEPTH, x, y, z);
  if (depth - extent(boxes, at, X, 0) >= before) return false;
  const across = along(X, x, y, z);
  const upward = along(Y, x, y, z);
  return !(
    across - depth > extent(boxes, at, X, -1) ||
    -across - depth > extent(boxes, at, X, 1) ||
    upward - depth > extent(boxes, at, Y, -1) ||
    -upward - depth > extent(boxes, at, Y, 1)
  );
}

/**
 * How much the depth plus `share` of another coordinate changes from a box's centre to a corner, and a little for
 * rounding.
 */
function extent(boxes: BoxList, at: number, other: number, share: number): number {
  let sum = 0;
  for (let i = 0; i < 3; i++)
    sum += Math.abs(rows[DEPTH + i]! + share * rows[other + i]!) * boxes[at + 3 + i]!;
  // Far more than float64 loses, 1e-16 of each product.
  return sum + 1e-12 * (sum + Math.abs(rows[DEPTH + 3]!) + Math.abs(rows[other + 3]!));
}

/** x, y and depth. */
export const STRIDE = 3;
/** The cut triangle: at most one corner more for each side of the view. */
export const polygon = new Float64Array(STRIDE * 8);
const cut = new Float64Array(STRIDE * 8);

/** Writes x, y and depth of the triangle's corner `k`, a vertex of the object. */
export function setCorner(
  k: number,
  position: BufferAttribute | InterleavedBufferAttribute,
  vertex: number,
): void {
  const x = position.getX(vertex);
  const y = position.getY(vertex);
  const z = position.getZ(vertex);
  polygon[STRIDE * k] = along(X, x, y, z);
  polygon[STRIDE * k + 1] = along(Y, x, y, z);
  polygon[STRIDE * k + 2] = along(DEPTH, x, y, z);
}

/**
 * Cuts the triangle (Sutherland and Hodgman). Returns the corners that are left; 0 where it is out of view or seen
 * edge-on.
 */
export function cutTriangle(): number {
  if (isEdgeOn()) return 0;
  let corners = 3;
  for (let side = 0; side < 4 && corners > 0; side++) corners = cutBy(side, corners);
  return corners;
}

/** The triangle's plane passes through the eye, as far as the GPU or float64 can tell. False for lines and points. */
function isEdgeOn(): boolean {
  const p = polygon;
  const ax = p[0]! * slopeX;
  const ay = p[1]! * slopeY;
  const az = p[2]!;
  const ux = p[STRIDE]! * slopeX - ax;
  const uy = p[STRIDE + 1]! * slopeY - ay;
  const uz = p[STRIDE + 2]! - az;
  const vx = p[2 * STRIDE]! * slopeX - ax;
  const vy = p[2 * STRIDE + 1]! * slopeY - ay;
  const vz = p[2 * STRIDE + 2]! - az;
  const nx = uy * vz - uz * vy;
  const ny = uz * vx - ux * vz;
  const nz = ux * vy - uy * vx;
  const length = Math.sqrt(nx * nx + ny * ny + nz * nz);
  const rounding = 4 * Number.EPSILON * (Math.abs(ax) + Math.abs(ay) + Math.abs(az));
  return length > 0 && Math.abs(nx * ax + ny * ay + nz * az) <= Math.max(edgeOn, rounding) * length;
}

function cutBy(side: number, corners: number): number {
  const axis = side >> 1;
  const sign = (side & 1) === 1 ? 1 : -1;
  let left = 0;
  for (let i = 0; i < corners; i++) {
    const next = i + 1 < corners ? i + 1 : 0;
    const here = polygon[STRIDE * i + 2]! + sign * polygon[STRIDE * i + axis]!;
    const there = polygon[STRIDE * next + 2]! + sign * polygon[STRIDE * next + axis]!;
    if (here >= 0) left = keep(left, i, i, 0);
    if (here >= 0 !== there >= 0) left = keep(left, i, next, here / (here - there));
  }
  polygon.set(cut);
  return left;
}

/** Adds the point that lies `share` of the way between two corners. */
function keep(left: number, from: number, to: number, share: number): number {
  for (let i = 0; i < STRIDE; i++) {
    const start = polygon[STRIDE * from + i]!;
    cut[STRIDE * left + i] = start + share * (polygon[STRIDE * to + i]! - start);
  }
  return left + 1;
}
