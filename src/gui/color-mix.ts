// How a colour maps to a picker, which ends at 255, and to a brightness, and back; 255 is full. A picked colour is the
// value itself; a value above 255 keeps its factor.
import { LIMITS } from '../light/light-state.js';
import { sameValue } from '../fields/field-store.js';
import type { Vec3 } from '../math/vector.js';

interface Tint {
  /** 0–255 per channel, not rounded. */
  readonly color: Vec3;
  /** 1, or more for values that are brighter than the picker can show. Colour times factor is the value. */
  readonly factor: number;
}

const WHITE: Vec3 = [255, 255, 255];

export class ColorMix {
  #picked: Tint | null = null;
  /** The last value that was not black. */
  #hue: Vec3 = WHITE;

  /** Splits a value the way it was picked here, or with the smallest factor if it came from elsewhere. */
  split(value: Vec3): Tint {
    if (this.#picked !== null && sameValue(times(this.#picked.color, this.#picked.factor), value)) return this.#picked;
    const factor = Math.max(brightnessOf(value), 1);
    const [r, g, b] = value;
    return { color: [r / factor, g / factor, b / factor], factor };
  }

  /** The value after picking a colour: the colour itself, or times the factor of a value above 255. */
  recolor(value: Vec3, color: Vec3): Vec3 {
    const picked = { color, factor: this.split(value).factor };
    this.#picked = picked;
    return times(color, picked.factor);
  }

  /** The value with another brightness and the same hue, also after it was black; white if it has always been black. */
  brighten(value: Vec3, brightness: number): Vec3 {
    if (brightnessOf(value) > 0) this.#hue = value;
    return times(this.#hue, brightness / brightnessOf(this.#hue));
  }
}

/** The largest channel; 1 is 255. */
export const brightnessOf = (value: Vec3): number => Math.max(...value) / 255;

/** Rounded to six digits: finer than any screen, and short in markup. Factor 1 changes nothing. */
function times(color: Vec3, factor: number): Vec3 {
  if (factor === 1) return color;
  const channel = (c: number): number => Math.min(Number((c * factor).toPrecision(6)), LIMITS.color);
  return [channel(color[0]), channel(color[1]), channel(color[2])];
}

/** `#rrggbb`, channels rounded and clamped. */
export const hexOf = (color: Vec3): string =>
  `#${color
    .map((c) =>
      Math.round(Math.min(Math.max(c, 0), 255))
        .toString(16)
        .padStart(2, '0'),
    )
    .join('')}`;

/** The channels of `#rrggbb`. */
export const colorOf = (hex: string): Vec3 => [
  parseInt(hex.slice(1, 3), 16),
  parseInt(hex.slice(3, 5), 16),
  parseInt(hex.slice(5, 7), 16),
];
