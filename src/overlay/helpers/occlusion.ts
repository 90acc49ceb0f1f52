// Finds out by rays into a snapshot of the scene what lies behind a shape, and where a spot's axis meets one: a while
// after a change and in slices. Nothing waits for them, and marks are drawn as before until they are known.
import type { ExtraHost } from '../../element/viewer/extras.js';
import type { Vec3 } from '../../math/vector.js';
import { pick } from '../../scene/snapshot/pick.js';
import type { SceneSnapshot } from '../../scene/snapshot/scene-snapshot.js';
import type { Projection } from '../drawing/projection.js';

/** Milliseconds between a change and the rays: several changes in a row, as in a drag, cost one series. */
const PAUSE = 100;

/** Milliseconds of rays in one task. */
const SLICE = 4;

/** Relative. A place on a surface, such as a lamp's on its shade, is not behind it. */
const TOLERANCE = 1e-3;

/** Questions that a ray answers, by key. */
export class RayTests<Key, Question, Answer> {
  readonly #host: ExtraHost;
  readonly #test: (question: Question, view: Projection, scene: SceneSnapshot) => Answer;
  readonly #changed: () => void;
  readonly #answers = new Map<Key, Answer>();
  #view: Projection | null = null;
  #questions: ReadonlyMap<Key, Question> = new Map();
  #timer = 0;
  /** Keys whose answers may have changed since the last series of rays began. */
  readonly #stale = new Set<Key>();

  /** `changed` is called when an answer differs from the one before. */
  constructor(
    host: ExtraHost,
    test: (question: Question, view: Projection, scene: SceneSnapshot) => Answer,
    changed: () => void,
  ) {
    this.#host = host;
    this.#test = test;
    this.#changed = changed;
  }

  /** As last known; undefined before that. */
  answer(key: Key): Answer | undefined {
    return this.#answers.get(key);
  }

  /** Finds the answers. `changed`: the keys whose answers may have changed. */
  follow(view: Projection, questions: ReadonlyMap<Key, Question>, changed: Iterable<Key>): void {
    this.#view = view;
    this.#questions = questions;
    for (const key of changed) this.#stale.add(key);
    this.#wait();
  }

  stop(): void {
    clearTimeout(this.#timer);
    this.#timer = 0;
    this.#stale.clear();
    this.#answers.clear();
  }

  #wait(): void {
    if (this.#stale.size > 0 && this.#timer === 0) this.#timer = window.setTimeout(this.#start, PAUSE);
  }

  readonly #start = (): void => {
    this.#timer = 0;
    const keys = [...this.#stale];
    this.#stale.clear();
    const view = this.#view;
    const { scene } = this.#host.snapshot();
    if (view === null || scene === null) return;
    for (const key of this.#answers.keys()) if (!this.#questions.has(key)) this.#answers.delete(key);
    this.#slice(view, scene, keys, false);
  };

  /** Tests one slice of the keys that are left; `differs`: some before were found to differ. */
  #slice(view: Projection, scene: SceneSnapshot, left: Key[], differs: boolean): void {
    const end = performance.now() + SLICE;
    let differ = differs;
    for (let key = left.pop(); key !== undefined; key = performance.now() < end ? left.pop() : undefined) {
      const question = this.#questions.get(key);
      if (question === undefined) continue;
      const answer = this.#test(question, view, scene);
      if (answer !== this.#answers.get(key)) differ = true;
      this.#answers.set(key, answer);
    }
    if (left.length > 0)
      this.#timer = window.setTimeout(() => {
        this.#timer = 0;
        this.#slice(view, scene, left, differ);
      });
    else {
      if (differ) this.#changed();
      this.#wait();
    }
  }
}

/** A shape is in front of the place. */
export function isBehind(place: Vec3, view: Projection, scene: SceneSnapshot): boolean {
  const point = view.point(place);
  if (point === null) return false;
  const { width, height } = scene;
  const hit = pick(scene, (point.x / view.width) * width - 0.5, (point.y / view.height) * height - 0.5);
  return hit !== null && hit.depth < view.depthOf(place) * (1 - TOLERANCE);
}
