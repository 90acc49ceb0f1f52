// The size of a scene: the centre of its box and its farthest vertex, in world space and float64, from the extreme
// points of its geometries: after the first time a moved mesh costs no pass over vertices.
import { type BufferGeometry, DynamicDrawUsage, type Mesh, type Object3D, type Sphere } from 'three';
import type { Vec3 } from '../math/vector.js';
import { type ExtremePoints, extremePointsOf, forgetExtremePoints } from '../model/extreme-points.js';

/** Centre of a scene's box, and its farthest vertex from any point; `empty` where it shows nothing. */
export interface Extent {
  readonly empty: boolean;
  readonly center: Vec3;
  /** Distance of the farthest vertex from a point. */
  radiusAbout(point: Vec3): number;
  /** A geometry under this world matrix reaches neither the box nor so far from its centre. */
  holds(geometry: BufferGeometry, matrix: readonly number[], farthest: number): boolean;
}

const NO_EXTENT: Extent = { empty: true, center: [0, 0, 0], radiusAbout: () => 0, holds: () => false };

/** A measured mesh under its present matrix. */
interface Placed {
  readonly extremes: ExtremePoints;
  readonly matrix: readonly number[];
}

interface WorldSphere {
  readonly center: Vec3;
  readonly radius: number;
}

/** World sphere that holds all of a mesh. */
const sphereOf = ({ extremes: { center, radius }, matrix }: Placed): WorldSphere => ({
  center: transformed(matrix, ...center),
  radius: radius * stretch(matrix),
});

/** Relative. Equal meshes side by side reach equally far up to rounding, and one of them is enough. */
const SAME = 1e-9;

/** Measures every visible mesh below `root`. World matrices must be up to date. */
export function measure(root: Object3D): Extent {
  const meshes = placedMeshes(root);
  if (meshes.length === 0) return NO_EXTENT;
  const low: [number, number, number] = [Infinity, Infinity, Infinity];
  const high: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  const extend = (places: Float64Array, count: number): void => {
    for (let i = 0; i < count; i++) {
      const place = places[i]!;
      const axis = (i % 3) as 0 | 1 | 2;
      if (place < low[axis]) low[axis] = place;
      if (place > high[axis]) high[axis] = place;
    }
  };
  /** `share` of a sphere is inside the box. */
  const inside = ({ center, radius }: WorldSphere, share: number): boolean => {
    const r = share * radius;
    for (const i of [0, 1, 2] as const) if (center[i] - r < low[i] || center[i] + r > high[i]) return false;
    return true;
  };
  // Boxes, and one point of each turned mesh, first: then most of these are found to lie inside by their spheres.
  const turned: Placed[] = [];
  for (const mesh of meshes) {
    const { extremes, matrix } = mesh;
    if (!isTurned(matrix)) extend(placesOf(extremes.box, 6, matrix), 6);
    else {
      turned.push(mesh);
      extend(placesOf(extremes.points, 3, matrix), 3);
    }
  }
  for (const mesh of turned) {
    const { points } = mesh.extremes;
    if (!inside(sphereOf(mesh), 1 - SAME))
      extend(placesOf(points, points.length, mesh.matrix), points.length);
  }
  const middle = (i: 0 | 1 | 2): number => low[i] + (high[i] - low[i]) / 2;
  const center: Vec3 = [middle(0), middle(1), middle(2)];
  return {
    empty: false,
    center,
    radiusAbout: (point) => farthestFrom(point, meshes),
    holds(geometry, matrix, farthest) {
      const extremes = extremesOf(geometry);
      if (extremes === null) return false;
      const sphere = sphereOf({ extremes, matrix });
      const fromCenter = distance(center, ...sphere.center) + sphere.radius;
      return inside(sphere, 1 + SAME) && fromCenter < (1 - SAME) * farthest;
    },
  };
}

/**
 * Radius of a sphere about `point` that holds everything visible below `root`: meshes, points, lines and sprites. At
 * least as large as needed. World matrices must be up to date. Costs one step per object.
 */
export function radiusOf(root: Object3D, point: Vec3): number {
  if (!root.visible) return 0;
  let radius = boundsOf(root, ball) ? reachOf(root.matrixWorld.elements, ball, point) : 0;
  for (const child of root.children) {
    const other = radiusOf(child, point);
    if (other > radius) radius = other;
  }
  return radius;
}

/** A sphere in an object's own space. */
export interface Ball {
  x: number;
  y: number;
  z: number;
  radius: number;
}

export const newBall = (): Ball => ({ x: 0, y: 0, z: 0, radius: 0 });

/** Used within one call of {@link radiusOf}. */
const ball = newBall();

/** Writes a sphere that holds an object's own vertices, where they are now. False where it has none. */
export function boundsOf(object: Object3D, into: Ball): boolean {
  const { geometry, boundingSphere } = object as Partial<Mesh> & { boundingSphere?: Sphere | null };
  // Instanced, skinned and batched meshes know where their parts are.
  if (boundingSphere !== undefined) return writeBall(into, boundingSphere ?? ownSphere(object));
  if (geometry === undefined) return false;
  const moving = movingBounds(geometry);
  if (moving !== null) return writeBall(into, moving);
  const extremes = extremesOf(geometry);
  if (extremes === null) return false;
  const { center, radius } = extremes;
  into.x = center[0];
  into.y = center[1];
  into.z = center[2];
  into.radius = radius;
  return true;
}

/** False for an empty sphere. */
export function writeBall(into: Ball, { center, radius }: Sphere): boolean {
  into.x = center.x;
  into.y = center.y;
  into.z = center.z;
  into.radius = radius;
  return radius >= 0;
}

/** The vertices of what is below `root` may have changed: reads them again when they are next needed. */
export function forgetBounds(root: Object3D): void {
  root.traverse((object) => {
    const { geometry } = object as Partial<Mesh>;
    const measured = object as { boundingBox?: unknown; boundingSphere?: unknown };
    if (measured.boundingBox !== undefined) measured.boundingBox = null;
    if (measured.boundingSphere !== undefined) measured.boundingSphere = null;
    // A shape's own bounds hold whatever its segments: on a new page, and in viewers that share the geometry.
    if (geometry === undefined || forgetExtremePoints(geometry)) return;
    // three.js culls by the one, lights are culled by the other.
    geometry.boundingSphere = null;
    geometry.boundingBox = null;
  });
}

function placedMeshes(root: Object3D): Placed[] {
  const placed: Placed[] = [];
  root.traverseVisible((object) => {
    // By its mark, not its class: another copy of three.js may have made it.
    const { isMesh, geometry } = object as Partial<Mesh>;
    const extremes = isMesh === true && geometry !== undefined ? extremesOf(geometry) : null;
    if (extremes === null) return;
    placed.push({ extremes, matrix: object.matrixWorld.elements });
  });
  return placed;
}

/** The vertices change from frame to frame, as an animation's do. */
export const hasMovingVertices = ({ attributes }: BufferGeometry): boolean =>
  (attributes['position'] as { usage?: number } | undefined)?.usage === DynamicDrawUsage;

/** Extreme points are those of the first pose, so that framing keeps still; these are those of the last one. */
const movingBounds = (geometry: BufferGeometry): Sphere | null =>
  hasMovingVertices(geometry) ? geometry.boundingSphere : null;

const extremesOf = (geometry: BufferGeometry): ExtremePoints | null =>
  'position' in geometry.attributes ? extremePointsOf(geometry) : null;

function farthestFrom(point: Vec3, meshes: readonly Placed[]): number {
  let farthest = 0;
  for (const mesh of meshes) {
    const { extremes, matrix } = mesh;
    const { center, radius } = sphereOf(mesh);
    const away = distance(point, ...center);
    const reach = away + radius;
    if (reach <= farthest * (1 + SAME)) continue;
    if (away <= SAME * radius && isEvenlyScaled(matrix)) {
      farthest = reach;
      continue;
    }
    const { length } = extremes.points;
    const places = placesOf(extremes.points, length, matrix);
    for (let i = 0; i < length; i += 3)
      farthest = Math.max(farthest, distance(point, places[i]!, places[i + 1]!, places[i + 2]!));
  }
  return farthest;
}

let scratch = new Float64Array(0);

/** The first `count` coordinates of points, in world space; overwritten by the next call. */
function placesOf(points: ArrayLike<number>, count: number, m: readonly number[]): Float64Array {
  if (scratch.length < count) scratch = new Float64Array(count);
  for (let i = 0; i < count; i += 3) {
    const [x, y, z] = [points[i]!, points[i + 1]!, points[i + 2]!];
    scratch[i] = m[0]! * x + m[4]! * y + m[8]! * z + m[12]!;
    scratch[i + 1] = m[1]! * x + m[5]! * y + m[9]! * z + m[13]!;
    scratch[i + 2] = m[2]! * x + m[6]! * y + m[10]! * z + m[14]!;
  }
  return scratch;
}

const transformed = (m: readonly number[], x: number, y: number, z: number): [number, number, number] => [
  m[0]! * x + m[4]! * y + m[8]! * z + m[12]!,
  m[1]! * x + m[5]! * y + m[9]! * z + m[13]!,
  m[2]! * x + m[6]! * y + m[10]! * z + m[14]!,
];

/** The mesh's axes are not the world's. */
const isTurned = (m: readonly number[]): boolean =>
  m[1] !== 0 || m[2] !== 0 || m[4] !== 0 || m[6] !== 0 || m[8] !== 0 || m[9] !== 0;

/** Neither turned nor stretched: distances from the mesh's own centre keep their order. */
const isEvenlyScaled = (m: readonly number[]): boolean =>
  !isTurned(m) && Math.abs(m[0]!) === Math.abs(m[5]!) && Math.abs(m[5]!) === Math.abs(m[10]!);

/** Coordinates are below 1e30, so that their squares are finite. */
const distance = ([px, py, pz]: Vec3, x: number, y: number, z: number): number =>
  Math.sqrt((x - px) ** 2 + (y - py) ** 2 + (z - pz) ** 2);

/**
 * Upper bound of the factor by which a matrix lengthens vectors: the square root of the largest row sum of MᵀM, which
 * is no less than its largest eigenvalue, and equal to it where the matrix does not shear.
 */
export function stretch(m: readonly number[]): number {
  const along = (i: number, j: number): number =>
    Math.abs(m[i]! * m[j]! + m[i + 1]! * m[j + 1]! + m[i + 2]! * m[j + 2]!);
  const xy = along(0, 4);
  const xz = along(0, 8);
  const yz = along(4, 8);
  return Math.sqrt(Math.max(along(0, 0) + xy + xz, along(4, 4) + xy + yz, along(8, 8) + xz + yz));
}

function reachOf(m: readonly number[], { x, y, z, radius }: Ball, point: Vec3): number {
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
