// A specular lobe averaged over a pixel in float64: the closed form that the shader has, by another way (a 3 × 3
// covariance, inverted as it is), and the average itself, by many samples.
import { add, cross, dot, scale, subtract, type Vec3 } from '../../src/math/vector.js';

/** How e moves from one side of the pixel to the other. */
export interface Sides {
  readonly dx: Vec3;
  readonly dy: Vec3;
}

/**
 * `shipped`, or without what a pixel is flatter than a normal distribution, or with one mean width for all directions.
 */
export type Form = 'shipped' | 'normal' | 'isotropic';

/** (1 - |e|²/2)^n averaged over the pixel, by the closed form. */
export function closedAverage(e: Vec3, sides: Sides, n: number, form: Form = 'shipped'): number {
  const jx = scale(sides.dx, 1 / Math.sqrt(12));
  const jy = scale(sides.dy, 1 / Math.sqrt(12));
  if (form === 'isotropic') {
    const narrower = 1 / (1 + (n * (dot(jx, jx) + dot(jy, jy))) / 2);
    return lobe(dot(e, e) / 2, n * narrower) * narrower;
  }
  // nC, a unit matrix where the footprint is nothing.
  const row = (i: 0 | 1 | 2): Vec3 => [
    n * (jx[i] * jx[0] + jy[i] * jy[0]) + (i === 0 ? 1 : 0),
    n * (jx[i] * jx[1] + jy[i] * jy[1]) + (i === 1 ? 1 : 0),
    n * (jx[i] * jx[2] + jy[i] * jy[2]) + (i === 2 ? 1 : 0),
  ];
  const { solve, determinant } = inverse(row(0), row(1), row(2));
  const z = solve(e);
  const average = lobe(dot(e, z) / 2, n) / Math.sqrt(determinant);
  if (form === 'normal' || average === 0) return average;
  let flatness = 0;
  for (const j of [jx, jy]) {
    const s = n * dot(j, z);
    const q = n * dot(j, solve(j));
    flatness += s ** 4 - 6 * s * s * q + 3 * q * q;
  }
  return Math.min(Math.max(average * (1 - 0.05 * flatness), 0), 1);
}

/** (1 - y)^n; x^0 = 1, also below 1e-6. */
export const lobe = (y: number, n: number): number => {
  if (n < 1e-6) return 1;
  return y >= 1 ? 0 : Math.exp(n * Math.log1p(-y));
};

/** The mean of `value` over so many places along each side of the pixel, whose middle is 0, 0. */
export function sampledAverage(samples: number, value: (u: number, v: number) => number): number {
  let sum = 0;
  for (let i = 0; i < samples; i++)
    for (let k = 0; k < samples; k++) sum += value((i + 0.5) / samples - 0.5, (k + 0.5) / samples - 0.5);
  return sum / samples ** 2;
}

/** e at a place of the pixel. */
export const moved = (e: Vec3, { dx, dy }: Sides, u: number, v: number): Vec3 =>
  subtract(e, add(scale(dx, u), scale(dy, v)));

/** Of a symmetric matrix, by its rows. */
function inverse(a: Vec3, b: Vec3, c: Vec3) {
  const [bc, ca, ab] = [cross(b, c), cross(c, a), cross(a, b)];
  const determinant = dot(a, bc);
  const solve = (v: Vec3): Vec3 => scale([dot(bc, v), dot(ca, v), dot(ab, v)], 1 / determinant);
  return { solve, determinant };
}
