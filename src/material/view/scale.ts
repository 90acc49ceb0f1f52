// The colour that stands for a number from 0 to 1. One sequential scale for the picture, the legend and the error's
// canvas. From dark blue to light yellow: lightness grows evenly, and colour-blind people tell the two hues apart.
import type { Vec3 } from '../../math/vector.js';

/**
 * Coefficients of 1, t and t²: sRGB within 10 codes of the straight line in Oklab from (0.24, 0.005, -0.115) to (0.95,
 * -0.015, 0.135) (Björn Ottosson, "A perceptual color space for image processing", 2020). A shader computes it faster
 * than it reads a table.
 */
const COEFFICIENTS: readonly [Vec3, Vec3, Vec3] = [
  [0.05, 0.085, 0.33],
  [0.77, 0.82, 0.41],
  [0.18, 0.03, -0.24],
];

/** The colour for t, which is clamped to 0–1. sRGB, 0–1. */
export function scaleColor(t: number): Vec3 {
  const x = Math.min(Math.max(t, 0), 1);
  const [a, b, c] = COEFFICIENTS;
  const channel = (i: 0 | 1 | 2): number => a[i] + x * (b[i] + x * c[i]);
  return [channel(0), channel(1), channel(2)];
}

/** The same as a GLSL expression of `t`. */
export const SCALE_GLSL = ((): string => {
  const [a, b, c] = COEFFICIENTS.map((v) => `vec3(${v.join()})`);
  return `(${a!}+t*(${b!}+t*${c!}))`;
})();
