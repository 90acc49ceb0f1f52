// The pose that a mesh's content shows: that of an animation at a time, or its own.
import type { Motion } from '../../model/content.js';
import type { ShapeValues } from './mesh-fields.js';

type Values = Readonly<Pick<ShapeValues, 'autoplay' | 'animationName'>>;

export class MeshAnimation {
  readonly #motion: Motion;
  /** Empty for the first one; null for none. */
  #name: string | null;
  /** Since it began. */
  #seconds = 0;

  /** Begins as the values say, before anything measures the content: `auto` frames the first pose. */
  constructor(motion: Motion, values: Values) {
    this.#motion = motion;
    this.#name = nameOf(values);
    if (this.#name !== null) this.pose();
  }

  /** Starts another animation, or ends the present one, if the values say so. True if the pose has changed. */
  update(values: Values): boolean {
    if (nameOf(values) === this.#name) return false;
    this.#name = nameOf(values);
    this.#seconds = 0;
    this.pose();
    return true;
  }

  /** It would play if motion were allowed. */
  get plays(): boolean {
    return this.#name !== null && this.#motion.durationOf(this.#name) > 0;
  }

  /** Plays on. */
  advance(seconds: number): void {
    this.#seconds += seconds;
    if (seconds > 0) this.pose();
  }

  /** Writes the present pose into the content. */
  pose(): void {
    this.#motion.pose(this.#name, this.#seconds);
  }
}

const nameOf = ({ autoplay, animationName }: Values): string | null => (autoplay ? animationName : null);
