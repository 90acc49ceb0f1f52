// Finds out by rays into a snapshot of the scene what lies behind a shape, and where a spot's axis
// meets one. Nothing waits for them: marks are drawn as before until the answers are known.
import type { SceneSnapshot } from '../../../phong/geometry/scene-snapshot.js';
import type { ExtraHost } from '../../../viewer/extra.js';
import type { Vec3 } from '../../../phong/math/vector.js';
import { runFor } from '../../explain/in-tasks.js';
import { pick } from '../../explain/pick.js';
import type { RaySearch } from '../../explain/ray-triangles.js';
import type { Projection } from '../drawing/projection.js';

/**
 * Milliseconds between a change and the rays: several changes in a row, as in a drag, cost one
 * series.
 */
const PAUSE = 100;

/** While changes go on, a series takes at most 1 / PARTS of the time. */
const PARTS = 50;

/** Milliseconds of rays in one task. */
const SLICE = 4;

/** Relative. A place on a surface, such as a lamp's on its shade, is not behind it. */
const TOLERANCE = 1e-3;

export type RayTest<Answer> = (scene: SceneSnapshot) => RaySearch<Answer>;

/** Runs tests by rays some time after a frame, in slices, and keeps their answers by key. */
export class RayTests<Key, Answer> {
  readonly #host: ExtraHost;
  readonly #changed: () => void;
  readonly #answers = new Map<Key, Answer>();
  /** Gives what the next series of rays tests; null if nothing waits. */
  #waiting: (() => ReadonlyMap<Key, RayTest<Answer>>) | null = null;
  #timer = 0;
  /** Rays of a series are still to be tested. */
  #slicing = false;
  #changedAt = -Infinity;
  /** When the next series may begin although changes go on, and at the latest. */
  #due = 0;
  /** Milliseconds that the last series took. */
  #took = 0;

  /** `changed` is called when an answer differs from the one before. */
  constructor(host: ExtraHost, changed: () => void) {
    this.#host = host;
    this.#changed = changed;
  }

  /** As last known; undefined before that. */
  answer(key: Key): Answer | undefined {
    return this.#answers.get(key);
  }

  /** `tests` is called when the rays begin, for the last change alone. */
  follow(tests: () => ReadonlyMap<Key, RayTest<Answer>>): void {
    const now = performance.now();
    const interval = now - this.#changedAt;
    this.#changedAt = now;
    // Between two slow frames of a drag is no rest.
    const rest = interval < 2 * PAUSE ? Math.max(PAUSE, 3 * interval) : PAUSE;
    if (this.#waiting === null) {
      this.#due = now + Math.max(PAUSE, PARTS * this.#took);
    }
    this.#waiting = tests;
    if (this.#slicing) return;
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(this.#start, Math.min(rest, this.#due - now));
  }

  stop(): void {
    clearTimeout(this.#timer);
    this.#slicing = false;
    this.#waiting = null;
    this.#answers.clear();
  }

  readonly #start = (): void => {
    const waiting = this.#waiting;
    this.#waiting = null;
    const { scene } = this.#host.snapshot();
    if (waiting === null || scene === null) return;
    const tests = waiting();
    this.#took = 0;
    for (const key of this.#answers.keys()) {
      if (!tests.has(key)) {
        this.#answers.delete(key);
      }
    }
    this.#slice(this.#series(scene, tests));
  };

  /**
   * Answers one question after the other. Returns whether an answer differs from the one before.
   */
  *#series(scene: SceneSnapshot, tests: ReadonlyMap<Key, RayTest<Answer>>): RaySearch<boolean> {
    let differ = false;
    for (const [key, test] of tests) {
      const answer = yield* test(scene);
      if (answer !== this.#answers.get(key)) {
        differ = true;
      }
      this.#answers.set(key, answer);
    }
    return differ;
  }

  #slice(series: RaySearch<boolean>): void {
    const begun = performance.now();
    const step = runFor(SLICE, series);
    this.#took += performance.now() - begun;
    if (step.done !== true) {
      this.#slicing = true;
      this.#timer = window.setTimeout(() => this.#slice(series));
      return;
    }
    this.#slicing = false;
    const waiting = this.#waiting;
    this.#waiting = null;
    if (waiting !== null) {
      this.follow(waiting);
    }
    if (step.value) {
      this.#changed();
    }
  }
}

export const isBehind = (place: Vec3, view: Projection): RayTest<boolean> =>
  function* (scene) {
    const point = view.point(place);
    if (point === null) return false;
    const { width, height } = scene;
    const hit = yield* pick(
      scene,
      (point.x / view.width) * width - 0.5,
      (point.y / view.height) * height - 0.5,
    );
    return hit !== null && hit.depth < view.depthOf(place) * (1 - TOLERANCE);
  };
