// The Utah teapot, spout toward +x, moved and scaled so that the round shape fits the unit box. In a chunk of its own
// because of three.js's table of control points.
import { TeapotGeometry } from 'three/addons/geometries/TeapotGeometry.js';
import type { BufferGeometry } from 'three';
import { add, cross, scale, type Vec3 } from '../../../math/vector.js';
import { type Grid, gridGeometry, put, type Vertices } from './grid-geometry.js';

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
    ...{ columns, rows, corners: [0, 1, 3, 0, 3, 2], closedFirst },
    row: (row, into, first) => {
      const s = down[row]!;
      for (let column = 0; column <= columns; column++) {
        const t = across[closedFirst && row === 0 ? 0 : column]!;
        const along = (i: number, weights: Weights): Vec3 => mix(weights, (j) => samples[SAMPLES * i + j]!);
        const p = mix(s.value, (i) => along(i, t.value));
        const a = mix(s.slope, (i) => along(i, t.value));
        const b = mix(s.value, (i) => along(i, t.slope));
        putVertex(p, cross(b, a), 1 - column / columns, 1 - row / rows, into, first + column);
      }
    },
  };
}

/** Both ends first: what patches share is the same number, whichever end of it a patch begins with. */
function mix(weights: Weights, at: (i: number) => Vec3): Vec3 {
  const part = (i: number): Vec3 => scale(at(i), weights[i]!);
  return add(add(part(0), part(3)), add(part(1), part(2)));
}

function putVertex([x, y, z]: Vec3, N: Vec3, u: number, v: number, into: Vertices, vertex: number): void {
  const length = Math.hypot(...N);
  const [nx, ny, nz] = length > NO_NORMAL ? scale(N, 1 / length) : [0, y > 0 ? 1 : -1, 0];
  put(into, vertex, (x - CENTER) / EXTENT, y / EXTENT, z / EXTENT, nx, ny, nz, u, v);
}

/** Vertices along the side of a patch that determine it: it is bicubic. */
const SAMPLES = 4;

let coarse: readonly Vec3[] | null = null;

/** The coarse teapot's vertices of a patch. three.js does not give its control points away. */
function samplesOf(patch: number): readonly Vec3[] {
  coarse ??= welded(new TeapotGeometry(1, SAMPLES - 1).getAttribute('position').array);
  const first = SAMPLES * SAMPLES * patch;
  return coarse.slice(first, first + SAMPLES * SAMPLES);
}

/** Equal points differ by roundings where patches meet, by up to 5e-7; others are 1e-2 apart. */
const SAME_POINT = 1e-5;

/** The points, those in one place as one point. */
function welded(values: ArrayLike<number>): Vec3[] {
  const points: Vec3[] = [];
  for (let i = 0; i < values.length; i += 3) {
    const p: Vec3 = [values[i]!, values[i + 1]!, values[i + 2]!];
    points.push(points.find((other) => p.every((x, axis) => Math.abs(x - other[axis]!) < SAME_POINT)) ?? p);
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
    value: t === 0 ? [1, 0, 0, 0] : [-4.5 * b * c * d, 13.5 * a * c * d, -13.5 * a * b * d, 4.5 * a * b * c],
    slope: [
      -4.5 * (c * d + b * d + b * c),
      13.5 * (c * d + a * d + a * c),
      -13.5 * (b * d + a * d + a * b),
      4.5 * (b * c + a * c + a * b),
    ],
  };
}
