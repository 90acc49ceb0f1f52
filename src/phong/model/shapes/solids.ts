// The less common shapes, in one chunk: separate chunks would be smaller than a request costs.
import type { BufferGeometry } from 'three';
import { cosDegrees, sinDegrees } from '../../math/angle.js';
import { cross, normalize, subtract, type Vec3 } from '../../math/vector.js';
import { circle, type Grid, gridGeometry, indexedGeometry } from './grid-geometry.js';

// The ring's radius and the tube's add up to the outer radius 1/2.
const TORUS_RING = 0.35;
const TORUS_TUBE = 0.15;
/** Fewest segments round the tube that enclose it. */
const LEAST_TUBE = 3;

type Solid = (segments: number, out: number, isLevel: boolean) => BufferGeometry;

/** `out`: how far the vertices of a round shape are outside it. `isLevel`: of `segments="auto"`. */
export const SOLIDS: Readonly<
  Record<'cylinder' | 'cone' | 'pyramid' | 'torus' | 'torus-knot', Solid>
> = {
  cylinder: (n, out) =>
    gridGeometry([cap(n, 0.5 + out, 1), side(n, 0.5 + out, 0.5 + out), cap(n, 0.5 + out, -1)]),
  cone: (n, out, isLevel) => gridGeometry([side(n, 0, 0.5 + out, isLevel), cap(n, 0.5 + out, -1)]),
  pyramid,
  torus,
  'torus-knot': torusKnot,
};

/**
 * What lies between the circles of radius `top` and `bottom`, 1 apart. At a cone's tip (`top` 0) a
 * triangle has the normal of its middle; or, if `exact`, none: those of the base alone then give
 * the round cone's in every point.
 */
function side(n: number, top: number, bottom: number, exact = false): Grid {
  const { cos, sin } = circle(n);
  const slope = top === bottom ? 0 : 0.5;
  const across = 1 / Math.sqrt(1 + slope * slope);
  const up = slope * across;
  return {
    columns: n,
    rows: 1,
    corners: [0, 2, 1, 2, 3, 1],
    closedFirst: top === 0,
    row: (row, put) => {
      const radius = row === 0 ? top : bottom;
      for (let i = 0; i <= n; i++) {
        const [x, z] = [radius * sin[i]!, radius * cos[i]!];
        let [nx, ny, nz] = [across * sin[i]!, up, across * cos[i]!];
        if (radius === 0) {
          const middle = ((i - 0.5) / n) * 360;
          [nx, ny, nz] = exact
            ? [0, 0, 0]
            : [across * sinDegrees(middle), up, across * cosDegrees(middle)];
        }
        put(x, 0.5 - row, z, nx, ny, nz, i / n, 1 - row);
      }
    },
  };
}

function cap(n: number, radius: number, up: 1 | -1): Grid {
  const { cos, sin } = circle(n);
  const middle = up === 1 ? 0 : 1; // the row that is one point
  return {
    columns: n,
    rows: 1,
    corners: [0, 2, 1, 2, 3, 1],
    closedFirst: up === 1,
    closedLast: up === -1,
    row: (row, put) => {
      const r = row === middle ? 0 : 1;
      for (let i = 0; i <= n; i++) {
        const [c, s] = [r * cos[i]!, r * sin[i]!];
        put(radius * s, up / 2, radius * c, 0, up, 0, c / 2 + 0.5, (up * s) / 2 + 0.5);
      }
    },
  };
}

function torus(columns: number, out: number): BufferGeometry {
  const rows = Math.max(LEAST_TUBE, Math.round(columns / 2));
  const tube = TORUS_TUBE + out;
  const around = circle(columns);
  const across = circle(rows);
  return gridGeometry([
    {
      columns,
      rows,
      corners: [2, 0, 3, 0, 1, 3],
      row: (row, put) => {
        const [outward, z] = [across.cos[row]!, across.sin[row]!];
        for (let i = 0; i <= columns; i++) {
          const [c, s] = [around.cos[i]!, around.sin[i]!];
          const distance = TORUS_RING + tube * outward;
          const [nx, ny] = [outward * c, outward * s];
          put(distance * c, distance * s, tube * z, nx, ny, z, i / columns, row / rows);
        }
      },
    },
  ]);
}

// The torus knot with three.js's defaults: the strands do not touch.
const KNOT_RADIUS = 1;
const KNOT_TUBE = 0.4;

/**
 * Largest extent of the round knot in three.js's size, along y, and the centre of its box, which is
 * on the x axis.
 */
const KNOT_EXTENT = 3.62822984;
const KNOT_CENTER = 0.1588989;

/** How far ahead three.js looks for the knot's direction, in degrees of its own angle. */
const AHEAD = 1.8 / Math.PI;

/**
 * The (2, 3) torus knot: three.js's, moved and scaled so that the round shape fits the unit box.
 * `rows` along the knot, at least 32; those around the tube grow with them, from 8 on. `out`: how
 * far the vertices are outside the tube.
 */
function torusKnot(rows: number, out: number): BufferGeometry {
  const columns = Math.max(8, Math.round(rows / 8));
  const tube = KNOT_TUBE / KNOT_EXTENT + out;
  const { cos, sin } = circle(columns);
  return gridGeometry([
    {
      columns,
      rows,
      corners: [0, 2, 1, 2, 3, 1],
      row: (row, put) => {
        const angle = ((row % rows) / rows) * 720;
        const [x, y, z] = curve(angle);
        const next = curve(angle + AHEAD);
        const along = subtract(next, [x, y, z]);
        const sum: Vec3 = [next[0] + x, next[1] + y, next[2] + z];
        const B = normalize(cross(along, sum));
        const N = normalize(cross(B, along));
        for (let i = 0; i <= columns; i++) {
          const [cx, cy] = [-cos[i]!, sin[i]!];
          const nx = cx * N[0] + cy * B[0];
          const ny = cx * N[1] + cy * B[1];
          const nz = cx * N[2] + cy * B[2];
          const px = (x - KNOT_CENTER) / KNOT_EXTENT + tube * nx;
          const py = y / KNOT_EXTENT + tube * ny;
          const pz = z / KNOT_EXTENT + tube * nz;
          put(px, py, pz, nx, ny, nz, row / rows, i / columns);
        }
      },
    },
  ]);
}

/** The middle of the tube, in three.js's size. */
function curve(angle: number): Vec3 {
  const distance = KNOT_RADIUS * (2 + cosDegrees(1.5 * angle)) * 0.5;
  return [
    distance * cosDegrees(angle),
    distance * sinDegrees(angle),
    KNOT_RADIUS * sinDegrees(1.5 * angle) * 0.5,
  ];
}

const CORNER = Math.SQRT1_2 / 2;
const APEX: Vec3 = [0, 0.5, 0];
const FRONT_LEFT: Vec3 = [-CORNER, -0.5, CORNER];
const FRONT_RIGHT: Vec3 = [CORNER, -0.5, CORNER];
const BACK_RIGHT: Vec3 = [CORNER, -0.5, -CORNER];
const BACK_LEFT: Vec3 = [-CORNER, -0.5, -CORNER];

/** Counter-clockwise from outside: the four sides, then the two halves of the base. */
const PYRAMID: readonly (readonly [Vec3, Vec3, Vec3])[] = [
  [FRONT_LEFT, FRONT_RIGHT, APEX],
  [FRONT_RIGHT, BACK_RIGHT, APEX],
  [BACK_RIGHT, BACK_LEFT, APEX],
  [BACK_LEFT, FRONT_LEFT, APEX],
  [FRONT_LEFT, BACK_LEFT, BACK_RIGHT],
  [BACK_RIGHT, FRONT_RIGHT, FRONT_LEFT],
];

/**
 * Of height 1; the corners of its square base lie on a circle of diameter 1. Sides face the axes,
 * and each has its own vertices and normal. A triangle a b c is rows of n, n - 1, … small ones from
 * ab up to c.
 * @param n parts into which every edge is divided.
 */
function pyramid(n: number): BufferGeometry {
  const position: number[] = [];
  const normal: number[] = [];
  const uv: number[] = [];
  const index: number[] = [];
  let row = 0;
  for (const [a, b, c] of PYRAMID) {
    const N = normalize(cross(subtract(b, a), subtract(c, a)));
    for (let j = 0; j <= n; j += 1) {
      const v = j / n;
      const width = n - j;
      for (let i = 0; i <= width; i += 1) {
        const u = i / n;
        const w = (width - i) / n;
        for (const axis of [0, 1, 2] as const) {
          position.push(w * a[axis] + u * b[axis] + v * c[axis]);
        }
        normal.push(...N);
        uv.push(u + v / 2, v);
        if (i === width) continue;
        const here = row + i;
        const above = here + width + 1;
        index.push(here, here + 1, above);
        if (i + 1 < width) {
          index.push(here + 1, above + 1, above);
        }
      }
      row += width + 1;
    }
  }
  return indexedGeometry(
    index,
    new Float32Array(position),
    new Float32Array(normal),
    new Float32Array(uv),
  );
}
