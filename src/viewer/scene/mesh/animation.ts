// The poses that meshes show, and the one clock of the animations of a picture.
import type { Object3D } from 'three';
import { declareReach } from '../../../phong/geometry/bounds.js';
import { LIMITS } from '../../../phong/model/limits.js';
import type { GeometrySize } from '../../../phong/geometry/geometry-size.js';
import type { Motion } from '../../../phong/model/model.js';
import type { ShapeValues } from '../../../phong/model/mesh-fields.js';
import { followPose, type Part } from './parts.js';

type Values = Readonly<Pick<ShapeValues, 'autoplay' | 'animationName'>>;

/** What an animation moves. */
interface AnimatedContent {
  readonly parts: readonly Part[];
  readonly root: Object3D | null;
  /** `reshaped`: `auto` is to frame something else. */
  readonly picture: { reshaped(): void };
}

/** The pose that a mesh's content shows: that of an animation at a time, or its own. */
export class MeshAnimation {
  readonly #motion: Motion;
  readonly #host: AnimatedContent;
  /** Empty for the first one; null for none. */
  #name: string | null;
  /** Since it began. */
  #seconds = 0;
  /** Ends the measuring of the reach of an animation that has begun since the content came. */
  #measuring: AbortController | null = null;

  /** Goes on from {@link poseFirst}. */
  constructor(motion: Motion, values: Values, host: AnimatedContent) {
    this.#motion = motion;
    this.#name = nameOf(values);
    this.#host = host;
    this.#frame();
  }

  /** Starts another animation, or ends the present one, if the values say so. */
  update(values: Values): void {
    if (nameOf(values) === this.#name) return;
    this.#name = nameOf(values);
    this.#seconds = 0;
    this.pose();
    void this.#measure(values);
  }

  /** It would play if motion were allowed. */
  get plays(): boolean {
    return this.#name !== null && this.#motion.durationOf(this.#name) > 0;
  }

  /** Steps of each pose. */
  get work(): number {
    return this.#motion.work;
  }

  advance(seconds: number): void {
    this.#seconds += seconds;
    if (seconds > 0) {
      this.pose();
    }
  }

  /** Brings the parts into the present pose. */
  pose(): void {
    this.#motion.pose(this.#name, this.#seconds);
    followPose(this.#host.parts);
  }

  dispose(): void {
    this.#measuring?.abort('replaced');
  }

  /** Frames the poses of the present animation, as soon as they are known. */
  async #measure(values: Values): Promise<void> {
    this.#frame();
    this.dispose();
    const { signal } = (this.#measuring = new AbortController());
    if (await measureReach(this.#motion, values, signal).catch(() => false)) {
      this.#frame();
    }
  }

  /** `auto` frames the reach of the animation, if it is known; without one what is there. */
  #frame(): void {
    const reach = this.#name === null ? undefined : reaches.get(this.#motion)?.get(this.#name);
    const { root, picture } = this.#host;
    if (root !== null) {
      declareReach(root, reach ?? null);
    }
    picture.reshaped();
  }
}

/** Begins as the values say, before anything measures the content. */
export function poseFirst(motion: Motion | null, values: Values): void {
  const name = nameOf(values);
  if (name !== null) {
    motion?.pose(name, 0);
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

/**
 * The time that all animations of a picture have played. It stands still while motion is not
 * allowed.
 */
export class Animations {
  /** The animations of meshes whose content moves. A frame does not visit other meshes. */
  readonly all = new Set<Pick<MeshAnimation, 'plays' | 'work' | 'advance'>>();
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
