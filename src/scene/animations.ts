// The time that the animations of a picture's models have played. One clock for all of them, which stands still while
// motion is not allowed.

/** What can play an animation. */
export interface Animated {
  /** It would play if motion were allowed. */
  readonly plays: boolean;
  /** Plays on. */
  advance(seconds: number): void;
}

export class Animations {
  /** Few meshes can move: a frame does not look at the others. */
  readonly #all = new Set<Animated>();
  /** Time of the last frame that moved something, in milliseconds; null after a pause. */
  #last: number | null = null;

  add(animated: Animated): void {
    this.#all.add(animated);
  }

  delete(animated: Animated): void {
    this.#all.delete(animated);
  }

  /** An animation would play if motion were allowed. */
  get playing(): boolean {
    for (const { plays } of this.#all) if (plays) return true;
    return false;
  }

  /** Plays on to the frame at `now`, in milliseconds. True while something plays. */
  step(now: number): boolean {
    const elapsed = this.#last === null ? 0 : (now - this.#last) / 1000;
    const { playing } = this;
    for (const animated of this.#all) if (animated.plays) animated.advance(elapsed);
    this.#last = playing ? now : null;
    return playing;
  }

  /** A pause: the time until the next {@link step} does not count. */
  rest(): void {
    this.#last = null;
  }
}
