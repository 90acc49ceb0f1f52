// The true round shapes, in float64 and by other means than the package's: points and normals of their surfaces, for
// the distance of triangles from them.
import { TeapotGeometry } from 'three/addons/geometries/TeapotGeometry.js';
import { add, cross, dot, normalize, scale, subtract, type Vec3 } from '../../src/math/vector.js';

/** A piece of surface over the unit square; `a` runs along the rows of its grid, `b` along the columns. */
type Surface = (a: number, b: number) => { readonly p: Vec3; readonly N: Vec3 };

/** The surface that a grid of quadrangles of an `auto` level approximates, and the diagonal of the quadrangles. */
export interface Piece {
  readonly surface: Surface;
  readonly rows: (segments: number) => number;
  readonly columns: (segments: number) => number;
  /** Which corners the diagonal connects: 0 to 3, or 1 to 2. */
  readonly diagonal: 'main' | 'other';
  /** Its largest deviation is at no outline. */
  readonly isHidden?: boolean;
}

const turn = 2 * Math.PI;

const sphere: Surface = (a, b) => {
  const N: Vec3 = [
    -Math.cos(turn * b) * Math.sin(Math.PI * a),
    Math.cos(Math.PI * a),
    Math.sin(turn * b) * Math.sin(Math.PI * a),
  ];
  return { p: scale(N, 0.5), N };
};

const torus: Surface = (a, b) => {
  const across = Math.cos(turn * a);
  const N: Vec3 = [across * Math.cos(turn * b), across * Math.sin(turn * b), Math.sin(turn * a)];
  return { p: add(scale([Math.cos(turn * b), Math.sin(turn * b), 0], 0.35), scale(N, 0.15)), N };
};

const cylinder: Surface = (a, b) => {
  const N: Vec3 = [Math.sin(turn * b), 0, Math.cos(turn * b)];
  return { p: [N[0] / 2, 0.5 - a, N[2] / 2], N };
};

const cone: Surface = (a, b) => {
  const out: Vec3 = [Math.sin(turn * b), 0, Math.cos(turn * b)];
  return { p: [(a * out[0]) / 2, 0.5 - a, (a * out[2]) / 2], N: normalize([out[0], 0.5, out[2]]) };
};

const curve = (angle: number): Vec3 => {
  const distance = (2 + Math.cos(1.5 * angle)) / 2;
  return [distance * Math.cos(angle), distance * Math.sin(angle), Math.sin(1.5 * angle) / 2];
};

/** In three.js's size. */
const knotInThree: Surface = (a, b) => {
  const angle = 4 * Math.PI * a;
  const here = curve(angle);
  const next = curve(angle + 0.01);
  const along = subtract(next, here);
  const B = cross(along, add(next, here));
  const inward = normalize(cross(B, along));
  const N = add(scale(inward, -Math.cos(turn * b)), scale(normalize(B), Math.sin(turn * b)));
  return { p: add(here, scale(N, 0.4)), N };
};

const DIVISIONS = 3;
const SIDE = DIVISIONS + 1;

/** Newton's form through four samples: another one than the package's. */
function through(samples: readonly [Vec3, Vec3, Vec3, Vec3], t: number): { p: Vec3; slope: Vec3 } {
  const [a, b, c, d] = samples;
  const first = subtract(b, a);
  const second = scale(add(subtract(c, scale(b, 2)), a), 1 / 2);
  const third = scale(subtract(add(subtract(d, scale(c, 3)), scale(b, 3)), a), 1 / 6);
  const s = DIVISIONS * t;
  const p = add(add(a, scale(first, s)), add(scale(second, s * (s - 1)), scale(third, s * (s - 1) * (s - 2))));
  const slope = add(first, add(scale(second, 2 * s - 1), scale(third, 3 * s * s - 6 * s + 2)));
  return { p, slope };
}

/** In three.js's size 1. */
function teapotInThree(): Surface[] {
  const places = new TeapotGeometry(1, DIVISIONS).getAttribute('position');
  const at = (i: number): Vec3 => [places.getX(i), places.getY(i), places.getZ(i)];
  return Array.from({ length: 32 }, (_, patch): Surface => (a, b) => {
    const rows = [0, 1, 2, 3].map((row) => {
      const first = SIDE * SIDE * patch + SIDE * row;
      return through([at(first), at(first + 1), at(first + 2), at(first + 3)], b);
    });
    const along = (key: 'p' | 'slope') =>
      through(rows.map((row) => row[key]) as unknown as [Vec3, Vec3, Vec3, Vec3], a);
    const { p, slope } = along('p');
    const N = cross(along('slope').p, slope);
    return { p, N: Math.hypot(...N) > 1e-6 ? normalize(N) : [0, 0, 0] };
  });
}

/** Moved and scaled. */
const placed =
  (surface: Surface, center: number, extent: number): Surface =>
  (a, b) => {
    const { p, N } = surface(a, b);
    return { p: scale(subtract(p, [center, 0, 0]), 1 / extent), N };
  };

/** Largest coordinates of surfaces along x, y and z, and against them, refined from a grid of points. */
export function boxOf(surfaces: readonly Surface[], steps: number): readonly [low: number, high: number][] {
  return ([0, 1, 2] as const).map((axis) => [
    -Math.max(...surfaces.map((surface) => highest((a, b) => -surface(a, b).p[axis], steps))),
    Math.max(...surfaces.map((surface) => highest((a, b) => surface(a, b).p[axis], steps))),
  ]);
}

/** The largest value of a function on the unit square, refined from a grid of `steps`. */
export function highest(value: (a: number, b: number) => number, steps: number): number {
  let best = [-Infinity, 0, 0] as [number, number, number];
  const consider = (a: number, b: number): void => {
    const here = value(Math.min(1, Math.max(0, a)), Math.min(1, Math.max(0, b)));
    if (here > best[0]) best = [here, a, b];
  };
  for (let i = 0; i <= steps; i++) for (let j = 0; j <= steps; j++) consider(i / steps, j / steps);
  for (let reach = 1 / steps; reach > 1e-8; reach *= 0.5) {
    const [, a, b] = best;
    for (let i = -4; i <= 4; i++) for (let j = -4; j <= 4; j++) consider(a + (i * reach) / 4, b + (j * reach) / 4);
  }
  return best[0];
}

export type RoundName = 'sphere' | 'cylinder' | 'cone' | 'torus' | 'torus-knot' | 'teapot';

/** The shapes as the package places them. The knot's and the teapot's boxes are measured, not taken from it. */
export function roundShapes(): Readonly<Record<RoundName, readonly Piece[]>> {
  const half = (n: number): number => Math.round(n / 2);
  const once = (): number => 1;
  const same = (n: number): number => n;
  const [[low, high], [bottom, top]] = boxOf([knotInThree], 200) as [[number, number], [number, number]];
  const knot = placed(knotInThree, (low + high) / 2, top - bottom);
  const patches = teapotInThree();
  const [[left, right]] = boxOf(patches, 20) as [[number, number]];
  const quarter = (n: number): number => Math.round(n / 4);
  return {
    sphere: [{ surface: sphere, rows: half, columns: same, diagonal: 'main' }],
    cylinder: [{ surface: cylinder, rows: once, columns: same, diagonal: 'other' }],
    cone: [{ surface: cone, rows: once, columns: same, diagonal: 'other' }],
    torus: [{ surface: torus, rows: half, columns: same, diagonal: 'main' }],
    'torus-knot': [{ surface: knot, rows: same, columns: (n) => Math.max(8, Math.round(n / 8)), diagonal: 'other' }],
    teapot: patches.map((patch, i) => ({
      surface: placed(patch, (left + right) / 2, right - left),
      rows: (n) => (i === 16 || i === 17 ? Math.ceil(1.6 * quarter(n)) : quarter(n)), // the spout's bend
      ...{ columns: quarter, diagonal: 'main' as const },
      isHidden: i >= 24 && i < 28, // the lid's rim lies in the body's groove
    })),
  };
}

/**
 * How far the triangles of a piece are inside the surface (above 0) or outside it, if all their corners are on it. At
 * points of each triangle, along the normal of the surface above it.
 */
export function deviations(
  { surface, rows, columns, diagonal }: Piece,
  segments: number,
): readonly [low: number, high: number] {
  const [r, c] = [rows(segments), columns(segments)];
  let low = Infinity;
  let high = -Infinity;
  for (let i = 0; i < r; i++) {
    for (let j = 0; j < c; j++) {
      const corner = (k: number): readonly [number, number] => [(i + (k >> 1)) / r, (j + (k & 1)) / c];
      for (const triangle of TRIANGLES[diagonal]) {
        const at = triangle.map(corner);
        const places = at.map(([a, b]) => surface(a, b).p);
        for (const weights of WEIGHTS) {
          const mixed = (axis: 0 | 1): number => weights.reduce((sum, w, k) => sum + w * at[k]![axis], 0);
          const { p, N } = surface(mixed(0), mixed(1));
          const point = places.map((place, k) => scale(place, weights[k]!)).reduce(add);
          const inside = dot(subtract(p, point), N);
          low = Math.min(low, inside);
          high = Math.max(high, inside);
        }
      }
    }
  }
  return [low, high];
}

/** Corners of the two triangles of a quadrangle. */
// prettier-ignore
const TRIANGLES = {
  main: [[0, 1, 3], [0, 3, 2]],
  other: [[0, 2, 1], [2, 3, 1]],
} as const;

/** Points of a triangle: corners, and points that divide its sides into four. */
const WEIGHTS: readonly Vec3[] = [0, 1, 2, 3, 4].flatMap((i) =>
  [0, 1, 2, 3, 4].filter((j) => i + j <= 4).map((j): Vec3 => [i / 4, j / 4, (4 - i - j) / 4]),
);
