// Colours that can be seen on any picture. A light core with a black outline: one of the two always has a contrast of
// 3:1 with what lies behind (WCAG 2.2, success criterion 1.4.11). Channels from 0 to 1.
import { srgbDecode } from '../../math/color.js';
import { dot, map, type Vec3 } from '../../math/vector.js';

/** The outline of everything. */
export const HALO = '#000';

/**
 * Relative luminance of a core. Backgrounds from 0.1 on have 3:1 with the black outline, darker ones with a core of at
 * least 3 · (0.1 + 0.05) − 0.05 = 0.4, and a little for rounding to 8 bits.
 */
const CORE = 0.41;

/** WCAG's weights of the linear channels. */
const LUMINANCE: Vec3 = [0.2126, 0.7152, 0.0722];

export const luminance = (color: Vec3): number => dot(LUMINANCE, map(color, srgbDecode));

/** The colour itself if it is light enough to be a core, else its mixture with as little white as that takes. */
export function coreColor(color: Vec3): Vec3 {
  const largest = Math.max(...color, 1);
  const shown = map(color, (c) => c / largest);
  if (luminance(shown) >= CORE) return shown;
  let [dark, light] = [0, 1];
  // Ten halvings are finer than a code of 8 bits.
  for (let i = 0; i < 10; i++) {
    const middle = (dark + light) / 2;
    if (luminance(whitened(shown, middle)) >= CORE) light = middle;
    else dark = middle;
  }
  return whitened(shown, light);
}

const whitened = (color: Vec3, share: number): Vec3 => map(color, (c) => c + (1 - c) * share);

/** `rgb(…)` of channels from 0 to 1; larger ones keep their ratios. */
export function cssRgb(color: Vec3): string {
  const largest = Math.max(...color, 1);
  return `rgb(${color.map((c) => Math.round((255 * c) / largest)).join(' ')})`;
}
