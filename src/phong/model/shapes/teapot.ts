// The Utah teapot, spout toward +x, in the unit box. A chunk of its own: three.js's table of
// control points is large.
import { TeapotGeometry } from 'three/addons/geometries/TeapotGeometry.js';
import type { BufferGeometry } from 'three';
import { type Grid, gridGeometry } from './grid-geometry.js';

const PATCHES = 32;
/** Bézier patches that make one turn round the body. */
const PATCHES_AROUND = 4;

/** Patches whose first row is one point: the top of the lid and the middle of the bottom. */
const isClosed = (patch: number) => (patch >= 20 && patch < 24) || patch >= 28;

/**
 * Extent along x of the round teapot in three.js's size 1, and the centre of its box, which is on
 * the x axis.
 */
const EXTENT = 4.08512714;
const CENTER = 0.13780166;

/** Shorter normals have no direction: those of the closed rows. The others are longer than 1e-2. */
const NO_NORMAL = 1e-5;

/** The patches of the spout's bend, whose rows lie across it. */
const isBend = (patch: number) => patch === 16 || patch === 17;

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
  const [down, across] = [weightsOf(rows), weightsOf(columns)];
  const closedFirst = isClosed(patch);
  return {
    columns,
    rows,
    corners: [0, 1, 3, 0, 3, 2],
    closedFirst,
    row: (row, put) => {
      // The row is a cubic, and so is the way in which it changes: four points of each, x y z.
      blend(down, 2 * row, samples, points);
      blend(down, 2 * row + 1, samples, slopes);
      for (let column = 0; column <= columns; column++) {
        const t = closedFirst && row === 0 ? 0 : 2 * column;
        blend(across, t, points, place);
        blend(across, t, slopes, along);
        blend(across, t + 1, points, beside);
        const y = place[1]!;
        let nx = beside[1]! * along[2]! - beside[2]! * along[1]!;
        let ny = beside[2]! * along[0]! - beside[0]! * along[2]!;
        let nz = beside[0]! * along[1]! - beside[1]! * along[0]!;
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
        const x = (place[0]! - CENTER) / EXTENT;
        put(x, y / EXTENT, place[2]! / EXTENT, nx, ny, nz, u, v);
      }
    },
  };
}

/** Vertices along the side of a patch that determine it: it is bicubic. */
const SAMPLES = 4;

/** Of the row that is written. */
const points = new Float64Array(3 * SAMPLES);
const slopes = new Float64Array(3 * SAMPLES);
/** Of the vertex. */
const place = new Float64Array(3);
const along = new Float64Array(3);
const beside = new Float64Array(3);

/**
 * Writes a mean of the four quarters of `values`, by the weights number `t`. It is summed from both
 * ends: what two patches share is the same number from either side.
 */
function blend(weights: Float64Array, t: number, values: Float64Array, mean: Float64Array) {
  const w = SAMPLES * t;
  const step = mean.length;
  const a = weights[w]!;
  const b = weights[w + 1]!;
  const c = weights[w + 2]!;
  const d = weights[w + 3]!;
  for (let k = 0; k < step; k++) {
    const ends = a * values[k]! + d * values[k + 3 * step]!;
    mean[k] = ends + (b * values[k + step]! + c * values[k + 2 * step]!);
  }
}

let coarse: Float64Array | null = null;

/** The coarse teapot's vertices of a patch. three.js does not give its control points away. */
function samplesOf(patch: number): Float64Array {
  coarse ??= welded(
    Float64Array.from(new TeapotGeometry(1, SAMPLES - 1).getAttribute('position').array),
  );
  const size = 3 * SAMPLES * SAMPLES;
  return coarse.subarray(size * patch, size * (patch + 1));
}

/** Equal points differ by roundings where patches meet, by up to 5e-7; others are 1e-2 apart. */
const SAME_POINT = 1e-5;

function welded(values: Float64Array): Float64Array {
  for (let i = 0; i < values.length; i += 3) {
    for (let j = 0; j < i; j += 3) {
      // Nearly all points differ in the first coordinate.
      if (
        Math.abs(values[i]! - values[j]!) > SAME_POINT ||
        Math.abs(values[i + 1]! - values[j + 1]!) > SAME_POINT ||
        Math.abs(values[i + 2]! - values[j + 2]!) > SAME_POINT
      ) {
        continue;
      }
      values.copyWithin(i, j, j + 3);
      break;
    }
  }
  return values;
}

/**
 * Weights of the samples for each division of a patch's side: first how much each counts, then how
 * fast that changes. The second half is the first one's mirror image, exactly.
 */
function weightsOf(divisions: number): Float64Array {
  const weights = new Float64Array(2 * SAMPLES * (divisions + 1));
  for (let i = 0; 2 * i <= divisions; i++) {
    const [values, rates] = basisAt(i / divisions);
    const mirrored = [...rates.map((rate) => -rate), ...values].reverse();
    weights.set(mirrored, 2 * SAMPLES * (divisions - i));
    weights.set([...values, ...rates], 2 * SAMPLES * i);
  }
  return weights;
}

/** Lagrange's polynomials for samples at 0, 1/3, 2/3 and 1, and their derivatives. */
function basisAt(t: number): readonly [number[], number[]] {
  const [a, b, c, d] = [t, t - 1 / 3, t - 2 / 3, t - 1];
  return [
    t === 0
      ? [1, 0, 0, 0]
      : [-4.5 * b * c * d, 13.5 * a * c * d, -13.5 * a * b * d, 4.5 * a * b * c],
    [
      -4.5 * (c * d + b * d + b * c),
      13.5 * (c * d + a * d + a * c),
      -13.5 * (b * d + a * d + a * b),
      4.5 * (b * c + a * c + a * b),
    ],
  ];
}
