// Climbs to a category's largest error: the worst cases so far, changed a little, are tried again.
// A case is the list of random numbers that it was made from, so every category can be searched.
import { Random } from './random.js';

interface Found {
  readonly numbers: readonly number[];
  readonly error: number;
}

/** So many of the worst cases are changed further: one alone ends on the nearest hill. */
const KEPT = 8;

export class Search {
  #worst: Found[] = [];
  readonly #random: Random;

  constructor(seed: number) {
    this.#random = new Random(seed);
  }

  /** A case that was tried, and its largest error in any program. */
  add(numbers: readonly number[], error: number): void {
    if (this.#worst.length === KEPT && error <= this.#worst.at(-1)!.error) return;
    this.#worst.push({ numbers, error });
    this.#worst.sort((a, b) => b.error - a.error);
    this.#worst.length = Math.min(this.#worst.length, KEPT);
  }

  /** The numbers of a case to try next; none, so that all are new, where nothing was found yet. */
  next(): number[] {
    const random = this.#random;
    if (this.#worst.length === 0) return [];
    const { numbers } = random.pick(this.#worst);
    // One or two of its numbers change a little: how a case is made stays, what is rounded changes.
    const always = Math.floor(random.from(0, numbers.length));
    return numbers.map((x, i) => {
      if (i !== always && !random.chance(0.5 / numbers.length)) return x;
      const moved = x + random.sign() * random.magnitude(1e-8, 0.1);
      return moved - Math.floor(moved);
    });
  }
}
