// Is the bound of what one light can bring tight where it should be, by the equation in float64?

import { describe, expect, it } from 'vitest';
import { Cone } from '../../src/light/cone.js';
import { HEADER } from '../../src/light/light-layout.js';
import { mostOf } from '../../src/light/cull-lights.js';
import { normalize, scale, subtract } from '../../src/math/vector.js';
import { Random } from '../stress/random.js';
import { light } from './arbitraries.js';
import { pack } from './packed-reader.js';
import { anyView, shadeAt, WHITE } from './reach-cases.js';

describe('the most that a light can bring to one point', () => {
  const SEED = 1;
  // Rounding places and axes to float32 turns them by some 1e-7 rad, which the cutoff multiplies. Measured: 3e-8, 5e-8, 1.4e-6.
  it.each([
    [0, 1e-7],
    [3, 1e-7],
    [64, 3e-6],
  ])(
    'is what it does bring where it falls straight and is seen in its mirror, at cutoff %d',
    (cutoff, slack) => {
      const random = new Random(SEED);
      for (let i = 0; i < 1000; i++) {
        const apex = scale(random.unit(), random.magnitude(0.01, 10));
        const axis = random.around(normalize(subtract([0, 0, 0], apex)), random.from(0, 1));
        const spot = light({
          position: [...apex, 1],
          ambient: [20, 0, 90],
          attenuation: [1, 1, 3],
          axis,
          aperture: 170,
          cutoff,
        });
        const packed = pack([spot]);
        const cone = new Cone().take(packed, HEADER.rows);
        const bound = mostOf(packed, HEADER.rows, packed.shapes[0]!, cone, [0, 0, 0, 0, 0, 0], WHITE);
        const view = { ...anyView(random, 0), origin: [0, 0, 0], eye: normalize(apex) } as const;
        const { sum } = shadeAt([0, 0, 0], normalize(apex), [spot], view);
        for (const c of [0, 1, 2] as const) {
          const share = sum[c] / bound[c];
          expect(share, `seed ${String(SEED)}, case ${String(i)}`).toBeLessThan(1 + slack);
          expect(share, `seed ${String(SEED)}, case ${String(i)}`).toBeGreaterThan(1 - 1e-5 * (1 + cutoff));
        }
      }
    },
  );
});
