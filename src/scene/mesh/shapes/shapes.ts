// Which triangles does a named shape have? Every shape is centred on the origin, in its mesh's own units. Meshes with the
// same shape and segments share one BufferGeometry; users are counted, and the last one frees it. Knows neither materials nor
// lights nor elements.
import { BoxGeometry, type BufferGeometry, PlaneGeometry, SphereGeometry } from 'three';
import { lazyCode } from '../../lazy-code.js';
import { fitToUnitBox } from './fit.js';
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

/** Shapes that enclose a volume: their inside cannot be seen from outside. */
export const CLOSED: ReadonlySet<GeometryName> = new Set(GEOMETRIES.filter((name) => name !== 'plane'));

/** A geometry, or a promise where the shape's code is a chunk of its own. */
export type PendingGeometry = BufferGeometry | Promise<BufferGeometry>;

interface Shape {
  /** Default number of segments. */
  readonly segments: number;
  /** Fewest segments that still enclose the shape; smaller requests are raised to it. */
  readonly least: number;
  readonly create: (segments: number) => PendingGeometry;
}

const solidsCode = /* @__PURE__ */ lazyCode(() => import('./solids.js'), 'the solid shapes');
const teapotCode = /* @__PURE__ */ lazyCode(() => import('./teapot.js'), 'the teapot');

const solid =
  (name: keyof typeof SOLIDS): Shape['create'] =>
  async (n) =>
    (await solidsCode()).SOLIDS[name](n);

/** `segments` counts along a side for the flat shapes (box, pyramid, plane), once round the axis for the others. */
const SHAPES: Readonly<Record<GeometryName, Shape>> = {
  box: { segments: 1, least: 1, create: (n) => new BoxGeometry(1, 1, 1, n, n, n) },
  sphere: {
    segments: 64,
    least: 3,
    create: (n) => new SphereGeometry(0.5, n, Math.max(2, Math.round(n / 2))),
  },
  cylinder: { segments: 64, least: 3, create: solid('cylinder') },
  cone: { segments: 64, least: 3, create: solid('cone') },
  pyramid: { segments: 1, least: 1, create: solid('pyramid') },
  torus: { segments: 64, least: 3, create: solid('torus') },
  'torus-knot': {
    segments: 256,
    // Below this the tube's sections cut through each other, and triangles turn against their normals.
    least: 32,
    create: async (n) => fitToUnitBox(await solid('torus-knot')(n)),
  },
  teapot: {
    segments: 64,
    // Below this two triangles of the spout turn against their normals.
    least: 12,
    create: async (n) => fitToUnitBox((await teapotCode()).teapotGeometry(n)),
  },
  plane: { segments: 1, least: 1, create: (n) => new PlaneGeometry(1, 1, n, n).rotateX(-Math.PI / 2) },
};

/** The segments that a shape is made with. `undefined` means the shape's default. */
export function effectiveSegments(name: GeometryName, segments: number | undefined): number {
  const shape = SHAPES[name];
  return Math.max(shape.least, Math.round(segments ?? shape.segments));
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
 * {@link releaseGeometry} with the same arguments, whether or not a promise has settled by then; only this cache disposes
 * of the geometry. A rejected promise (a chunk that could not be fetched) needs no release, and the next call tries again.
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
