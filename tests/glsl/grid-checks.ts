// A grid's lists, which the shader finds by place, against the sum over all lights in float64.
import type { Box } from '../../src/phong/light/cull-lights.js';
import { divideLights } from '../../src/phong/light/light-grid.js';
import { emptyPack } from '../../src/phong/light/pack-lights.js';
import { subtract, type Vec3 } from '../../src/phong/math/vector.js';
import { lightWith } from '../stress/case.js';
import { float32, Random } from '../stress/random.js';
import type { Check } from './chunk-checks.js';
import { ANYWHERE, isAtEdge, packedFor, programOf, sumLaw } from './specialised-checks.js';

/** A floor with some height, so that cells have three sides. */
const FLOOR: Box = [-10, -0.5, -8, 10, 0.5, 8];

/** Spots down onto the floor, two of them onto all of it, lamps above it, and a sun. */
function lightsOverFloor() {
  const random = new Random(2);
  const colors = () => ({
    ambient: random.color(9),
    diffuse: random.color(99),
    specular: random.color(99),
  });
  const place = (): Vec3 => [random.from(-10, 10), random.from(1, 4), random.from(-8, 8)];
  const spots = Array.from({ length: 24 }, () =>
    lightWith({
      ...colors(),
      position: [...place(), 1],
      axis: subtract([0, -1, 0], random.vector(-0.3, 0.3)),
      aperture: random.from(10, 25),
      cutoff: random.pick([0, 2, 7.5]),
      attenuation: random.chance(0.5) ? [1, 0, 0] : [0.5, 0.2, 0.1],
    }),
  );
  const wide = [-5, 5].map((x) =>
    lightWith({ ...colors(), position: [x, 6, 0, 1], axis: [0, -1, 0], aperture: 85, cutoff: 2 }),
  );
  const lamps = Array.from({ length: 6 }, () =>
    lightWith({ ...colors(), position: [...place(), 1], attenuation: [1, 0, random.from(20, 60)] }),
  );
  const sun = lightWith({ ...colors(), position: [...random.unit(), 0] });
  return [sun, ...lamps, ...spots, ...wide];
}

export function gridCheck(): Check {
  const lights = lightsOverFloor();
  const into = emptyPack();
  if (!divideLights(packedFor(lights), FLOOR, into)) {
    throw new Error('these lights are not divided');
  }
  return {
    title: `lights in a grid add up to the reference’s sum, ${lights.length} lights`,
    ...programOf('grid', lights, into),
    glsl: ANYWHERE,
    inputs(random) {
      for (;;) {
        // The faces, and beyond them as far as rounding may take a fragment.
        const along = (k: 0 | 1 | 2) => {
          const [low, high] = [FLOOR[k], FLOOR[k + 3]!];
          const within = [random.from(low, high), random.from(low, high)];
          return random.pick([...within, low - 4e-6, low, high, high + 4e-6]);
        };
        const p = float32([along(0), along(1), along(2)]);
        if (lights.every((one) => !isAtEdge(one, p))) return [[...p], [...float32(random.unit())]];
      }
    },
    ...sumLaw(lights),
  };
}
