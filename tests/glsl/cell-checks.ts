// Lights in cells, whose lists the shader finds by place, and lights that are known to stand nowhere near: against the sum over all of
// them in float64. What exact programs with cells and LIGHTS_APART have.
import { divide } from '../../src/light/light-grid.js';
import type { Box } from '../../src/light/cull-lights.js';
import type { LightValues } from '../../src/light/light-state.js';
import { emptyPack, packLights } from '../../src/light/pack-lights.js';
import { ALL_TERMS, inCells } from '../../src/material/exact-lights.js';
import { subtract, type Vec3 } from '../../src/math/vector.js';
import { shade } from '../../src/reference/equation.js';
import { float32, Random } from '../stress/random.js';
import type { Check } from './chunk-checks.js';
import { ALL, allLights, ANYWHERE, EYE, isAtEdge, light, sumsOf, SURFACE } from './exact-checks.js';

/** A floor with some height, so that cells have three sides. */
const FLOOR: Box = [-10, -0.5, -8, 10, 0.5, 8];

/** Spots down onto the floor, two of them onto all of it, lamps that fade above it, and a sun. */
function lightsOverFloor(): LightValues[] {
  const random = new Random(2);
  const colors = () => ({ ambient: random.color(9), diffuse: random.color(99), specular: random.color(99) });
  const place = (): Vec3 => [random.from(-10, 10), random.from(1, 4), random.from(-8, 8)];
  const spots = Array.from({ length: 24 }, () =>
    light({
      ...colors(),
      position: [...place(), 1],
      axis: subtract([0, -1, 0], random.vector(-0.3, 0.3)),
      aperture: random.from(10, 25),
      cutoff: random.pick([0, 2, 7.5]),
      attenuation: random.pick([
        [1, 0, 0],
        [0.5, 0.2, 0.1],
      ]),
    }),
  );
  const wide = [-5, 5].map((x) =>
    light({ ...colors(), position: [x, 6, 0, 1], axis: [0, -1, 0], aperture: 85, cutoff: 2 }),
  );
  const lamps = Array.from({ length: 6 }, () =>
    light({ ...colors(), position: [...place(), 1], attenuation: [1, 0, random.from(20, 60)] }),
  );
  const suns = Array.from({ length: 1 }, () => light({ ...colors(), position: [...random.unit(), 0] }));
  return [...suns, ...lamps, ...spots, ...wide];
}

/** @param budget 1 being full: what lists may leave out. */
function cells(title: string, budget: number, bound: number): Check {
  const lights = lightsOverFloor();
  const packed = emptyPack();
  const identity = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  packLights(lights, { worldToShading: identity, cameraToShading: identity, linear: false }, packed);
  const into = emptyPack();
  const white = [1, 1, 1] as const;
  if (!divide(packed, FLOOR, { ka: white, kd: white, ks: white }, budget, into))
    throw new Error('these lights are not divided');
  return {
    title: `${title}, ${lights.length} lights`,
    defines: [`LIGHT_STATEMENTS ${inCells(into, ALL_TERMS)}`, 'HAS_AMBIENT', 'HAS_DIFFUSE', 'HAS_SPECULAR'],
    rows: ROWS_BY_TABLE,
    table: into.data.subarray(0, into.rows * 4),
    glsl: ANYWHERE,
    inputs(random) {
      for (;;) {
        // The faces, and beyond them as far as rounding may take a fragment.
        const along = (k: 0 | 1 | 2): number => {
          const [low, high] = [FLOOR[k], FLOOR[k + 3]!];
          return random.pick([
            random.from(low, high),
            random.from(low, high),
            low - 4e-6,
            low,
            high,
            high + 4e-6,
          ]);
        };
        const p = float32([along(0), along(1), along(2)]);
        if (lights.every((one) => !isAtEdge(one, p))) return [[...p], [...float32(random.unit())]];
      }
    },
    expected: ([x, y, z], N) => {
      const fragment = { p: [x!, y!, z!] as Vec3, normal: N as unknown as Vec3, eye: EYE };
      return shade(fragment, SURFACE, lights).sum;
    },
    bound,
    floor: 1,
  };
}

const ROWS_BY_TABLE = `
uniform sampler2D u_table;
vec4 lightRow(int i) { return texelFetch(u_table, ivec2(i & 255, i >> 8), 0); }
`;

export const cellChecks = (every = 1): readonly Check[] => [
  cells('lights in cells add up to the reference’s sum', 0, 2e-5), // as of all exact lights
  cells(
    'lights in cells that may leave a code out add up to the reference’s sum but for little',
    1 / 255,
    3e-4, // measured 2.3e-4: less than lists may
  ),
  sumsOf(
    'in loops',
    ALL,
    allLights().filter((_, i) => i % every === 0),
    'LIGHTS_APART',
  ),
];
