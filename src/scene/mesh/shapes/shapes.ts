// The geometries of named shapes. Every shape is centred on the origin, in its mesh's own units. Meshes with the same
// shape and segments share one BufferGeometry; users are counted, and the last one frees it.
import { BoxGeometry, type BufferGeometry, PlaneGeometry, SphereGeometry } from 'three';
import { declareFaces } from '../../../material/flat-faces.js';
import { scale, type Vec3 } from '../../../math/vector.js';
import { lazyCode } from '../../../model/lazy-code.js';
import { VALUES_PER_TRIANGLE } from '../../../model/limits.js';
import type { Need } from '../triangle-budget.js';
import type { SOLIDS } from './solids.js';

/** The names that the `geometry` attribute takes, in the order in which menus show them. */
export const GEOMETRIES = [
  'box',
  'sphere',
  'cylinder',
  'cone',
  'pyramid',
  'torus',
  'torus-knot',
  'teapot',
  'plane',
] as const;

export type GeometryName = (typeof GEOMETRIES)[number];

/**
 * Shapes without holes: each edge has exactly two triangles, so their inside cannot be seen from outside. Not the
 * teapot: its spout is open, and its parts end inside each other.
 */
export const CLOSED: ReadonlySet<GeometryName> = new Set(
  GEOMETRIES.filter((name) => name !== 'plane' && name !== 'teapot'),
);

/** A geometry, or a promise where the shape's code is a chunk of its own. */
export type PendingGeometry = BufferGeometry | Promise<BufferGeometry>;

interface Shape {
  /** Default number of segments. */
  readonly segments: number;
  /** Fewest segments that still enclose the shape; smaller requests are raised to it. */
  readonly least: number;
  readonly create: (segments: number) => PendingGeometry;
  /** Number of triangles, at least the true one, before anything is built. */
  readonly triangles: (segments: number) => number;
}

const solidsCode = /* @__PURE__ */ lazyCode(() => import('./solids.js'), 'the solid shapes');
const teapotCode = /* @__PURE__ */ lazyCode(() => import('./teapot.js'), 'the teapot');

const solid =
  (name: keyof typeof SOLIDS): Shape['create'] =>
  async (n) =>
    (await solidsCode()).SOLIDS[name](n);

/** Segments across the main ones, half as many. */
const rowsOf = (segments: number, least: number): number => Math.max(least, Math.round(segments / 2));

const BOX_NORMALS: readonly Vec3[] = [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]; // prettier-ignore

/** Declares the faces with these unit normals, all at one distance from the origin. */
function flatFaced(geometry: BufferGeometry, normals: readonly Vec3[], distance: number): BufferGeometry {
  declareFaces(
    geometry,
    normals.map((normal) => ({ point: scale(normal, distance), normal })),
  );
  return geometry;
}

/** `segments` counts along a side for the flat shapes (box, pyramid, plane), once round the axis for the others. */
const SHAPES: Readonly<Record<GeometryName, Shape>> = {
  box: {
    segments: 1,
    least: 1,
    create: (n) => flatFaced(new BoxGeometry(1, 1, 1, n, n, n), BOX_NORMALS, 0.5),
    triangles: (n) => 12 * n * n,
  },
  sphere: {
    segments: 64,
    least: 3,
    create: (n) => new SphereGeometry(0.5, n, rowsOf(n, 2)),
    triangles: (n) => 2 * n * (rowsOf(n, 2) - 1),
  },
  cylinder: { segments: 64, least: 3, create: solid('cylinder'), triangles: (n) => 4 * n },
  cone: { segments: 64, least: 3, create: solid('cone'), triangles: (n) => 2 * n },
  pyramid: { segments: 1, least: 1, create: solid('pyramid'), triangles: (n) => 6 * n * n },
  torus: { segments: 64, least: 3, create: solid('torus'), triangles: (n) => 2 * n * rowsOf(n, 3) },
  'torus-knot': {
    segments: 256,
    // Below this the tube's sections cut through each other, and triangles turn against their normals.
    least: 32,
    create: async (n) => fitToUnitBox(await solid('torus-knot')(n)),
    triangles: (n) => 2 * n * Math.min(64, Math.max(8, Math.round(n / 8))),
  },
  teapot: {
    segments: 64,
    // Below this two triangles of the spout turn against their normals.
    least: 12,
    create: async (n) => fitToUnitBox((await teapotCode()).teapotGeometry(n)),
    // 32 patches of four to a turn. Those at the poles have some triangles less.
    triangles: (n) => 32 * 2 * Math.round(n / 4) ** 2,
  },
  plane: {
    segments: 1,
    least: 1,
    create: (n) => flatFaced(new PlaneGeometry(1, 1, n, n).rotateX(-Math.PI / 2), [[0, 1, 0]], 0),
    triangles: (n) => 2 * n * n,
  },
};

/** The segments that a shape is made with. `undefined` means the shape's default. */
export function effectiveSegments(name: GeometryName, segments: number | undefined): number {
  const shape = SHAPES[name];
  return Math.max(shape.least, Math.round(segments ?? shape.segments));
}

/**
 * What a shape will hold, and its flat copy, before they are built. A coarser level that keeps a viewer within its
 * limit is to be chosen by these numbers.
 */
export function shapeNeeds(name: GeometryName, segments: number | undefined, flat: boolean): Need[] {
  const key = keyOf(name, segments);
  const triangles = SHAPES[name].triangles(effectiveSegments(name, segments));
  const smooth = { key, triangles, flat: false };
  // Each corner has 8 values: position, normal, uv.
  const copy = Math.ceil((triangles * 3 * 8) / VALUES_PER_TRIANGLE);
  return flat ? [smooth, { key: `flat ${key}`, triangles: copy, flat: true }] : [smooth];
}

/**
 * A new geometry, owned by the caller: indexed, with `position`, `normal` (unit length to float32) and `uv`.
 * @param segments 1 to 512; raised to what the shape needs. `undefined` takes the shape's default.
 */
export function createGeometry(name: GeometryName, segments: number | undefined): PendingGeometry {
  return SHAPES[name].create(effectiveSegments(name, segments));
}

interface Shared {
  readonly geometry: PendingGeometry;
  users: number;
}

const shared = new Map<string, Shared>();

const keyOf = (name: GeometryName, segments: number | undefined): string =>
  `${name} ${String(effectiveSegments(name, segments))}`;

/**
 * As {@link createGeometry}, but shared: the same name and segments give the same geometry. Each call needs one
 * {@link releaseGeometry} with the same arguments, whether or not a promise has settled by then; only this cache
 * disposes of the geometry. A rejected promise (a chunk that could not be fetched) needs no release, and the next call
 * tries again.
 */
export function acquireGeometry(name: GeometryName, segments: number | undefined): PendingGeometry {
  const key = keyOf(name, segments);
  const present = shared.get(key);
  if (present) {
    present.users += 1;
    return present.geometry;
  }
  const geometry = createGeometry(name, segments);
  const entry: Shared = { geometry, users: 1 };
  shared.set(key, entry);
  if (geometry instanceof Promise) {
    geometry.catch(() => {
      if (shared.get(key) === entry) shared.delete(key);
    });
  }
  return geometry;
}

/** Ends one use; the last one frees the geometry. More releases than uses do nothing. */
export function releaseGeometry(name: GeometryName, segments: number | undefined): void {
  const key = keyOf(name, segments);
  const entry = shared.get(key);
  if (!entry) return;
  entry.users -= 1;
  if (entry.users > 0) return;
  shared.delete(key);
  if (entry.geometry instanceof Promise) {
    // A rejection was reported to the caller of acquireGeometry; there is nothing to free.
    entry.geometry.then(
      (geometry) => {
        geometry.dispose();
      },
      () => undefined,
    );
  } else {
    entry.geometry.dispose();
  }
}

/**
 * Fits a shape into the unit box: centred on the origin, largest extent 1. Scales (uniformly) and moves the positions
 * in place, in float64 until the last rounding. Normals keep their directions.
 */
function fitToUnitBox(geometry: BufferGeometry): BufferGeometry {
  const position = geometry.getAttribute('position');
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < position.count; i += 1) {
    for (let axis = 0; axis < 3; axis += 1) {
      const value = position.getComponent(i, axis);
      low[axis] = Math.min(low[axis] ?? value, value);
      high[axis] = Math.max(high[axis] ?? value, value);
    }
  }
  const extent = low.map((value, axis) => (high[axis] ?? value) - value);
  const center = low.map((value, axis) => ((high[axis] ?? value) + value) / 2);
  const scale = 1 / Math.max(...extent);
  for (let i = 0; i < position.count; i += 1) {
    for (let axis = 0; axis < 3; axis += 1) {
      position.setComponent(i, axis, (position.getComponent(i, axis) - (center[axis] ?? 0)) * scale);
    }
  }
  geometry.boundingBox = null;
  geometry.boundingSphere = null;
  return geometry;
}
