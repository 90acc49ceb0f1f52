// The poses that meshes show, and the one clock of the animations of a picture.
import { LIMITS } from '../../../phong/model/limits.js';
import type { GeometrySize } from '../../../phong/geometry/geometry-size.js';
import type { Motion } from '../../../phong/model/model.js';
import type { ShapeValues } from '../../../phong/model/mesh-fields.js';

type Values = Readonly<Pick<ShapeValues, 'autoplay' | 'animationName'>>;

/** The pose that a mesh's content shows: that of an animation at a time, or its own. */
export class MeshAnimation {
  readonly #motion: Motion;
  /** Empty for the first one; null for none. */
  #name: string | null;
  /** Since it began. */
  #seconds = 0;

  /** Begins as the values say, before anything measures the content. */
  constructor(motion: Motion, values: Values) {
    this.#motion = motion;
    this.#name = nameOf(values);
    if (this.#name !== null) {
      this.pose();
    }
  }

  /**
   * Starts another animation, or ends the present one, if the values say so. True if the pose has
   * changed.
   */
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

  /** Steps of each pose. */
  get work(): number {
    return this.#motion.work;
  }

  /**
   * What `auto` frames while it plays; null for what is there. Call {@link measureReach} before.
   */
  get reach(): GeometrySize | null {
    return this.#name === null ? null : (reaches.get(this.#motion)?.get(this.#name) ?? null);
  }

  advance(seconds: number): void {
    this.#seconds += seconds;
    if (seconds > 0) {
      this.pose();
    }
  }

  pose(): void {
    this.#motion.pose(this.#name, this.#seconds);
  }
}

/** By the animation's name. */
const reaches = new WeakMap<Motion, Map<string, GeometrySize | null>>();

/**
 * Finds how far the animation comes that the values name. True if that was not known before;
 * rejects with the signal's reason after an abort.
 */
export async function measureReach(
  motion: Motion | null,
  values: Values,
  signal: AbortSignal,
): Promise<boolean> {
  const name = nameOf(values);
  if (motion === null || name === null) return false;
  const known = reaches.get(motion) ?? new Map<string, GeometrySize | null>();
  if (known.has(name)) return false;
  known.set(name, await motion.reach(name, signal));
  reaches.set(motion, known);
  return true;
}

const nameOf = ({ autoplay, animationName }: Values): string | null =>
  autoplay ? animationName : null;

/** A mesh whose content moves. */
export interface PlayingMesh {
  /** It would play if motion were allowed. */
  readonly plays: boolean;
  /** Steps of each pose. */
  readonly work: number;
  advance(seconds: number): void;
}

/**
 * The time that all animations of a picture have played. It stands still while motion is not
 * allowed.
 */
export class Animations {
  /** Few meshes can move: a frame does not look at the others. */
  readonly meshes = new Set<PlayingMesh>();
  /** Time of the last frame that moved something, in milliseconds; null after a pause. */
  #last: number | null = null;
  #warned = false;

  get playing(): boolean {
    for (const { plays } of this.meshes) {
      if (plays) return true;
    }
    return false;
  }

  /** Plays on to the frame at `now`, in milliseconds. True while something plays. */
  step(now: number): boolean {
    const elapsed = this.#last === null ? 0 : (now - this.#last) / 1000;
    const { playing } = this;
    let work = 0;
    for (const mesh of this.meshes) {
      if (!mesh.plays) continue;
      work += mesh.work;
      if (work <= LIMITS.pose) {
        mesh.advance(elapsed);
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
