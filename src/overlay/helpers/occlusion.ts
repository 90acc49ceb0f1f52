// Which places of the scene lie behind a shape? By rays into a snapshot of the scene, a while after a change and in slices: nothing waits
// for them, and marks are drawn as before until they are known. Knows nothing of what stands at the places.
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
  /** Something has changed since the last series of rays began. */
  #stale = false;

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

  /** Finds out what hides these places. `changed`: they, the view or the scene may have. */
  follow(view: Projection, places: ReadonlyMap<Key, Vec3>, changed: boolean): void {
    this.#view = view;
    this.#places = places;
    this.#stale ||= changed;
    this.#wait();
  }

  stop(): void {
    clearTimeout(this.#timer);
    this.#timer = 0;
    this.#stale = false;
    this.#hidden.clear();
  }

  #wait(): void {
    if (this.#stale && this.#timer === 0) this.#timer = window.setTimeout(this.#start, PAUSE);
  }

  readonly #start = (): void => {
    this.#timer = 0;
    this.#stale = false;
    const view = this.#view;
    const { scene } = this.#host.snapshot();
    if (view === null || scene === null) return;
    for (const key of this.#hidden.keys()) if (!this.#places.has(key)) this.#hidden.delete(key);
    this.#test(view, scene, this.#places.entries(), false);
  };

  /** Tests one slice of the places that are left; `differs`: some before were found to differ. */
  #test(view: Projection, scene: SceneSnapshot, left: MapIterator<[Key, Vec3]>, differs: boolean): void {
    const end = performance.now() + SLICE;
    let differ = differs;
    let next = left.next();
    for (; next.done !== true; next = left.next()) {
      const [key, place] = next.value;
      const hidden = isBehind(place, view, scene);
      if (hidden !== this.#hidden.get(key)) differ = true;
      this.#hidden.set(key, hidden);
      if (performance.now() >= end) break;
    }
    if (next.done !== true) {
      this.#timer = window.setTimeout(() => {
        this.#timer = 0;
        this.#test(view, scene, left, differ);
      });
      return;
    }
    if (differ) this.#changed();
    this.#wait();
  }
}

function isBehind(place: Vec3, view: Projection, scene: SceneSnapshot): boolean {
  const point = view.point(place);
  if (point === null) return false;
  const { width, height } = scene;
  const hit = pick(scene, (point.x / view.width) * width - 0.5, (point.y / view.height) * height - 0.5);
  return hit !== null && hit.depth < view.depthOf(place) * (1 - TOLERANCE);
}
