// Which pose does a mesh's content show? That of an animation at a time, or its own. Knows neither clocks nor elements.
import type { Motion } from './content.js';
import type { ShapeValues } from './mesh-fields.js';
import { followPose, type Shown } from './parts.js';

type Values = Readonly<Pick<ShapeValues, 'autoplay' | 'animationName'>>;

export class MeshAnimation {
  readonly #shown: () => Shown;
  /** Empty for the first one; null for none. */
  #name: string | null = null;
  /** Since it began. */
  #seconds = 0;

  /** `shown` is the mesh's content. */
  constructor(shown: () => Shown) {
    this.#shown = shown;
  }

  /** Begins with a content to be shown, as the values say, before anything measures it: `auto` frames the first pose. */
  begin(values: Values, motion: Motion | null): void {
    this.#name = nameOf(values);
    this.#seconds = 0;
    if (this.#name !== null) motion?.pose(this.#name, 0);
  }

  /** Starts another animation, or ends the present one, if the values say so. */
  update(values: Values): void {
    if (nameOf(values) === this.#name) return;
    this.#name = nameOf(values);
    this.#seconds = 0;
    this.pose();
  }

  /** It would play if motion were allowed. */
  get plays(): boolean {
    const { motion } = this.#shown().content;
    return motion !== null && this.#name !== null && motion.durationOf(this.#name) > 0;
  }

  /** Plays on. False if nothing plays. */
  advance(seconds: number): boolean {
    if (!this.plays) return false;
    this.#seconds += seconds;
    if (seconds > 0) this.pose();
    return true;
  }

  /** Brings what is shown into the present pose. */
  pose(): void {
    const { content, parts } = this.#shown();
    if (content.motion === null) return;
    content.motion.pose(this.#name, this.#seconds);
    followPose(parts);
  }
}

const nameOf = ({ autoplay, animationName }: Values): string | null => (autoplay ? animationName : null);
