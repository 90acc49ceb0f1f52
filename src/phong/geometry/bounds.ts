// The size of a scene: the centre of its box and its farthest vertex, in world space and float64.
import { type BufferGeometry, type Mesh, type Object3D, Sphere } from 'three';
import type { Bounds } from '../camera/fit.js';
import type { MutableVec3 } from '../camera/orbit.js';
import { transformed, type Vec3 } from '../math/vector.js';
import { forgetSize, type GeometrySize, hasMovingVertices, sizeOf } from './geometry-size.js';

export interface Extent {
  /**
   * Centre of the scene's box, and the distance of the farthest vertex from it; null where it shows
   * nothing.
   */
  readonly bounds: Bounds | null;
  /** Distance of the farthest vertex from a point. */
  radiusAbout(point: Vec3): number;
  /**
   * Measures again what is below `object`, whose place has changed, and updates its world matrices.
   * One of 10,000 meshes takes a quarter of the time of all.
   */
  moved(object: Object3D): void;
}

/** A mesh, and the sphere in world space that holds it. */
interface Placed {
  size: GeometrySize;
  readonly matrix: readonly number[];
  x: number;
  y: number;
  z: number;
  radius: number;
}

const PLACED = /* @__PURE__ */ Symbol('placed');

/** Kept at the mesh: a map takes 2 ms to fill with 10,000. */
type PlacedMesh = Object3D & { [PLACED]?: Placed };

const AXES = [0, 1, 2] as const;

/**
 * Relative. Equal meshes side by side reach equally far up to rounding, and one of them is enough.
 */
const SAME = 1e-9;

/** Measures every visible mesh below `root`. World matrices must be up to date. */
export function measure(root: Object3D): Extent {
  const meshes = placedMeshes(root);
  let bounds: Bounds | null = null;
  return {
    get bounds() {
      return (bounds ??= boundsAround(meshes));
    },
    radiusAbout: (point) => farthestFrom(point, meshes),
    moved(object) {
      bounds = null;
      object.updateWorldMatrix(true, true);
      placedMeshes(object);
    },
  };
}

function boundsAround(meshes: readonly Placed[]): Bounds | null {
  if (meshes.length === 0) return null;
  const low: MutableVec3 = [Infinity, Infinity, Infinity];
  const high: MutableVec3 = [-Infinity, -Infinity, -Infinity];
  // Plain steps, here and below: lists for three numbers took twice the time for 10,000 meshes.
  const isInside = ({ x, y, z, radius }: Placed): boolean => {
    const r = (1 - SAME) * radius;
    return (
      x - r >= low[0] &&
      y - r >= low[1] &&
      z - r >= low[2] &&
      x + r <= high[0] &&
      y + r <= high[1] &&
      z + r <= high[2]
    );
  };
  // Boxes first: then most turned meshes are found to lie inside by their spheres.
  const turned: Placed[] = [];
  for (const mesh of meshes) {
    if (isInside(mesh)) continue;
    if (isTurned(mesh.matrix)) {
      turned.push(mesh);
    } else {
      extend(low, high, mesh.size.box, mesh.matrix);
    }
  }
  for (const mesh of turned) {
    if (!isInside(mesh)) {
      extend(low, high, mesh.size.vertices(), mesh.matrix);
    }
  }
  const middle = (i: 0 | 1 | 2) => low[i] + (high[i] - low[i]) / 2;
  const center: Vec3 = [middle(0), middle(1), middle(2)];
  return { center, radius: farthestFrom(center, meshes) };
}

/**
 * Radius of a sphere about `point` that holds everything visible below `root`: meshes, points,
 * lines and sprites. At least as large as needed. World matrices must be up to date. Costs one step
 * per object.
 */
export function radiusOf(root: Object3D, point: Vec3): number {
  if (!root.visible) return 0;
  let radius = boundsOf(root, ball) ? reachOf(root.matrixWorld.elements, ball, point) : 0;
  for (const child of root.children) {
    const other = radiusOf(child, point);
    if (other > radius) {
      radius = other;
    }
  }
  return radius;
}

/** Used within one call of {@link radiusOf}. */
const ball = /* @__PURE__ */ new Sphere();

/**
 * Writes a sphere that holds an object's own vertices, where they are now. False where it has none.
 */
export function boundsOf(object: Object3D, into: Sphere): boolean {
  const { geometry, boundingSphere } = object as Partial<Mesh> & { boundingSphere?: Sphere | null };
  // Instanced, skinned and batched meshes know where their parts are.
  if (boundingSphere !== undefined) return isFilled(into.copy(boundingSphere ?? ownSphere(object)));
  if (geometry === undefined) return false;
  const moving = movingBounds(geometry);
  if (moving !== null) return isFilled(into.copy(moving));
  const size = measuredOf(geometry);
  if (size === null) return false;
  const { center, radius } = size;
  into.center.set(center[0], center[1], center[2]);
  into.radius = radius;
  return true;
}

/** Not so where there is no vertex, or only NaN. */
const isFilled = ({ radius }: Sphere): boolean => radius >= 0;

/**
 * The vertices of what is below `root` may have changed: reads them again when they are next
 * needed.
 */
export function forgetBounds(root: Object3D): void {
  root.traverse((object) => {
    const { geometry } = object as Partial<Mesh>;
    const measured = object as { boundingBox?: unknown; boundingSphere?: unknown };
    if (measured.boundingBox !== undefined) {
      measured.boundingBox = null;
    }
    if (measured.boundingSphere !== undefined) {
      measured.boundingSphere = null;
    }
    // A shape's own bounds hold whatever its segments: on a new page, and in viewers that share the
    // geometry.
    if (geometry === undefined || forgetSize(geometry)) return;
    // three.js culls by the one, lights are culled by the other.
    geometry.boundingSphere = null;
    geometry.boundingBox = null;
  });
}

/** Writes where the meshes below `object` are now. */
function placedMeshes(object: PlacedMesh, placed: Placed[] = []): Placed[] {
  if (!object.visible) return placed;
  // By its mark, not its class: another copy of three.js may have made it.
  const { isMesh, geometry } = object as Partial<Mesh>;
  const reach = reaches.get(object);
  const size = reach ?? (isMesh === true && geometry !== undefined ? measuredOf(geometry) : null);
  if (size !== null) {
    const { elements: matrix } = object.matrixWorld;
    const mesh = (object[PLACED] ??= { x: 0, y: 0, z: 0, radius: 0, size, matrix });
    mesh.size = size;
    [mesh.x, mesh.y, mesh.z] = transformed(matrix, ...size.center);
    mesh.radius = size.radius * stretch(matrix);
    placed.push(mesh);
  }
  if (reach === undefined) {
    for (const child of object.children) {
      placedMeshes(child, placed);
    }
  }
  return placed;
}

const reaches = new WeakMap<Object3D, GeometrySize>();

/**
 * Frames what is below `object` by this size, in its own space, whatever pose it is in; null, the
 * default: by the vertices that are there.
 */
export function declareReach(object: Object3D, size: GeometrySize | null): void {
  if (size === null) {
    reaches.delete(object);
  } else {
    reaches.set(object, size);
  }
}

/**
 * A geometry's size is that of the first pose, so that framing keeps still; these are those of the
 * last one.
 */
const movingBounds = (geometry: BufferGeometry): Sphere | null =>
  hasMovingVertices(geometry) ? geometry.boundingSphere : null;

const measuredOf = (geometry: BufferGeometry): GeometrySize | null =>
  'position' in geometry.attributes ? sizeOf(geometry) : null;

/** Makes a box as large as to hold places, given as x, y, z one after the other, under a matrix. */
function extend(
  low: MutableVec3,
  high: MutableVec3,
  places: ArrayLike<number>,
  m: readonly number[],
) {
  for (const axis of AXES) {
    const a = m[axis]!;
    const b = m[axis + 4]!;
    const c = m[axis + 8]!;
    const d = m[axis + 12]!;
    for (let i = 0; i < places.length; i += 3) {
      const at = a * places[i]! + b * places[i + 1]! + c * places[i + 2]! + d;
      if (at < low[axis]) {
        low[axis] = at;
      }
      if (at > high[axis]) {
        high[axis] = at;
      }
    }
  }
}

function farthestFrom(point: Vec3, meshes: readonly Placed[]): number {
  let farthest = 0;
  for (const { size, matrix, x, y, z, radius } of meshes) {
    const away = distance(point, x, y, z);
    const reach = away + radius;
    if (reach <= farthest * (1 + SAME)) continue;
    if (away <= SAME * radius && isEvenlyScaled(matrix)) {
      farthest = reach;
      continue;
    }
    const vertices = size.vertices();
    for (let i = 0; i < vertices.length; i += 3) {
      const place = transformed(matrix, vertices[i]!, vertices[i + 1]!, vertices[i + 2]!);
      farthest = Math.max(farthest, distance(point, ...place));
    }
  }
  return farthest;
}

/** The mesh's axes are not the world's. */
const isTurned = (m: readonly number[]) =>
  m[1] !== 0 || m[2] !== 0 || m[4] !== 0 || m[6] !== 0 || m[8] !== 0 || m[9] !== 0;

/** Neither turned nor stretched: distances from the mesh's own centre keep their order. */
const isEvenlyScaled = (m: readonly number[]) =>
  !isTurned(m) && Math.abs(m[0]!) === Math.abs(m[5]!) && Math.abs(m[5]!) === Math.abs(m[10]!);

/** Coordinates are below 1e30, so that their squares are finite. */
function distance(point: Vec3, x: number, y: number, z: number): number {
  const dx = x - point[0];
  const dy = y - point[1];
  const dz = z - point[2];
  return Math.sqrt(dx * dx + dy * dy + dz * dz);
}

/**
 * Upper bound of the factor by which a matrix lengthens vectors: the square root of the largest row
 * sum of MᵀM, which is no less than its largest eigenvalue, and equal to it where the matrix does
 * not shear.
 */
export function stretch(m: readonly number[]): number {
  const along = (i: number, j: number) =>
    Math.abs(m[i]! * m[j]! + m[i + 1]! * m[j + 1]! + m[i + 2]! * m[j + 2]!);
  const xy = along(0, 4);
  const xz = along(0, 8);
  const yz = along(4, 8);
  return Math.sqrt(Math.max(along(0, 0) + xy + xz, along(4, 4) + xy + yz, along(8, 8) + xz + yz));
}

function reachOf(m: readonly number[], { center, radius }: Sphere, point: Vec3): number {
  const { x, y, z } = center;
  // For every object in every frame: no list for the place.
  const dx = m[0]! * x + m[4]! * y + m[8]! * z + m[12]! - point[0];
  const dy = m[1]! * x + m[5]! * y + m[9]! * z + m[13]! - point[1];
  const dz = m[2]! * x + m[6]! * y + m[10]! * z + m[14]! - point[2];
  const reach = Math.sqrt(dx * dx + dy * dy + dz * dz) + radius * stretch(m);
  return Number.isFinite(reach) ? reach : 0;
}

function ownSphere(object: Object3D): Sphere {
  const measured = object as unknown as { computeBoundingSphere(): void; boundingSphere: Sphere };
  measured.computeBoundingSphere();
  return measured.boundingSphere;
}
