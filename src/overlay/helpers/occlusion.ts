// Finds places of the scene that lie behind a shape, by rays into a snapshot of the scene, a while after a change and
// in slices: nothing waits for them, and marks are drawn as before until they are known.
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

export class Occlusion<Key> {
  readonly #host: ExtraHost;
  readonly #changed: () => void;
  readonly #hidden = new Map<Key, boolean>();
  #view: Projection | null = null;
  #places: ReadonlyMap<Key, Vec3> = new Map();
  #timer = 0;
  /** Places that may have changed since the last series of rays began. */
  readonly #stale = new Set<Key>();

  constructor(host: ExtraHost, changed: () => void) {
    this.#host = host;
    this.#changed = changed;
  }

  /** As last known; false before that. */
  isHidden(key: Key): boolean {
    return this.#hidden.get(key) === true;
  }

  /** Whether it is known that nothing hides the place. */
  isSeen(key: Key): boolean {
    return this.#hidden.get(key) === false;
  }

  /** Finds out what hides these places. `changed`: those for which that may have changed. */
  follow(view: Projection, places: ReadonlyMap<Key, Vec3>, changed: Iterable<Key>): void {
    this.#view = view;
    this.#places = places;
    for (const key of changed) this.#stale.add(key);
    this.#wait();
  }

  stop(): void {
    clearTimeout(this.#timer);
    this.#timer = 0;
    this.#stale.clear();
    this.#hidden.clear();
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
    for (const key of this.#hidden.keys()) if (!this.#places.has(key)) this.#hidden.delete(key);
    this.#test(view, scene, keys, false);
  };

  /** Tests one slice of the places that are left; `differs`: some before were found to differ. */
  #test(view: Projection, scene: SceneSnapshot, left: Key[], differs: boolean): void {
    const end = performance.now() + SLICE;
    let differ = differs;
    do {
      const key = left.pop();
      const place = key === undefined ? undefined : this.#places.get(key);
      if (key === undefined || place === undefined) continue;
      const hidden = isBehind(place, view, scene);
      if (hidden !== this.#hidden.get(key)) differ = true;
      this.#hidden.set(key, hidden);
    } while (left.length > 0 && performance.now() < end);
    if (left.length > 0)
      this.#timer = window.setTimeout(() => {
        this.#timer = 0;
        this.#test(view, scene, left, differ);
      });
    else {
      if (differ) this.#changed();
      this.#wait();
    }
  }
}

function isBehind(place: Vec3, view: Projection, scene: SceneSnapshot): boolean {
  const point = view.point(place);
  if (point === null) return false;
  const { width, height } = scene;
  const hit = pick(scene, (point.x / view.width) * width - 0.5, (point.y / view.height) * height - 0.5);
  return hit !== null && hit.depth < view.depthOf(place) * (1 - TOLERANCE);
}
