// What a shape's flat faces need to be shaded by the rays of their pixels instead of interpolated positions: which
// faces it has, when the eye is near them, and their planes as pixels see them.
import { type BufferGeometry, Matrix3, type Matrix4, Vector2, type Vector3, type Vector4 } from 'three';
import { dot, type Vec3 } from '../math/vector.js';
import { smoothGeometry } from './flat-geometry.js';

/** A flat face in its geometry's own space. */
export interface FlatFace {
  /** Anywhere in its plane. */
  readonly point: Vec3;
  /** Outside; of any length but 0. */
  readonly normal: Vec3;
}

const declared = new WeakMap<BufferGeometry, readonly FlatFace[]>();

/** Says that a geometry has these faces and no others. Their normals are nearest to one half axis each. */
export function declareFaces(geometry: BufferGeometry, faces: readonly FlatFace[]): void {
  declared.set(geometry, faces);
}

/** The faces of a geometry or its flat copy; undefined where they are not all flat. */
export const facesOf = (geometry: BufferGeometry): readonly FlatFace[] | undefined =>
  declared.get(smoothGeometry(geometry));

/** Normals along x, -x, y, -y, z and -z: a face's row is the one that its normal is nearest to. */
const ROWS = 6;

/**
 * An eye is near a mesh whose largest side is more than this many times its distance. Rasterisers interpolate positions
 * over a triangle with errors that grow with this ratio. In software no code in 400,000 is off by more than one at 4,
 * six are at 6, and 0.1 % at 32. An H200 is right to 1e5, but has no use for another limit: a still picture costs the
 * same either way.
 */
const NEAR = 4;

/** Least distance of the eye from a plane, which is then seen edge-on, by no pixel. Its inverse is a float32. */
const EDGE_ON = 1e-30;

/**
 * Whether the eye is near a mesh with these bounds: see {@link NEAR}. `model` leads to the space of the eye; its axes
 * are orthogonal, as rotation and scale leave them. `normals` is its normal matrix.
 */
export function isNear(geometry: BufferGeometry, model: Matrix4, normals: Matrix3, eye: Vector3): boolean {
  if (geometry.boundingBox === null) geometry.computeBoundingBox();
  const { min, max } = geometry.boundingBox!;
  const m = model.elements;
  const x = eye.x - m[12];
  const y = eye.y - m[13];
  const z = eye.z - m[14];
  let largest = 0;
  let outside = 0; // squared
  let inside = Infinity;
  for (let axis = 0; axis < 3; axis++) {
    const e = m[4 * axis]!;
    const f = m[4 * axis + 1]!;
    const g = m[4 * axis + 2]!;
    const length = Math.sqrt(e * e + f * f + g * g);
    const low = length * min.getComponent(axis);
    const high = length * max.getComponent(axis);
    // A flattened axis has no direction but the normal's.
    const along =
      length > 0 ? (x * e + y * f + z * g) / length : alongNormal(normals.elements, axis, x, y, z);
    const beyond = Math.max(low - along, along - high);
    largest = Math.max(largest, high - low);
    if (beyond > 0) outside += beyond * beyond;
    else inside = Math.min(inside, -beyond);
  }
  return largest > NEAR * (outside > 0 ? Math.sqrt(outside) : inside);
}

/** The length of x, y, z along a column of the normal matrix; 0 if that is zero. */
function alongNormal(n: readonly number[], axis: number, x: number, y: number, z: number): number {
  const a = n[3 * axis]!;
  const b = n[3 * axis + 1]!;
  const c = n[3 * axis + 2]!;
  const length = Math.sqrt(a * a + b * b + c * c);
  return length > 0 ? (x * a + y * b + z * c) / length : 0;
}

/** The uniforms of programs that place flat faces by rays; declared in phong.vert and phong.frag. */
export const faceUniforms = () => ({
  /** For each row of {@link ROWS} the plane as pointOnFace takes it; w: 1 where the eye sees the outside, else -1. */
  uFaces: { value: new Float32Array(4 * ROWS) },
  uRays: { value: new Matrix3() },
  uViewportCenter: { value: new Vector2() },
});

/** From where faces are seen, in shading space. */
export interface FaceView {
  readonly eye: Vector3;
  /** Shading space to view space. */
  readonly view: Matrix4;
  /** A perspective. */
  readonly projection: Matrix4;
  /** In pixels. */
  readonly viewport: Vector4;
}

/** Writes the uniforms for the faces of a mesh. `model` and its normal matrix lead to shading space. */
export function writeFaces(
  into: ReturnType<typeof faceUniforms>,
  faces: readonly FlatFace[],
  model: Matrix4,
  normals: Matrix3,
  { eye, view, projection, viewport }: FaceView,
): void {
  const { x, y, z: width, w: height } = viewport;
  into.uViewportCenter.value.set(x + width / 2, y + height / 2);
  const p = projection.elements;
  const v = view.elements;
  // What one pixel spans at depth 1, and where the ray of the viewport's center is there.
  const right = (-2 * p[11]) / (p[0] * width);
  const up = (-2 * p[11]) / (p[5] * height);
  const shiftX = p[8] / p[0];
  const shiftY = p[9] / p[5];
  const rays = into.uRays.value.elements;
  for (let i = 0; i < 3; i++) {
    const [vx, vy, vz] = [v[4 * i]!, v[4 * i + 1]!, v[4 * i + 2]!]; // view space's axes, by one axis of shading space
    rays[i] = right * vx;
    rays[3 + i] = up * vy;
    rays[6 + i] = shiftX * vx + shiftY * vy - vz;
  }
  for (const face of faces) writeFace(into.uFaces.value, face, model, normals, eye, rays);
}

function writeFace(
  into: Float32Array,
  { point, normal }: FlatFace,
  { elements: m }: Matrix4,
  { elements: n }: Matrix3,
  eye: Vector3,
  rays: readonly number[],
): void {
  const row = (i: 0 | 1 | 2): Vec3 => [n[i], n[3 + i]!, n[6 + i]!];
  const N: Vec3 = [dot(row(0), normal), dot(row(1), normal), dot(row(2), normal)];
  const size = Math.hypot(N[0], N[1], N[2]);
  const at = (i: 0 | 1 | 2): number =>
    m[i] * point[0] + m[4 + i]! * point[1] + m[8 + i]! * point[2] + m[12 + i]!;
  // In float64, because a floor may be a million times as large as the eye is high.
  const distance = dot(N, [at(0) - eye.x, at(1) - eye.y, at(2) - eye.z]) / size;
  const inFront = distance <= 0 ? -1 : 1;
  const inverse = inFront / Math.max(Math.abs(distance), EDGE_ON) / size;
  const first = 4 * rowOf(normal);
  for (let i = 0; i < 3; i++) {
    // Without an area it has no normal, and no pixels.
    into[first + i] = size > 0 ? inverse * dot(N, [rays[3 * i]!, rays[3 * i + 1]!, rays[3 * i + 2]!]) : 0;
  }
  into[first + 3] = -inFront;
}

/** As in phong.vert. */
function rowOf([x, y, z]: Vec3): number {
  const [a, b, c] = [Math.abs(x), Math.abs(y), Math.abs(z)];
  if (a > Math.max(b, c)) return x < 0 ? 1 : 0;
  if (b >= c) return y < 0 ? 3 : 2;
  return z < 0 ? 5 : 4;
}
