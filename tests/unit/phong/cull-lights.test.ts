// Is a light culled only where no point of the box is inside its cone, by the equation in float64,
// and nearly always where it could be? Each case is made from one seed, which a failure names.

import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type Box, cullLights } from '../../../src/phong/light/cull-lights.js';
import type { LightValues } from '../../../src/phong/light/light-state.js';
import { radians } from '../../../src/phong/math/angle.js';
import type { PackedLights } from '../../../src/phong/light/pack-lights.js';
import {
  add,
  cross,
  dot,
  length,
  normalize,
  scale,
  subtract,
  type Vec3,
} from '../../../src/phong/math/vector.js';
import { shade, type Surface } from '../../../src/phong/reference/equation.js';
import { fullOr } from '../../support/repeats.js';
import { Random } from '../../stress/random.js';
import { light } from '../arbitraries.js';
import { pack } from '../packed-reader.js';

/** Powers of ten from the smallest scene to the largest. */
const SIZES = [1e-9, 1e-3, 1, 1e6, 1e12] as const;

/** Apertures in degrees, beside those drawn from all. Narrower ones have tests of their own. */
const APERTURES = [1, 45, 89.999, 90, 90.001, 135, 179, 179.999, 180] as const;

/**
 * Distances of apexes from the box's middle, in radii of the box: inside, at a corner, far away.
 */
const AWAY = [0, 0.5, 1, 1.1, 2, 10, 100] as const;

/**
 * Where the cone's edge passes, in angles that the bounding sphere subtends: 0 through its middle,
 * 1 beside it, 3 far away.
 */
const GRAZES = [-1, 0, 0.5, 0.9, 1, 1.001, 1.1, 1.5, 3] as const;

interface BoxCase {
  readonly size: number;
  readonly middle: Vec3;
  /** Half of each side; 0 where the box is flat. */
  readonly half: Vec3;
}

function anyBox(random: Random, size = random.pick(SIZES)): BoxCase {
  const flat = random.chance(0.1);
  const side = () =>
    flat && random.chance(0.6) ? 0 : size * random.pick([1, random.magnitude(1e-4, 1)]);
  return {
    size,
    middle: scale(random.unit(), size * random.pick([0, 0.5, 3])),
    half: [side(), side(), side()],
  };
}

/** The box, grown on all sides by `margin`. */
function boxOf({ middle, half }: BoxCase, margin = 0): Box {
  const wide = add(half, [margin, margin, margin]);
  return [...subtract(middle, wide), ...add(middle, wide)];
}

interface ConeCase {
  readonly apex: Vec3;
  readonly axis: Vec3;
  /** Degrees. */
  readonly aperture: number;
}

/** `apart`: not at the box, if the box is a single point. */
function coneBy(random: Random, { middle, half, size }: BoxCase, apart = false) {
  const radius = length(half) === 0 ? size : length(half);
  const away = Math.max(random.pick(AWAY), apart && length(half) === 0 ? 0.5 : 0);
  const apex = add(middle, scale(random.unit(), radius * away));
  const aperture = random.chance(0.7) ? random.from(1, 180) : random.pick(APERTURES);
  const ball = away > 1 ? Math.asin(1 / away) : 1;
  const toMiddle = away === 0 ? random.unit() : normalize(subtract(middle, apex));
  const axis = random.around(toMiddle, (aperture * Math.PI) / 180 + random.pick(GRAZES) * ball);
  return { apex, axis, aperture };
}

/** Angle between the axis and the direction from the apex to p, in radians. */
function angleOf({ apex, axis }: ConeCase, p: Vec3) {
  const v = subtract(p, apex);
  return Math.atan2(length(cross(v, axis)), dot(v, axis));
}

/**
 * Points of a box: corners, middles of edges and sides, any others, and where the cone would be
 * entered first.
 */
function pointsOf(box: Box, cone: ConeCase, random: Random, count: number) {
  const [x0, y0, z0, x1, y1, z1] = box;
  const held = ([x, y, z]: Vec3): Vec3 => [
    Math.min(Math.max(x, x0), x1),
    Math.min(Math.max(y, y0), y1),
    Math.min(Math.max(z, z0), z1),
  ];
  const at = (i: number, j: number, k: number) =>
    held([x0 + i * (x1 - x0), y0 + j * (y1 - y0), z0 + k * (z1 - z0)]);
  const THREE = [0, 0.5, 1] as const;
  const points = THREE.flatMap((i) => THREE.flatMap((j) => THREE.map((k) => at(i, j, k))));
  while (points.length < count) {
    points.push(at(random.from(0, 1), random.from(0, 1), random.from(0, 1)));
  }
  points.push(held(cone.apex));
  // Descends to the smallest angle: random steps, shorter after each that brings no improvement.
  let best = points.reduce((a, b) => (angleOf(cone, a) <= angleOf(cone, b) ? a : b));
  for (let step = 0.5; step > 1e-7;) {
    const [i, j, k] = random.vector(-step, step);
    const moved = held(add(best, [i * (x1 - x0), j * (y1 - y0), k * (z1 - z0)]));
    if (angleOf(cone, moved) < angleOf(cone, best)) {
      points.push((best = moved));
    } else {
      step *= 0.9;
    }
  }
  return points;
}

const full = [255, 255, 255] as const;
const WHITE_SURFACE: Surface = { ka: full, kd: full, ks: full, shininess: 1 };

/** `mask`: 1 for each sent light that can reach the box. */
function cull(packed: PackedLights, box: Box) {
  const mask = new Uint8Array(packed.sent + 1).fill(7);
  const count = cullLights(packed, box, mask);
  return { mask: [...mask.subarray(0, packed.sent)], count };
}

/** A smaller seed makes no simpler case. */
const seeds = fc.noShrink(fc.integer({ min: 0, max: 0x7fffffff }));

const SEED = 1;

const bare = { diffuse: [255, 255, 255], specular: [255, 255, 255] } as const;

/** At the origin, along −z unless `values` turn it. */
const spotWith = (values: Partial<LightValues>) =>
  light({ ...bare, position: [0, 0, 0, 1], axis: [0, 0, -1], ...values });

const spotOf = (
  { apex, axis, aperture }: ConeCase,
  random: Random,
  values: Partial<LightValues> = {},
) =>
  spotWith({
    ...values,
    position: [...apex, 1],
    axis: scale(axis, random.pick([1, 1e-6, 1e9])),
    aperture,
  });

describe('a cone', () => {
  it.each([0, 1e-4, 1, 30, 45, 89, 90, 91, 135, 179])(
    'of %f° reaches a point at its edge, and none 2e-5 rad beyond it',
    (aperture) => {
      const slack = 2e-5;
      const at = (angle: number, d: number): Box => {
        const [x, z] = [d * Math.sin(angle), -d * Math.cos(angle)];
        return [x, 0, z, x, 0, z];
      };
      const packed = pack([spotWith({ aperture })]);
      for (const d of [1e-9, 1, 1e12]) {
        const edge = Math.max(radians(aperture), 1e-6);
        expect(cull(packed, at(edge, d)).count).toBe(1);
        expect(cull(packed, at(edge + 0.5 * slack, d)).count).toBe(1);
        expect(cull(packed, at(edge + slack, d)).count).toBe(0);
      }
    },
  );

  it.each([0, 1e-4, 0.01])(
    'of %f° is never culled for a point on its axis, in any direction',
    (aperture) => {
      const random = new Random(SEED);
      for (let i = 0; i < 300; i++) {
        const [place, axis] = [random.unit(), random.unit()];
        const spot = light({ ...bare, position: [...place, 1], axis, aperture });
        const [x, y, z] = add(place, scale(axis, random.magnitude(1e-3, 1e3)));
        expect(cull(pack([spot]), [x, y, z, x, y, z]).count).toBe(1);
      }
    },
  );

  it('is culled for a box right behind it, not for one about its apex, nor for a point so near that it has no direction', () => {
    const aside = spotWith({ position: [5, 5, 5, 1], aperture: 1 });
    expect(cull(pack([aside]), [4, 4, 4.5, 6, 6, 6.5]).count).toBe(1);
    expect(cull(pack([spotWith({ aperture: 1 })]), [-1, -1, 0.5, 1, 1, 2.5]).count).toBe(0);
    expect(cull(pack([spotWith({ aperture: 20 })]), [0, 0, 5e-16, 0, 0, 5e-16]).count).toBe(1);
  });

  it('is culled only where no point of the box is inside it, by the equation', () => {
    let cases = 0;
    let culled = 0;
    fc.assert(
      fc.property(seeds, (seed) => {
        const random = new Random(seed);
        const box = anyBox(random);
        for (let i = 0; i < 6; i++) {
          const cone = coneBy(random, box, true); // lights at a box of one point have a test of their own
          const spot = spotOf(cone, random, { ambient: random.color() });
          cases += 1;
          if (cull(pack([spot]), boxOf(box)).count > 0) continue;
          culled += 1;
          for (const point of pointsOf(boxOf(box), cone, random, 200)) {
            const fragment = {
              p: point,
              normal: random.unit(),
              eye: [0, 0, 4 * box.size],
            } as const;
            const { shares, sum } = shade(fragment, WHITE_SURFACE, [spot]);
            if (shares[0]!.insideCone) {
              expect.fail(`${point} is inside ${JSON.stringify(spot)}`);
            }
            expect(sum).toStrictEqual([0, 0, 0]);
          }
        }
      }),
      { seed: SEED, numRuns: fullOr(200, 40) },
    );
    expect(culled / cases).toBeGreaterThan(0.3); // 0.36 of these cones are culled
  });

  it('is culled in at least 98 of 100 cases where it misses the box by a tenth of its longest side', () => {
    let missing = 0;
    let culled = 0;
    const random = new Random(SEED);
    while (missing < fullOr(4000, 500)) {
      const box = anyBox(random, random.pick([1e-9, 1, 1e12]));
      const cone = coneBy(random, box);
      const grown = boxOf(box, 0.2 * Math.max(...box.half));
      if (
        pointsOf(grown, cone, random, 27).some((p) => angleOf(cone, p) <= radians(cone.aperture))
      ) {
        continue;
      }
      missing += 1;
      culled += 1 - cull(pack([spotOf(cone, random)]), boxOf(box)).count;
    }
    expect(culled / missing, `seed ${SEED}`).toBeGreaterThan(0.98); // measured: 0.994
  });
});

it('the mask has one number per light, in the order of the rows', () => {
  const spot = (x: number) =>
    light({ ...bare, axis: [0, -1, 0], aperture: 10, position: [x, 1, 0, 1] });
  const open = spotWith({ position: [0, 0, -9, 1], cutoff: 1e6 });
  const lamp = light({ ...bare, position: [9, 9, 9, 1], attenuation: [1e6, 1e6, 1e6] });
  const lights = [spot(0), light(), spot(5), lamp, spot(0.1), open];
  const { mask, count } = cull(pack(lights), [-0.1, 0, -0.1, 0.1, 0, 0.1]);
  // Directional, point, then the spots. One without a cone reaches what is behind it.
  expect(mask).toStrictEqual([1, 1, 1, 0, 1, 1]);
  expect(count).toBe(5);
});
