// How far have the animations of a picture's models played? One clock for all of them, which stands still while motion is not allowed.
// Knows neither models nor what allows motion.
import type { SceneMesh } from './mesh/scene-mesh.js';

export class Animations {
  readonly #meshes: ReadonlySet<SceneMesh>;
  /** Time of the last frame that moved something, in milliseconds; null after a pause. */
  #last: number | null = null;

  constructor(meshes: ReadonlySet<SceneMesh>) {
    this.#meshes = meshes;
  }

  /** An animation would play if motion were allowed. */
  get playing(): boolean {
    for (const { animation } of this.#meshes) if (animation.plays) return true;
    return false;
  }

  /** Plays on to the frame at `now`, in milliseconds. True while something plays. */
  step(now: number): boolean {
    const elapsed = this.#last === null ? 0 : (now - this.#last) / 1000;
    let plays = false;
    for (const { animation } of this.#meshes) if (animation.advance(elapsed)) plays = true;
    this.#last = plays ? now : null;
    return plays;
  }

  /** A pause: the time until the next {@link step} does not count. */
  rest(): void {
    this.#last = null;
  }
}
