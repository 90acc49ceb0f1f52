// The geometries of named shapes. Every shape is centred on the origin, in its mesh's own units.
import {
  Box3,
  BoxGeometry,
  type BufferGeometry,
  Matrix4,
  PlaneGeometry,
  Sphere,
  Vector3,
} from 'three';
import { cosDegrees, sinDegrees } from '../../math/angle.js';
import type { Vec3 } from '../../math/vector.js';
import { declareSize, type GeometrySize, type Vertices } from '../../geometry/geometry-size.js';
import { lazyCode } from '../../lazy-code.js';
import { VALUES_PER_TRIANGLE } from '../limits.js';
import { circle, gridGeometry } from './grid-geometry.js';
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
 * Shapes without holes: each edge has exactly two triangles, so their inside cannot be seen from
 * outside. Not the teapot: its spout is open, and its parts end inside each other.
 */
export const CLOSED: ReadonlySet<GeometryName> = new Set(
  GEOMETRIES.filter((name) => name !== 'plane' && name !== 'teapot'),
);

/** A geometry, or a promise where the shape's code is a chunk of its own. */
type PendingGeometry = BufferGeometry | Promise<BufferGeometry>;

interface Shape {
  readonly segments: number;
  /** Fewest segments that still enclose the shape; smaller requests are raised to it. */
  readonly least: number;
  /** `out`: how far the vertices of a round shape are outside it. `isLevel`: of `auto`. */
  readonly create: (segments: number, out: number, isLevel: boolean) => PendingGeometry;
  /** Number of triangles, at least the true one, before anything is built. */
  readonly triangles: (segments: number) => number;
  readonly round?: Round;
}

/**
 * How a curved shape differs from its triangles. Of n segments, the triangles' middles lie up to
 * g/n² inside the shape or outside it; where it can be, all vertices of an `auto` level are moved
 * outward, so that both are equal.
 */
export interface Round {
  /**
   * Most that the triangles of an `auto` level are inside the shape or outside it, times n².
   * Measured.
   */
  readonly gap: number;
  /** How far its vertices are outside the shape, times n². */
  readonly out: number;
  /**
   * Segments by which shading within faces is within a code of the round shape's in 99 of 100
   * pixels. Measured.
   */
  readonly smooth: number;
  /** How much of its bounding sphere's disc it covers, mean of all directions. */
  readonly cover: number;
  /** Most segments of an `auto` level: it has at most 131,072 triangles. */
  readonly most: number;
  /**
   * Half the size of the round shape's box, and the distance of its farthest point from the origin.
   */
  readonly half: Vec3;
  readonly radius: number;
}

/** A chunk whose code is kept: shapes are built at once when it is there. */
function kept<T>(load: () => Promise<T>): (build: (code: T) => BufferGeometry) => PendingGeometry {
  let code: T | null = null;
  return (build) => (code === null ? load().then((loaded) => build((code = loaded))) : build(code));
}

const solidsCode = /* @__PURE__ */ kept(
  /* @__PURE__ */ lazyCode(() => import('./solids.js'), 'the solid shapes'),
);
const teapotCode = /* @__PURE__ */ kept(
  /* @__PURE__ */ lazyCode(() => import('./teapot.js'), 'the teapot'),
);

const solid =
  (name: keyof typeof SOLIDS): Shape['create'] =>
  (n, out, isLevel) =>
    solidsCode((code) => code.SOLIDS[name](n, out, isLevel));

/** Segments across the main ones, half as many. */
const rowsOf = (segments: number, least: number) => Math.max(least, Math.round(segments / 2));

function sphere(columns: number, out: number): BufferGeometry {
  const rows = rowsOf(columns, 2);
  const radius = 0.5 + out;
  const { cos, sin } = circle(columns);
  return gridGeometry([
    {
      columns,
      rows,
      corners: [1, 0, 3, 0, 2, 3],
      closedFirst: true,
      closedLast: true,
      row: (row, put) => {
        const polar = (row / rows) * 180;
        const across = sinDegrees(polar);
        const y = cosDegrees(polar);
        // The texture's corner at a pole is over the middle of its triangle.
        const shift = row === 0 ? 0.5 / columns : row === rows ? -0.5 / columns : 0;
        for (let i = 0; i <= columns; i++) {
          const x = -cos[i]! * across;
          const z = sin[i]! * across;
          put(radius * x, radius * y, radius * z, x, y, z, i / columns + shift, 1 - row / rows);
        }
      },
    },
  ]);
}

/**
 * The sagitta of a circle of radius 1/2, times n²: the distance of a chord's middle from the arc.
 */
const SAGITTA = (Math.PI * Math.PI) / 4;

const HALF: Vec3 = [0.5, 0.5, 0.5];

/**
 * Cylinder and cone: curved in one direction, so only half a sagitta is left once the vertices are
 * moved.
 */
const STRAIGHT = {
  gap: SAGITTA / 2,
  out: SAGITTA / 2,
  smooth: 48,
  most: 1024,
  half: HALF,
  radius: Math.SQRT1_2,
};

const FLAT = { segments: 1, least: 1 };

/** Curved shapes enclose space from 3 segments on. */
const AROUND = { segments: 64, least: 3 };

/** Turns +z to +y and +y to −z, exactly: `rotateX` leaves 6e-17 of the sine's rounding. */
const UPWARD = /* @__PURE__ */ new Matrix4(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1);

/**
 * `segments` counts along a side for the flat shapes (box, pyramid, plane), once round the axis for
 * the others.
 */
const SHAPES: Readonly<Record<GeometryName, Shape>> = {
  box: { ...FLAT, create: (n) => new BoxGeometry(1, 1, 1, n, n, n), triangles: (n) => 12 * n * n },
  sphere: {
    ...AROUND,
    create: sphere,
    triangles: (n) => 2 * n * (rowsOf(n, 2) - 1),
    // In the middle of a quadrangle both of its curves are a sagitta away.
    round: { gap: SAGITTA, out: SAGITTA, smooth: 64, cover: 1, most: 360, half: HALF, radius: 0.5 },
  },
  cylinder: {
    ...AROUND,
    create: solid('cylinder'),
    triangles: (n) => 4 * n,
    round: { ...STRAIGHT, cover: 0.75 },
  },
  cone: {
    ...AROUND,
    create: solid('cone'),
    triangles: (n) => 2 * n,
    round: { ...STRAIGHT, cover: 0.4 },
  },
  pyramid: { ...FLAT, create: solid('pyramid'), triangles: (n) => 6 * n * n },
  torus: {
    ...AROUND,
    create: solid('torus'),
    triangles: (n) => 2 * n * rowsOf(n, 3),
    round: {
      gap: 3.21,
      out: 2.22,
      smooth: 96,
      cover: 0.62,
      most: 360,
      half: [0.5, 0.5, 0.15],
      radius: 0.5,
    },
  },
  'torus-knot': {
    segments: 256,
    // Below this the tube's sections cut through each other, and triangles turn against their
    // normals.
    least: 32,
    create: solid('torus-knot'),
    triangles: (n) => 2 * n * Math.max(8, Math.round(n / 8)),
    round: {
      gap: 38.5,
      out: 29.5,
      smooth: 384,
      cover: 0.54,
      most: 720,
      half: [0.479874, 0.5, 0.248054],
      radius: 0.549929,
    },
  },
  teapot: {
    segments: 64,
    // Below this two triangles of the spout turn against their normals.
    least: 12,
    create: (n, _, isLevel) => teapotCode((code) => code.teapot(n, isLevel)),
    // 32 patches, four to a turn. Two of a level have more, those at the poles have less.
    triangles: (n) => 67 * Math.round(n / 4) * Math.round(n / 4),
    // Its parts have seams: vertices moved outward would open them. The lid's rim is farther off
    // (2.8), and hidden.
    round: {
      gap: 2.53,
      out: 0,
      smooth: 96,
      cover: 0.3,
      most: 176,
      half: [0.5, 0.244791, 0.310845],
      radius: 0.519157,
    },
  },
  plane: {
    ...FLAT,
    create: (n) => new PlaneGeometry(1, 1, n, n).applyMatrix4(UPWARD),
    triangles: (n) => 2 * n * n,
  },
};

/** Fewest segments of an `auto` level of most shapes. */
const COARSEST = 16;

export const coarsestOf = (name: GeometryName): number => effectiveSegments(name, COARSEST);

/** The shape's values as a round shape; undefined for one with flat faces. */
export const roundOf = (name: GeometryName): Round | undefined => SHAPES[name].round;

/** The segments that a shape is made with. `undefined` means the shape's default. */
export function effectiveSegments(name: GeometryName, segments: number | undefined): number {
  const shape = SHAPES[name];
  return Math.max(shape.least, Math.round(segments ?? shape.segments));
}

/** Triangles of a shape, at least the true number, before it is built. */
export const trianglesOf = (name: GeometryName, segments: number | undefined): number =>
  SHAPES[name].triangles(effectiveSegments(name, segments));

/** What flat copies count as triangles, by their memory: each corner has 8 values. */
export const flatTrianglesOf = (triangles: number): number =>
  Math.ceil((triangles * 3 * 8) / VALUES_PER_TRIANGLE);

/**
 * A new geometry, owned by the caller: indexed, with `position`, `normal` (unit length to float32)
 * and `uv`.
 * @param segments 1 to 512, as for {@link effectiveSegments}.
 * @param isLevel of `auto`: as far outside the round shape as inside, and a cone's tip has no
 * normal.
 */
export function createGeometry(
  name: GeometryName,
  segments: number | undefined,
  isLevel = false,
): PendingGeometry {
  const { create, round } = SHAPES[name];
  const n = effectiveSegments(name, segments);
  if (round === undefined) return create(n, 0, false);
  const out = isLevel ? round.out / (n * n) : 0;
  const geometry = create(n, out, isLevel);
  return geometry instanceof Promise
    ? geometry.then((ready) => bounded(name, ready, out))
    : bounded(name, geometry, out);
}

/** Framing, and so the picture, is that of the round shape, whatever the number of segments. */
function bounded(name: GeometryName, geometry: BufferGeometry, out: number): BufferGeometry {
  const { half, radius } = SHAPES[name].round!;
  const [x, y, z] = half;
  let size = roundSizes.get(name);
  if (size === undefined) {
    const { create, segments } = SHAPES[name];
    let vertices: Vertices | undefined;
    // Its code is here, so this is no promise.
    const made = (): Vertices =>
      (create(segments, 0, false) as BufferGeometry).getAttribute('position').array as Float32Array;
    const box = [-x, -y, -z, x, y, z] as const;
    size = { box, center: [0, 0, 0], radius, vertices: () => (vertices ??= made()) };
    roundSizes.set(name, size);
  }
  declareSize(geometry, size);
  // Lights and faces are culled by what is drawn.
  const corner = new Vector3(x + out, y + out, z + out);
  geometry.boundingBox = new Box3(corner.clone().negate(), corner);
  geometry.boundingSphere = new Sphere(new Vector3(), radius + out);
  return geometry;
}

const roundSizes = new Map<GeometryName, GeometrySize>();
