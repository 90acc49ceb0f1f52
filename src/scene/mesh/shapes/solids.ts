// The less common shapes, in one chunk: separate chunks would be smaller than a request costs.
import type { BufferGeometry } from 'three';
import { circle, type Grid, gridGeometry, put } from './grid-geometry.js';
import { pyramidGeometry } from './pyramid.js';
import { torusKnot } from './torus-knot.js';

// The ring's radius and the tube's add up to the outer radius 1/2.
const TORUS_RING = 0.35;
const TORUS_TUBE = 0.15;
/** Fewest segments round the tube that enclose it. */
const LEAST_TUBE = 3;

type Solid = (segments: number, out: number, isLevel: boolean) => BufferGeometry;

/** `out`: how far the vertices of a round shape are outside it. `isLevel`: of `segments="auto"`. */
export const SOLIDS: Readonly<Record<'cylinder' | 'cone' | 'pyramid' | 'torus' | 'torus-knot', Solid>> = {
  cylinder: (n, out) => gridGeometry([cap(n, 0.5 + out, 1), side(n, 0.5 + out, 0.5 + out), cap(n, 0.5 + out, -1)]),
  cone: (n, out, isLevel) => gridGeometry([side(n, 0, 0.5 + out, isLevel), cap(n, 0.5 + out, -1)]),
  pyramid: (n) => pyramidGeometry(n),
  torus,
  'torus-knot': torusKnot,
};

/**
 * What lies between the circles of radius `top` and `bottom`, 1 apart. `top` 0 is a cone's tip, where a triangle has
 * one normal: the one in its middle; or, if `exact`, none, and the normals of the base alone are mixed by the distance
 * from the tip. That is the round cone's normal in every point of the triangle.
 */
function side(n: number, top: number, bottom: number, exact = false): Grid {
  const { cos, sin } = circle(n);
  const slope = top === bottom ? 0 : 0.5;
  const across = 1 / Math.hypot(1, slope);
  const up = slope * across;
  return {
    ...{ columns: n, rows: 1, corners: [0, 2, 1, 2, 3, 1], closedFirst: top === 0 },
    row: (row, into, first) => {
      const radius = row === 0 ? top : bottom;
      for (let i = 0; i <= n; i++) {
        const [x, z] = [radius * sin[i]!, radius * cos[i]!];
        let [nx, ny, nz] = [across * sin[i]!, up, across * cos[i]!];
        if (radius === 0) {
          const middle = ((i - 0.5) / n) * Math.PI * 2;
          [nx, ny, nz] = exact ? [0, 0, 0] : [across * Math.sin(middle), up, across * Math.cos(middle)];
        }
        put(into, first + i, x, 0.5 - row, z, nx, ny, nz, i / n, 1 - row);
      }
    },
  };
}

/** A flat end, whose normal points up or down. */
function cap(n: number, radius: number, up: 1 | -1): Grid {
  const { cos, sin } = circle(n);
  const middle = up === 1 ? 0 : 1; // the row that is one point
  return {
    ...{ columns: n, rows: 1, corners: [0, 2, 1, 2, 3, 1], closedFirst: up === 1, closedLast: up === -1 },
    row: (row, into, first) => {
      const r = row === middle ? 0 : 1;
      for (let i = 0; i <= n; i++) {
        const [c, s] = [r * cos[i]!, r * sin[i]!];
        put(into, first + i, radius * s, up / 2, radius * c, 0, up, 0, c / 2 + 0.5, (up * s) / 2 + 0.5);
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
      ...{ columns, rows, corners: [2, 0, 3, 0, 1, 3] },
      row: (row, into, first) => {
        const [outward, z] = [across.cos[row]!, across.sin[row]!];
        for (let i = 0; i <= columns; i++) {
          const [c, s] = [around.cos[i]!, around.sin[i]!];
          const distance = TORUS_RING + tube * outward;
          const [nx, ny] = [outward * c, outward * s];
          put(into, first + i, distance * c, distance * s, tube * z, nx, ny, z, i / columns, row / rows);
        }
      },
    },
  ]);
}
