// Whether lights stand at a box: programs for lights that are known to be nowhere near it are spared what a light at a fragment
// needs. In shading space and float64, from the rows that the GLSL reads. Knows nothing of what lights bring.
import { HEADER, NEAREST, ROWS } from './light-layout.js';
import { type Box, ROUNDING } from './light-reach.js';
import type { PackedLights } from './pack-lights.js';

/** Whether every place of a light is outside the box, by more than float32 can hide. */
export function areApart({ data, counts, sent }: PackedLights, box: Box): boolean {
  const gap = (i: 0 | 1 | 2, place: number): number => {
    const slack = ROUNDING * (Math.abs(place) + Math.abs(box[i]) + Math.abs(box[i + 3]!));
    return Math.max(box[i] - place, place - box[i + 3]!) - slack;
  };
  let at = (HEADER.rows + counts.directional * ROWS.directional.rows) * 4;
  for (let i = counts.directional; i < sent; i++) {
    const widest = Math.max(gap(0, data[at]!), gap(1, data[at + 1]!), gap(2, data[at + 2]!));
    if (!(widest > NEAREST)) return false;
    at += (i < counts.directional + counts.point ? ROWS.point.rows : ROWS.spot.rows) * 4;
  }
  return true;
}
