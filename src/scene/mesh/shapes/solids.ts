// The less common shapes, in one chunk: separate chunks would be smaller than a request costs.
import { ConeGeometry, CylinderGeometry } from 'three';
import { gridGeometry, put, type Steps } from './grid-geometry.js';
import { pyramidGeometry } from './pyramid.js';
import { torusKnot } from './torus-knot.js';

// The ring's radius and the tube's add up to the outer radius 1/2.
const TORUS_RING = 0.35;
const TORUS_TUBE = 0.15;
/** Fewest segments round the tube that enclose it. */
const LEAST_TUBE = 3;

/** `out`: how far the vertices of a round shape are outside it. */
export const SOLIDS: Readonly<
  Record<'cylinder' | 'cone' | 'pyramid' | 'torus' | 'torus-knot', (segments: number, out: number) => Steps>
> = {
  *cylinder(n, out) {
    return new CylinderGeometry(0.5 + out, 0.5 + out, 1, n);
  },
  *cone(n, out) {
    return new ConeGeometry(0.5 + out, 1, n);
  },
  *pyramid(n) {
    return pyramidGeometry(n);
  },
  torus,
  'torus-knot': torusKnot,
};

/** As three.js's TorusGeometry. */
function torus(columns: number, out: number): Steps {
  const rows = Math.max(LEAST_TUBE, Math.round(columns / 2));
  const tube = TORUS_TUBE + out;
  const around = Array.from({ length: columns + 1 }, (_, i) => (i / columns) * Math.PI * 2);
  const cos = around.map(Math.cos);
  const sin = around.map(Math.sin);
  return gridGeometry([
    {
      ...{ columns, rows, corners: [2, 0, 3, 0, 1, 3] },
      row: (row, into, first) => {
        const v = (row / rows) * Math.PI * 2;
        const [outward, z] = [Math.cos(v), Math.sin(v)];
        for (let i = 0; i <= columns; i++) {
          const c = cos[i]!;
          const s = sin[i]!;
          const distance = TORUS_RING + tube * outward;
          const [nx, ny] = [outward * c, outward * s];
          put(into, first + i, distance * c, distance * s, tube * z, nx, ny, z, i / columns, row / rows);
        }
      },
    },
  ]);
}
