// The Utah teapot, spout toward +x, in the unit box. A chunk of its own: three.js's table of
// control points is large.
import { TeapotGeometry } from 'three/addons/geometries/TeapotGeometry.js';
import type { BufferGeometry } from 'three';
import { type Grid, gridGeometry, put } from './grid-geometry.js';

const PATCHES = 32;
/** Bézier patches that make one turn round the body. */
const PATCHES_AROUND = 4;

/** Patches whose first row is one point: the top of the lid and the middle of the bottom. */
const isClosed = (patch: number): boolean => (patch >= 20 && patch < 24) || patch >= 28;

/**
 * Extent along x of the round teapot in three.js's size 1, and the centre of its box, which is on
 * the x axis.
 */
const EXTENT = 4.08512714;
const CENTER = 0.13780166;

/** Shorter normals have no direction: those of the closed rows. The others are longer than 1e-2. */
const NO_NORMAL = 1e-5;

/** The patches of the spout's bend, whose rows lie across it. */
const isBend = (patch: number): boolean => patch === 16 || patch === 17;

/**
 * `segments`: once round the body, at least 12; rounded to whole divisions of a patch. `isLevel`:
 * with more rows in the spout's bend alone; otherwise all of the teapot would need a quarter more
 * segments.
 */
export function teapot(segments: number, isLevel: boolean): BufferGeometry {
  const divisions = Math.round(segments / PATCHES_AROUND);
  const inBend = isLevel ? Math.ceil(1.6 * divisions) : divisions;
  return gridGeometry(
    Array.from({ length: PATCHES }, (_, patch) =>
      patchGrid(patch, isBend(patch) ? inBend : divisions, divisions),
    ),
  );
}

function patchGrid(patch: number, rows: number, columns: number): Grid {
  const samples = samplesOf(patch);
  const [down, across] = [basesOf(rows), basesOf(columns)];
  const closedFirst = isClosed(patch);
  return {
    columns,
    rows,
    corners: [0, 1, 3, 0, 3, 2],
    closedFirst,
    row: (row, into, first) => {
      const s = down[row]!;
      // The row is a cubic, and so is the way in which it changes: four points of each, x y z.
      const points = new Float64Array(3 * SAMPLES).map((_, k) =>
        mix(s.value, samples, k, 3 * SAMPLES),
      );
      const slopes = new Float64Array(3 * SAMPLES).map((_, k) =>
        mix(s.slope, samples, k, 3 * SAMPLES),
      );
      for (let column = 0; column <= columns; column++) {
        const t = across[closedFirst && row === 0 ? 0 : column]!;
        const ax = mix(t.value, slopes, 0, 3);
        const ay = mix(t.value, slopes, 1, 3);
        const az = mix(t.value, slopes, 2, 3);
        const bx = mix(t.slope, points, 0, 3);
        const by = mix(t.slope, points, 1, 3);
        const bz = mix(t.slope, points, 2, 3);
        const x = mix(t.value, points, 0, 3);
        const y = mix(t.value, points, 1, 3);
        const z = mix(t.value, points, 2, 3);
        let nx = by * az - bz * ay;
        let ny = bz * ax - bx * az;
        let nz = bx * ay - by * ax;
        const length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        if (length > NO_NORMAL) {
          nx /= length;
          ny /= length;
          nz /= length;
        } else {
          [nx, ny, nz] = [0, y > 0 ? 1 : -1, 0];
        }
        const u = 1 - column / columns;
        const v = 1 - row / rows;
        put(into, first + column, (x - CENTER) / EXTENT, y / EXTENT, z / EXTENT, nx, ny, nz, u, v);
      }
    },
  };
}

/**
 * Four values `step` apart, summed from both ends: what two patches share is the same number from
 * either side.
 */
function mix(weights: Weights, values: ArrayLike<number>, first: number, step: number): number {
  const ends = weights[0] * values[first]! + weights[3] * values[first + 3 * step]!;
  return ends + (weights[1] * values[first + step]! + weights[2] * values[first + 2 * step]!);
}

/** Vertices along the side of a patch that determine it: it is bicubic. */
const SAMPLES = 4;

let coarse: Float32Array | null = null;

/** The coarse teapot's vertices of a patch. three.js does not give its control points away. */
function samplesOf(patch: number): Float32Array {
  coarse ??= welded(
    new TeapotGeometry(1, SAMPLES - 1).getAttribute('position').array as Float32Array,
  );
  const size = 3 * SAMPLES * SAMPLES;
  return coarse.subarray(size * patch, size * (patch + 1));
}

/** Equal points differ by roundings where patches meet, by up to 5e-7; others are 1e-2 apart. */
const SAME_POINT = 1e-5;

function welded(points: Float32Array): Float32Array {
  for (let i = 0; i < points.length; i += 3) {
    for (let j = 0; j < i; j += 3) {
      const apart = (axis: number): number => Math.abs(points[i + axis]! - points[j + axis]!);
      if (Math.max(apart(0), apart(1), apart(2)) > SAME_POINT) continue;
      points.copyWithin(i, j, j + 3);
      break;
    }
  }
  return points;
}

type Weights = readonly [number, number, number, number];

interface Basis {
  /** How much each sample counts. */
  readonly value: Weights;
  /** How fast that changes. */
  readonly slope: Weights;
}

/** From t = 0 to 1. The second half is the first one's mirror image, exactly. */
const basesOf = (divisions: number): Basis[] =>
  Array.from({ length: divisions + 1 }, (_, i) =>
    2 * i <= divisions ? basisAt(i / divisions) : mirrored(basisAt((divisions - i) / divisions)),
  );

function mirrored({ value: [a, b, c, d], slope: [e, f, g, h] }: Basis): Basis {
  return { value: [d, c, b, a], slope: [-h, -g, -f, -e] };
}

/** Lagrange's polynomials for samples at 0, 1/3, 2/3 and 1. */
function basisAt(t: number): Basis {
  const [a, b, c, d] = [t, t - 1 / 3, t - 2 / 3, t - 1];
  return {
    value:
      t === 0
        ? [1, 0, 0, 0]
        : [-4.5 * b * c * d, 13.5 * a * c * d, -13.5 * a * b * d, 4.5 * a * b * c],
    slope: [
      -4.5 * (c * d + b * d + b * c),
      13.5 * (c * d + a * d + a * c),
      -13.5 * (b * d + a * d + a * b),
      4.5 * (b * c + a * c + a * b),
    ],
  };
}
