// The Utah teapot, spout toward +x, moved and scaled so that the round shape fits the unit box. In a chunk of its own
// because of three.js's table of control points.
import { TeapotGeometry } from 'three/addons/geometries/TeapotGeometry.js';
import { type Grid, gridGeometry, put, type Steps, type Vertices } from './grid-geometry.js';

const PATCHES = 32;
/** Bézier patches that make one turn round the body. */
const PATCHES_AROUND = 4;

/** Patches whose first row is one point: the top of the lid and the middle of the bottom. */
const isClosed = (patch: number): boolean => (patch >= 20 && patch < 24) || patch >= 28;

/** Extent along x of the round teapot in three.js's size 1, and the centre of its box, which is on the x axis. */
const EXTENT = 4.08512714;
const CENTER = 0.13780166;

/** Shorter normals have no direction: those of the closed rows. The others are longer than 1e-2. */
const NO_NORMAL = 1e-5;

/** The patches of the spout's bend, whose rows lie across it. */
const isBend = (patch: number): boolean => patch === 16 || patch === 17;

/**
 * @param segments once round the body, at least 12; rounded to whole divisions of a patch.
 * @param isLevel with more rows in the spout's bend: else all of the teapot would need a quarter more segments.
 */
export function teapot(segments: number, isLevel: boolean): Steps {
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
  const sums = new Float64Array(9);
  return {
    ...{ columns, rows, corners: [0, 1, 3, 0, 3, 2], closedFirst: isClosed(patch) },
    row: (row, into, first) => {
      const s = down[row]!;
      for (let column = 0; column <= columns; column++) {
        const t = across[column]!;
        sums.fill(0);
        for (let k = 0; k < SAMPLES * SAMPLES; k++) {
          const [i, j] = [k >> 2, k & 3];
          for (let axis = 0; axis < 3; axis++) {
            const place = samples[3 * k + axis]!;
            sums[axis]! += s.value[i]! * t.value[j]! * place;
            sums[3 + axis]! += s.slope[i]! * t.value[j]! * place;
            sums[6 + axis]! += s.value[i]! * t.slope[j]! * place;
          }
        }
        putVertex(sums, 1 - column / columns, 1 - row / rows, into, first + column);
      }
    },
  };
}

/** `sums`: the place, and how it changes along the patch and across it. */
function putVertex(sums: Float64Array, u: number, v: number, into: Vertices, vertex: number): void {
  const [x, y, z, ax, ay, az, bx, by, bz] = sums as unknown as number[] as [number, number, number, number, number, number, number, number, number]; // prettier-ignore
  let nx = by * az - bz * ay;
  let ny = bz * ax - bx * az;
  let nz = bx * ay - by * ax;
  const length = Math.hypot(nx, ny, nz);
  if (length > NO_NORMAL) {
    nx /= length;
    ny /= length;
    nz /= length;
  } else [nx, ny, nz] = [0, y > 0 ? 1 : -1, 0];
  put(into, vertex, (x - CENTER) / EXTENT, y / EXTENT, z / EXTENT, nx, ny, nz, u, v);
}

/** Vertices along the side of a patch that determine it: it is bicubic. */
const SAMPLES = 4;

let coarse: ArrayLike<number> | null = null;

/** The coarse teapot's vertices of a patch. three.js does not give its control points away. */
function samplesOf(patch: number): readonly number[] {
  coarse ??= new TeapotGeometry(1, SAMPLES - 1).getAttribute('position').array;
  const first = 3 * SAMPLES * SAMPLES * patch;
  return Array.from({ length: 3 * SAMPLES * SAMPLES }, (_, i) => coarse![first + i]!);
}

interface Basis {
  /** How much each sample counts. */
  readonly value: readonly number[];
  /** How fast that changes. */
  readonly slope: readonly number[];
}

const basesOf = (divisions: number): Basis[] =>
  Array.from({ length: divisions + 1 }, (_, i) => basisAt(i / divisions));

/** Lagrange's polynomials for samples at 0, 1/3, 2/3 and 1. */
function basisAt(t: number): Basis {
  const [a, b, c, d] = [t, t - 1 / 3, t - 2 / 3, t - 1];
  return {
    value: [-4.5 * b * c * d, 13.5 * a * c * d, -13.5 * a * b * d, 4.5 * a * b * c],
    slope: [
      -4.5 * (c * d + b * d + b * c),
      13.5 * (c * d + a * d + a * c),
      -13.5 * (b * d + a * d + a * b),
      4.5 * (b * c + a * c + a * b),
    ],
  };
}
