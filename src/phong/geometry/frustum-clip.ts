// Clips triangles by the four sides of a view frustum. Clip coordinates are x, y and w: w is the
// depth along the view, and a point is in view where neither |x| nor |y| exceeds it. Float64,
// relative to the eye.
import type { Sphere } from 'three';
import type { ShadingFrame } from '../material/shading-space.js';
import type { Vec3 } from '../math/vector.js';
import { stretch } from './bounds.js';
import type { Position } from './triangle-bvh.js';

/** What is in view: its sides have slopes ±`slopeX` and ±`slopeY` from its axis. */
export interface Frustum {
  readonly frame: ShadingFrame;
  readonly slopeX: number;
  readonly slopeY: number;
  /** The orbit's. */
  readonly radius: number;
}

/**
 * A share of the orbit's radius: about 4 roundings of a float32 of its size. A face whose plane
 * passes nearer to the eye cannot be told from one seen edge-on, which covers no pixel: the GPU
 * places vertices relative to the target.
 */
const EDGE_ON = 2 ** -22;

/** Three rows of a matrix: for each coordinate its coefficients of x, y, z and 1. */
export type ClipRows = Float64Array;

/** Writes the rows from an object's own space to clip coordinates x, y and w. */
export function writeModelViewProjection(
  { frame, slopeX, slopeY }: Omit<Frustum, 'radius'>,
  m: ArrayLike<number>,
  to: ClipRows,
): ClipRows {
  const { right, up, back } = frame;
  writeRow(frame, right, 1 / slopeX, m, to, 0);
  writeRow(frame, up, 1 / slopeY, m, to, 4);
  writeRow(frame, back, -1, m, to, 8);
  return to;
}

function writeRow(
  { origin, eye }: ShadingFrame,
  axis: Vec3,
  share: number,
  m: ArrayLike<number>,
  to: ClipRows,
  at: number,
) {
  const x = axis[0] * share;
  const y = axis[1] * share;
  const z = axis[2] * share;
  to[at] = x * m[0]! + y * m[1]! + z * m[2]!;
  to[at + 1] = x * m[4]! + y * m[5]! + z * m[6]!;
  to[at + 2] = x * m[8]! + y * m[9]! + z * m[10]!;
  const dx = m[12]! - origin[0] - eye[0];
  const dy = m[13]! - origin[1] - eye[1];
  const dz = m[14]! - origin[2] - eye[2];
  to[at + 3] = x * dx + y * dy + z * dz;
}

export const coordinate = (m: ClipRows, row: number, x: number, y: number, z: number): number =>
  m[row]! * x + m[row + 1]! * y + m[row + 2]! * z + m[row + 3]!;

export const depthOf = (m: ClipRows, x: number, y: number, z: number): number =>
  coordinate(m, 8, x, y, z);

/**
 * A lower bound of the depth of a sphere in view, at most `before`; `m`: world matrix of its
 * object.
 */
export function sphereDepth(
  { frame, slopeX, slopeY }: Frustum,
  m: readonly number[],
  { center: { x, y, z }, radius }: Sphere,
  before: number,
): number {
  const { origin, eye, right, up, back } = frame;
  const dx = m[0]! * x + m[4]! * y + m[8]! * z + (m[12]! - origin[0] - eye[0]);
  const dy = m[1]! * x + m[5]! * y + m[9]! * z + (m[13]! - origin[1] - eye[1]);
  const dz = m[2]! * x + m[6]! * y + m[10]! * z + (m[14]! - origin[2] - eye[2]);
  const depth = -(dx * back[0] + dy * back[1] + dz * back[2]);
  const reach = radius * stretch(m);
  if (depth - reach >= before) return before;
  const across = Math.abs(dx * right[0] + dy * right[1] + dz * right[2]);
  const upward = Math.abs(dx * up[0] + dy * up[1] + dz * up[2]);
  if (across - slopeX * depth > reach * Math.sqrt(1 + slopeX * slopeX)) return before;
  if (upward - slopeY * depth > reach * Math.sqrt(1 + slopeY * slopeY)) return before;
  return depth - reach;
}

/** x, y and w. */
const STRIDE = 3;
/** Clipping adds at most one corner for each side. */
const polygon = new Float64Array(STRIDE * 8);
const clipped = new Float64Array(STRIDE * 8);

/**
 * The least depth of a triangle's part in view if below `before`; else `before`, as for one seen
 * edge-on.
 */
export function triangleDepth(
  m: ClipRows,
  view: Frustum,
  position: Position,
  a: number,
  b: number,
  c: number,
  before: number,
): number {
  writeCorner(m, position, a, 0);
  writeCorner(m, position, b, STRIDE);
  writeCorner(m, position, c, 2 * STRIDE);
  if (polygon[2]! >= before && polygon[5]! >= before && polygon[8]! >= before) return before;
  if (isEdgeOn(view)) return before;
  // Sutherland and Hodgman.
  let corners = clip(polygon, 3, 0, -1, clipped);
  corners = clip(clipped, corners, 0, 1, polygon);
  corners = clip(polygon, corners, 1, -1, clipped);
  corners = clip(clipped, corners, 1, 1, polygon);
  let least = before;
  for (let i = 0; i < corners; i++) {
    const depth = polygon[STRIDE * i + 2]!;
    if (depth >= 0 && depth < least) {
      least = depth; // NaN, of a broken vertex, is not drawn either
    }
  }
  return least;
}

function writeCorner(m: ClipRows, position: Position, vertex: number, at: number) {
  const x = position.getX(vertex);
  const y = position.getY(vertex);
  const z = position.getZ(vertex);
  polygon[at] = coordinate(m, 0, x, y, z);
  polygon[at + 1] = coordinate(m, 4, x, y, z);
  polygon[at + 2] = coordinate(m, 8, x, y, z);
}

/**
 * The triangle's plane passes through the eye, as far as the GPU or float64 can tell. False for
 * lines and points.
 */
function isEdgeOn({ slopeX, slopeY, radius }: Frustum): boolean {
  const p = polygon;
  const ax = p[0]! * slopeX;
  const ay = p[1]! * slopeY;
  const az = p[2]!;
  const ux = p[3]! * slopeX - ax;
  const uy = p[4]! * slopeY - ay;
  const uz = p[5]! - az;
  const vx = p[6]! * slopeX - ax;
  const vy = p[7]! * slopeY - ay;
  const vz = p[8]! - az;
  const nx = uy * vz - uz * vy;
  const ny = uz * vx - ux * vz;
  const nz = ux * vy - uy * vx;
  const length = Math.sqrt(nx * nx + ny * ny + nz * nz);
  const rounding = 4 * Number.EPSILON * (Math.abs(ax) + Math.abs(ay) + Math.abs(az));
  const distance = Math.abs(nx * ax + ny * ay + nz * az);
  return length > 0 && distance <= Math.max(EDGE_ON * radius, rounding) * length;
}

/**
 * Clips by the side where w plus or minus coordinate `axis` is 0. Returns the number of corners
 * that are left.
 */
function clip(
  from: Float64Array,
  corners: number,
  axis: 0 | 1,
  sign: number,
  to: Float64Array,
): number {
  let left = 0;
  for (let i = 0; i < corners; i++) {
    const at = STRIDE * i;
    const next = i + 1 < corners ? at + STRIDE : 0;
    const here = from[at + 2]! + sign * from[at + axis]!;
    const there = from[next + 2]! + sign * from[next + axis]!;
    if (here >= 0) {
      left = keep(from, at, at, 0, to, left);
    }
    if (here >= 0 !== there >= 0) {
      left = keep(from, at, next, here / (here - there), to, left);
    }
  }
  return left;
}

/** Adds the point that lies `share` of the way between two corners. */
function keep(
  from: Float64Array,
  start: number,
  end: number,
  share: number,
  to: Float64Array,
  left: number,
): number {
  for (let i = 0; i < STRIDE; i++) {
    to[STRIDE * left + i] = from[start + i]! + share * (from[end + i]! - from[start + i]!);
  }
  return left + 1;
}
