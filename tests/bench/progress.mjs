// @ts-check
// How far a run of many parts is and how long it still takes, from the durations of its parts so far. Milliseconds.

export class Progress {
  /** @type {readonly string[]} */
  #parts;
  /** @type {Map<string, number[]>} */
  #durations = new Map();
  #done = 0;

  /** @param {readonly string[]} parts names in order; a name that occurs again takes as long as before */
  constructor(parts) {
    this.#parts = parts;
  }

  /** The next part has ended. @param {number} ms */
  finish(ms) {
    const name = this.#parts[this.#done] ?? '';
    this.#durations.set(name, [...(this.#durations.get(name) ?? []), ms]);
    this.#done += 1;
  }

  /** Estimate of a part: its own average, or the average of all. @param {string} name */
  estimate(name) {
    return mean(this.#durations.get(name) ?? [...this.#durations.values()].flat());
  }

  /** Estimate of what is left; 0 before the first part has ended. */
  get left() {
    return this.#parts.slice(this.#done).reduce((sum, name) => sum + this.estimate(name), 0);
  }

  /** Such as `[3/70, about 12 min left]`. */
  toString() {
    const minutes = this.left / 60_000;
    const left = minutes < 1 ? 'under 1 min' : `about ${Math.round(minutes)} min`;
    return `[${this.#done}/${this.#parts.length}${this.#done > 0 ? `, ${left} left` : ''}]`;
  }
}

/** @param {readonly number[]} numbers */
const mean = (numbers) =>
  numbers.length === 0 ? 0 : numbers.reduce((sum, x) => sum + x, 0) / numbers.length;
