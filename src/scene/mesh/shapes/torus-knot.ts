// The (2, 3) torus knot: three.js's, moved and scaled so that the round shape fits the unit box.
import { cross, normalize, subtract, type Vec3 } from '../../../math/vector.js';
import { circle, gridGeometry, put } from './grid-geometry.js';
import type { BufferGeometry } from 'three';

// three.js's defaults: the strands do not touch.
const RADIUS = 1;
const TUBE = 0.4;

/** Largest extent of the round knot in three.js's size, along y, and the centre of its box, which is on the x axis. */
const EXTENT = 3.62822984;
const CENTER = 0.1588989;

/** How far ahead three.js looks for the knot's direction, in radians of its own angle. */
const AHEAD = 0.01;

/**
 * @param rows along the knot, at least 32; those around the tube grow with them, from 8 on.
 * @param out how far the vertices are outside the tube.
 */
export function torusKnot(rows: number, out: number): BufferGeometry {
  const columns = Math.max(8, Math.round(rows / 8));
  const tube = TUBE / EXTENT + out;
  const { cos, sin } = circle(columns);
  return gridGeometry([
    {
      ...{ columns, rows, corners: [0, 2, 1, 2, 3, 1] },
      row: (row, into, first) => {
        const angle = ((row % rows) / rows) * 4 * Math.PI;
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
          const px = (x - CENTER) / EXTENT + tube * nx;
          const py = y / EXTENT + tube * ny;
          const pz = z / EXTENT + tube * nz;
          put(into, first + i, px, py, pz, nx, ny, nz, row / rows, i / columns);
        }
      },
    },
  ]);
}

/** The middle of the tube, in three.js's size. */
function curve(angle: number): Vec3 {
  const distance = RADIUS * (2 + Math.cos(1.5 * angle)) * 0.5;
  return [distance * Math.cos(angle), distance * Math.sin(angle), RADIUS * Math.sin(1.5 * angle) * 0.5];
}
