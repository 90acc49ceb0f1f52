// Finds the lights that can reach a box. Only a spot's cone keeps light out exactly: attenuation never reaches 0. In
// shading space and float64, from the packed rows that the GLSL reads. Errs on the safe side: a culled light adds
// nothing to any point of the box.
import { Cone } from './cone.js';
import { HEADER, ROWS } from './light-layout.js';
import type { PackedLights } from './pack-lights.js';

/** Axis-aligned, in shading space: low x y z, high x y z. */
export type Box = readonly [number, number, number, number, number, number];

/**
 * Writes 1 into `mask` for every sent light that can reach the box, 0 for the others, and returns how many can. `mask`
 * has room for `packed.sent` lights.
 */
export function cullLights(packed: Readonly<PackedLights>, box: Box, mask: Uint8Array): number {
  const { directional, point } = packed.counts;
  const firstSpot = directional + point;
  mask.fill(1, 0, packed.sent);
  let count = packed.sent;
  let row = HEADER.rows + directional * ROWS.directional.rows + point * ROWS.point.rows;
  for (let light = firstSpot; light < packed.sent; light++, row += ROWS.spot.rows) {
    if (cone.read(packed, row).reaches(box[0], box[1], box[2], box[3], box[4], box[5])) continue;
    mask[light] = 0;
    count -= 1;
  }
  return count;
}

/** Reused from light to light. */
const cone = /* @__PURE__ */ new Cone();
