// The one clock of the animations of a picture.
import { LIMITS } from '../../../phong/model/limits.js';
import type { PlayedAnimation } from '../../../phong/model/model.js';

/**
 * The time that all animations of a picture have played. It stands still while motion is not
 * allowed.
 */
export class Animations {
  /** The animations of meshes whose content moves. A frame does not visit other meshes. */
  readonly all = new Set<Pick<PlayedAnimation, 'plays' | 'work' | 'advance'>>();
  /** Time of the last frame that moved something, in milliseconds; null after a pause. */
  #last: number | null = null;
  #warned = false;

  get playing(): boolean {
    for (const { plays } of this.all) {
      if (plays) return true;
    }
    return false;
  }

  /** Plays on to the frame at `now`, in milliseconds. True while something plays. */
  step(now: number): boolean {
    const elapsed = this.#last === null ? 0 : (now - this.#last) / 1000;
    const { playing } = this;
    let work = 0;
    for (const animation of this.all) {
      if (!animation.plays) continue;
      work += animation.work;
      if (work <= LIMITS.pose) {
        animation.advance(elapsed);
      } else if (!this.#warned) {
        this.#warned = true;
        console.warn(
          `Not all animations play: the poses of a frame take at most ${LIMITS.pose.toLocaleString('en')} steps.`,
        );
      }
    }
    this.#last = playing ? now : null;
    return playing;
  }

  /** A pause: the time until the next {@link step} does not count. */
  rest(): void {
    this.#last = null;
  }
}
