// How does a light colour split into a colour to pick and an intensity, and back? 255 = full; intensity 1 is the picked colour
// itself. Numbers only: knows no controls and no elements.
import { LIMITS } from '../light/light-state.js';
import { sameValue } from '../fields/field-store.js';
import type { Vec3 } from '../math/vector.js';

export interface Tint {
  /** 0–255 per channel, not rounded. */
  readonly color: Vec3;
  /** >= 0. Colour times intensity is the value. */
  readonly intensity: number;
}

const BLACK: Vec3 = [0, 0, 0];
const WHITE: Vec3 = [255, 255, 255];

/**
 * Splits a value the way it was composed here, or so that the largest channel is full if it came from elsewhere. A value that
 * becomes black keeps the last colour, with intensity 0.
 */
export class ColorMix {
  #last: Tint | null = null;

  split(value: Vec3): Tint {
    if (this.#last !== null && sameValue(composed(this.#last), value)) return this.#last;
    const largest = Math.max(...value);
    if (largest === 0) return { color: this.#last?.color ?? BLACK, intensity: 0 };
    const full = (channel: number): number => (channel * 255) / largest;
    const tint: Tint = {
      color: [full(value[0]), full(value[1]), full(value[2])],
      intensity: largest / 255,
    };
    this.#last = tint;
    return tint;
  }

  /** The value with a new colour and the same intensity; intensity 1 if the value has always been black. */
  recolor(value: Vec3, color: Vec3): Vec3 {
    const { intensity } = this.split(value);
    return this.#compose({ color, intensity: this.#alwaysBlack(value) ? 1 : intensity });
  }

  /** The value with a new intensity and the same colour; white if the value has always been black. */
  intensify(value: Vec3, intensity: number): Vec3 {
    const { color } = this.split(value);
    return this.#compose({ color: this.#alwaysBlack(value) ? WHITE : color, intensity });
  }

  #alwaysBlack(value: Vec3): boolean {
    return this.#last === null && sameValue(value, BLACK);
  }

  #compose(tint: Tint): Vec3 {
    this.#last = tint;
    return composed(tint);
  }
}

/** Rounded to six digits: finer than any screen, and short in markup. */
function composed({ color, intensity }: Tint): Vec3 {
  const channel = (c: number): number => Math.min(Number((c * intensity).toPrecision(6)), LIMITS.color);
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
