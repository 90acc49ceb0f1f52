// How large a geometry is: the box around its vertices, and the sphere around the box's centre.
import {
  Box3,
  BufferAttribute,
  type BufferGeometry,
  DynamicDrawUsage,
  type InterleavedBufferAttribute,
  Sphere,
  StaticDrawUsage,
  Vector3,
} from 'three';
import type { Vec3 } from '../math/vector.js';

/** x, y, z of each vertex, one after the other. */
export type Vertices = Float32Array | Float64Array;

type Box = readonly [
  minX: number,
  minY: number,
  minZ: number,
  maxX: number,
  maxY: number,
  maxZ: number,
];

export interface GeometrySize {
  readonly box: Box;
  /** The center of the box. */
  readonly center: Vec3;
  /** Reaches the vertex farthest from `center`. */
  readonly radius: number;
  /** All that are finite: turned meshes are measured by them. */
  readonly vertices: () => Vertices;
}

interface Measured {
  readonly size: GeometrySize | null;
  /** The version of the vertices that a declared size is for; null for a measured one. */
  readonly declaredFor: number | null;
}

const sizes = new WeakMap<BufferGeometry, Measured>();

/**
 * Null where the geometry has no vertex. Measured with the first call, and kept until {@link
 * forgetSize}.
 */
export const sizeOf = (geometry: BufferGeometry): GeometrySize | null => ended(measuring(geometry));

/** Null for no vertices. They must be finite. */
export const sizeOfVertices = (vertices: Vertices): GeometrySize | null =>
  ended(sizeAround(vertices));

/** The result of all steps at once. */
export function ended<T>(steps: Steps<T>): T {
  for (;;) {
    const { done, value } = steps.next();
    if (done === true) return value;
  }
}

/** The vertices change from frame to frame, as an animation's do. */
export const hasMovingVertices = ({ attributes }: BufferGeometry): boolean =>
  (attributes['position'] as { usage?: number } | undefined)?.usage === DynamicDrawUsage;

/** Lets other tasks run when a task has taken long enough. */
interface Pauses {
  readonly due: boolean;
  pause(): Promise<void>;
}

export async function measureInSlices(geometry: BufferGeometry, slices: Pauses): Promise<void> {
  const steps = measuring(geometry);
  while (steps.next().done === false) {
    if (slices.due) {
      await slices.pause();
    }
  }
}

/** Replaces the measured size of a geometry, until its vertices are written to. */
export function declareSize(geometry: BufferGeometry, size: GeometrySize): void {
  sizes.set(geometry, { size, declaredFor: versionOf(geometry) });
}

const versionOf = (geometry: BufferGeometry) =>
  (geometry.getAttribute('position') as Partial<BufferAttribute>).version ?? 0;

/** `copy` has the vertices of `geometry`: it is not read for itself. */
export function shareSize(geometry: BufferGeometry, copy: BufferGeometry): void {
  const size = sizeOf(geometry);
  const isDeclared = sizes.get(geometry)?.declaredFor === versionOf(geometry);
  sizes.set(copy, { size, declaredFor: isDeclared ? versionOf(copy) : null });
}

/** The vertices may have changed. Whether they have not, because the declared size still holds. */
export function forgetSize(geometry: BufferGeometry): boolean {
  const holds = sizes.get(geometry)?.declaredFor === versionOf(geometry);
  if (!holds) {
    sizes.delete(geometry);
  }
  return holds;
}

/** A computation in steps of about a millisecond. */
export type Steps<T> = Generator<undefined, T, undefined>;

/** Numbers of vertices between two steps. */
const PIECE = 3 * 2 ** 18;

function* measuring(geometry: BufferGeometry): Steps<GeometrySize | null> {
  const found = sizes.get(geometry) ?? { size: yield* measured(geometry), declaredFor: null };
  sizes.set(geometry, found);
  return found.size;
}

function* measured(geometry: BufferGeometry): Steps<GeometrySize | null> {
  const position = geometry.getAttribute('position');
  const plain =
    position instanceof BufferAttribute &&
    position.itemSize === 3 &&
    position.array instanceof Float32Array;
  // Most geometries have only finite numbers, and are read without a copy. Animations write to
  // theirs, and are framed by the first pose.
  const isStill = plain && position.usage === StaticDrawUsage;
  const array = position.array as Float32Array;
  const found = plain ? yield* sizeAround(isStill ? array : array.slice()) : null;
  if (found === null || !Number.isFinite(found.radius)) {
    return yield* sizeAround(finiteVertices(position));
  }
  // three.js would find the same numbers for its own culling, in a pass over all vertices for each.
  if (isStill && geometry.morphAttributes['position'] === undefined) {
    geometry.boundingBox ??= new Box3().setFromArray(found.box);
    geometry.boundingSphere ??= new Sphere(new Vector3(...found.center), found.radius);
  }
  return found;
}

function* sizeAround(vertices: Vertices): Steps<GeometrySize | null> {
  const around = new Box3();
  const piece = new Box3();
  for (let from = 0; from < vertices.length; from += PIECE) {
    around.union(piece.setFromArray(vertices.subarray(from, from + PIECE)));
    yield;
  }
  const [minX, minY, minZ] = around.min.toArray();
  const [maxX, maxY, maxZ] = around.max.toArray();
  if (!(minX <= maxX)) return null;
  const center: Vec3 = [
    minX + (maxX - minX) / 2,
    minY + (maxY - minY) / 2,
    minZ + (maxZ - minZ) / 2,
  ];
  let farthest = 0;
  for (let i = 0; i < vertices.length; i += 3) {
    if (i % PIECE === 0) {
      yield;
    }
    const dx = vertices[i]! - center[0];
    const dy = vertices[i + 1]! - center[1];
    const dz = vertices[i + 2]! - center[2];
    farthest = Math.max(farthest, dx * dx + dy * dy + dz * dz);
  }
  const box: Box = [minX, minY, minZ, maxX, maxY, maxZ];
  return { box, center, radius: Math.sqrt(farthest), vertices: () => vertices };
}

function finiteVertices(position: BufferAttribute | InterleavedBufferAttribute): Vertices {
  const vertices = new Float64Array(3 * position.count);
  let end = 0;
  for (let i = 0; i < position.count; i++) {
    const [x, y, z] = [position.getX(i), position.getY(i), position.getZ(i)];
    if (!Number.isFinite(x + y + z)) continue;
    vertices[end++] = x;
    vertices[end++] = y;
    vertices[end++] = z;
  }
  return vertices.subarray(0, end);
}
