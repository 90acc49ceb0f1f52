// Random numbers from a seed, in the shapes that adversarial cases need. Everything that goes to
// the GPU as a float32 is rounded here, so that reference and shader are given the same input.
import { add, cross, normalize, scale, type Vec3 } from '../../src/phong/math/vector.js';
import { hashOf } from '../support/hash.mjs';

export class Random {
  readonly #next: () => number;

  /** @param next uniform numbers in [0, 1) */
  constructor(seed: number, next = sfc32(seed)) {
    this.#next = next;
  }

  /** In [low, high). */
  from(low: number, high: number): number {
    return low + (high - low) * this.#next();
  }

  /** Every order of magnitude between low and high alike; both > 0. */
  magnitude(low: number, high: number): number {
    return low * (high / low) ** this.#next();
  }

  chance(share: number): boolean {
    return this.#next() < share;
  }

  pick<T>(list: readonly T[]): T {
    return list[Math.floor(this.#next() * list.length)]!;
  }

  sign(): 1 | -1 {
    return this.#next() < 0.5 ? -1 : 1;
  }

  vector(low: number, high: number): Vec3 {
    return [this.from(low, high), this.from(low, high), this.from(low, high)];
  }

  /** A direction, all alike. */
  unit(): Vec3 {
    for (;;) {
      const v = this.vector(-1, 1);
      const squared = v[0] ** 2 + v[1] ** 2 + v[2] ** 2;
      if (squared > 1e-3 && squared <= 1) return normalize(v);
    }
  }

  /** A unit vector at this angle, in radians, from the unit vector `axis`; on any side of it. */
  around(axis: Vec3, angle: number): Vec3 {
    const side = normalize(cross(axis, this.#across(axis)));
    return normalize(add(scale(axis, Math.cos(angle)), scale(side, Math.sin(angle))));
  }

  /** A unit vector that is not along `axis`. */
  #across(axis: Vec3) {
    for (;;) {
      const v = this.unit();
      const c = v[0] * axis[0] + v[1] * axis[1] + v[2] * axis[2];
      if (Math.abs(c) < 0.99) return v;
    }
  }

  /** Grey or coloured, channels to `high`. */
  color(high = 255): Vec3 {
    return this.chance(0.3) ? [high, high, high] : this.vector(0, high);
  }
}

/**
 * The numbers of a list, in order, and new ones beyond its end, which are added to it: whatever was
 * made from them can be made again, or a little differently.
 */
export function replayed(list: number[], seed: number): Random {
  const next = sfc32(seed);
  let at = 0;
  return new Random(seed, () => {
    if (at === list.length) {
      list.push(next());
    }
    return list[at++]!;
  });
}

/**
 * Uniform numbers in [0, 1): Chris Doty-Humphrey's sfc32 (PractRand). Its 128 bits of state do not
 * come round in the billions of numbers of a long run, as those of a 32-bit generator do.
 */
function sfc32(seed: number) {
  let [a, b, c, counter] = [0, seed | 0, 0, 1];
  const next = () => {
    const t = (a + b + counter) | 0;
    counter = (counter + 1) | 0;
    a = b ^ (b >>> 9);
    b = (c + (c << 3)) | 0;
    c = (((c << 21) | (c >>> 11)) + t) | 0;
    return (t >>> 0) / 2 ** 32;
  };
  for (let i = 0; i < 12; i++) {
    next(); // until the seed is in all of the state
  }
  return next;
}

/** The nearest float32 of each component. */
export const float32 = (v: Vec3): Vec3 => [Math.fround(v[0]), Math.fround(v[1]), Math.fround(v[2])];

/** A seed for a part of a run: another for every part, the same in every run with this seed. */
export const partSeed = (seed: number, part: string): number => hashOf(part, seed);
