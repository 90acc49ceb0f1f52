// Is the closed form the average of a highlight over a pixel? Against many samples in float64: of a normal
// distribution, of a pixel's box, and of the lobe itself on spheres as they are seen.

import { describe, expect, it } from 'vitest';
import { add, cross, dot, normalize, scale, subtract, type Vec3 } from '../../src/math/vector.js';
import { closedAverage, type Form, lobe, moved, sampledAverage, type Sides } from '../glsl/filtered-lobe.js';
import { Random } from '../stress/random.js';

const SEED = 1;

/** Sides of any lengths and angle, parallel ones among them, around a mean `size`. */
function someSides(random: Random, size: number): Sides {
  const dx = scale(random.unit(), size * random.magnitude(0.2, 2));
  const aside = scale(random.unit(), size * random.magnitude(0.2, 2));
  return { dx, dy: random.pick([aside, scale(dx, random.from(-2, 2)), cross(dx, random.unit())]) };
}

/** Any e up to the distance at which the average is still above 0. */
const someE = (random: Random, { dx, dy }: Sides, n: number): Vec3 =>
  add(
    add(scale(dx, random.from(-1, 1)), scale(dy, random.from(-1, 1))),
    scale(random.unit(), random.from(0, 2) / Math.sqrt(n)),
  );

describe(`a filtered highlight (seed ${String(SEED)})`, () => {
  it('is the average of exp(-n|e|²/2) over normally distributed places, but for its flatness', () => {
    const random = new Random(SEED);
    let largest = 0;
    for (let i = 0; i < 60; i++) {
      const n = 1e8; // so large that (1 - y)^n is the exponential
      const sides = someSides(random, random.magnitude(0.1, 3) / Math.sqrt(n));
      const e = someE(random, sides, n);
      // Seven standard deviations to either side; a smooth function's trapezoids are exact to 1e-12.
      const reach = 7;
      const width = (2 * reach) / Math.sqrt(12);
      const weight = (u: number): number => Math.exp(-6 * u * u) * Math.sqrt(6 / Math.PI) * width;
      const sampled = sampledAverage(
        200,
        (u, v) => weight(u * width) * weight(v * width) * normal(moved(e, sides, u * width, v * width), n),
      );
      largest = Math.max(largest, Math.abs(closedAverage(e, sides, n, 'normal') - sampled));
    }
    // Measured: 2.7e-9, of (1 - y)^n beside the exponential.
    expect(largest).toBeLessThan(3e-9);
  });

  it('is the lobe itself where the pixel has no size', () => {
    const random = new Random(SEED);
    for (let i = 0; i < 1000; i++) {
      const n = random.magnitude(0.01, 1e6);
      const sides = someSides(random, random.pick([0, 1e-6 / Math.sqrt(n)]));
      const e = scale(random.unit(), random.from(0, 3) / Math.sqrt(n));
      expect(Math.abs(closedAverage(e, sides, n) - lobe(dot(e, e) / 2, n))).toBeLessThan(1e-11);
    }
  });

  it('comes nearer to the average over a pixel’s box than a normal distribution does', () => {
    const random = new Random(SEED);
    const off = { shipped: 0, normal: 0 };
    for (let i = 0; i < 400; i++) {
      const n = 1e8;
      const sides = someSides(random, random.magnitude(0.1, 20) / Math.sqrt(n));
      const e = someE(random, sides, n);
      const sampled = sampledAverage(120, (u, v) => normal(moved(e, sides, u, v), n));
      for (const form of ['shipped', 'normal'] as const)
        off[form] = Math.max(off[form], Math.abs(closedAverage(e, sides, n, form) - sampled));
    }
    // Measured: 0.0251 and 0.0547.
    expect(off.shipped).toBeLessThan(0.026);
    expect(off.normal).toBeGreaterThan(0.054);
  });
});

/** W at a place of a unit sphere that is seen from far away along z. */
function reflected(x: number, y: number): Vec3 | null {
  const square = x * x + y * y;
  if (square >= 1) return null;
  const N: Vec3 = [x, y, Math.sqrt(1 - square)];
  return subtract(scale(N, 2 * N[2]), [0, 0, 1]);
}

interface Off {
  max: number;
  squares: number;
  count: number;
}

/** Each form's error in 1/255 around the highlights of spheres of so many pixels, lit from so many directions. */
function errorsOnSpheres(diameter: number, n: number, lights: number) {
  const random = new Random(SEED);
  const r = diameter / 2;
  const errors: Record<Form | 'plain', Off> = {
    ...{ plain: none(), isotropic: none(), normal: none(), shipped: none() },
  };
  const W = (x: number, y: number): Vec3 => reflected(x / r, y / r)!;
  for (let light = 0; light < lights; light++) {
    const L = direction(random);
    const half = normalize(add(L, [0, 0, 1]));
    const at = [half[0] * r + random.from(-0.5, 0.5), half[1] * r + random.from(-0.5, 0.5)] as const;
    for (let i = -2; i <= 2; i++) {
      for (let k = -2; k <= 2; k++) {
        const [x, y] = [at[0] + i, at[1] + k];
        if (Math.hypot(Math.abs(x) + 1, Math.abs(y) + 1) >= r) continue; // inside, with its neighbours
        // So fine that the lobe is wider than the samples' distance.
        const samples = Math.min(Math.max(16, Math.ceil((4 * Math.sqrt(n)) / r)), 64);
        const truth = sampledAverage(samples, (u, v) => {
          const e = subtract(L, W(x + u, y + v));
          return lobe(dot(e, e) / 2, n);
        });
        const e = subtract(L, W(x, y));
        const sides = { dx: subtract(W(x + 1, y), W(x, y)), dy: subtract(W(x, y + 1), W(x, y)) };
        note(errors.plain, lobe(dot(e, e) / 2, n) - truth);
        for (const form of ['isotropic', 'normal', 'shipped'] as const)
          note(errors[form], closedAverage(e, sides, n, form) - truth);
      }
    }
  }
  return errors;
}

/** Up to 66° off the eye. */
function direction(random: Random): Vec3 {
  for (;;) {
    const L = random.unit();
    if (L[2] > 0.4) return L;
  }
}

const none = (): Off => ({ max: 0, squares: 0, count: 0 });

function note(off: Off, error: number): void {
  off.max = Math.max(off.max, Math.abs(error) * 255);
  off.squares += (error * 255) ** 2;
  off.count += 1;
}

const rmse = ({ squares, count }: Off): number => Math.sqrt(squares / count);

const normal = (e: Vec3, n: number): number => Math.exp((-n * dot(e, e)) / 2);

describe(`highlights of spheres (seed ${String(SEED)})`, () => {
  // Measured: the largest errors of the filtered highlight and of one sample a pixel.
  it.each([
    { diameter: 16, n: 100, filtered: 4.67, plain: 94.5 },
    { diameter: 40, n: 1e3, filtered: 5.34, plain: 127 },
    { diameter: 40, n: 3e3, filtered: 8.57, plain: 194 },
    { diameter: 40, n: 1e4, filtered: 4.92, plain: 215 },
    { diameter: 40, n: 1e5, filtered: 1.16, plain: 94 },
    { diameter: 120, n: 1e3, filtered: 0.33, plain: 22.7 },
    { diameter: 120, n: 1e4, filtered: 5.23, plain: 134 },
    { diameter: 120, n: 1e5, filtered: 4.57, plain: 214 },
  ])(
    'of $diameter pixels, exponent $n: within $filtered codes of 255, where one sample is $plain off',
    ({ diameter, n, filtered, plain }) => {
      const errors = errorsOnSpheres(diameter, n, 60);
      expect(errors.shipped.max).toBeLessThan(1.02 * filtered);
      expect(errors.plain.max).toBeGreaterThan(plain);
      // One width for all directions, or a normal distribution instead of a flat pixel, are farther off.
      for (const form of ['isotropic', 'normal'] as const) {
        expect(errors.shipped.max).toBeLessThan(errors[form].max);
        expect(rmse(errors.shipped)).toBeLessThan(0.8 * rmse(errors[form]));
      }
    },
  );
});
