// Which colour stands for a number from 0 to 1? One sequential scale for the picture, the legend and the error's canvas. From dark blue
// to light yellow: lightness grows evenly, and the hues are two that colour-blind people tell apart. Knows no quantities.
import { srgbEncode } from '../../math/color.js';
import type { Vec3 } from '../../math/vector.js';

/** Oklab (Björn Ottosson, "A perceptual color space for image processing", 2020): lightness, green to red, blue to yellow. */
const LOW: Vec3 = [0.24, 0.005, -0.115];
const HIGH: Vec3 = [0.95, -0.015, 0.135];

/** Between these colours, linear in sRGB, the scale is within a code of Oklab's own line. */
const STEPS = 16;

/** Evenly spaced from 0 to 1; sRGB, whole codes of 255. */
export const SCALE_CODES: readonly Vec3[] = Array.from({ length: STEPS + 1 }, (_, i) => oklab(i / STEPS));

/** The colour for t, which is clamped to 0–1. sRGB, 0–1. */
export function scaleColor(t: number): Vec3 {
  const at = Math.min(Math.max(t, 0), 1) * STEPS;
  const low = Math.min(Math.floor(at), STEPS - 1);
  const [a, b] = [SCALE_CODES[low]!, SCALE_CODES[low + 1]!];
  const mix = (i: 0 | 1 | 2): number => (a[i] + (b[i] - a[i]) * (at - low)) / 255;
  return [mix(0), mix(1), mix(2)];
}

function oklab(t: number): Vec3 {
  const at = (i: 0 | 1 | 2): number => LOW[i] + (HIGH[i] - LOW[i]) * t;
  const [lightness, a, b] = [at(0), at(1), at(2)];
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  const code = (linear: number): number => Math.round(255 * Math.min(Math.max(srgbEncode(linear), 0), 1));
  return [
    code(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
    code(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
    code(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
  ];
}
