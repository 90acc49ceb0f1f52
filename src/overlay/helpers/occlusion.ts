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
  readonly #hidden = new Set<Key>();
  #view: Projection | null = null;
  #places: readonly (readonly [Key, Vec3])[] = [];
  #timer = 0;

  constructor(host: ExtraHost, changed: () => void) {
    this.#host = host;
    this.#changed = changed;
  }

  /** As last known; false before that. */
  isHidden(key: Key): boolean {
    return this.#hidden.has(key);
  }

  /** Finds out what hides these places. `changed`: they, the view or the scene may have. */
  follow(view: Projection, places: readonly (readonly [Key, Vec3])[], changed: boolean): void {
    this.#view = view;
    this.#places = places;
    if (changed && this.#timer === 0) this.#timer = window.setTimeout(this.#start, PAUSE);
  }

  stop(): void {
    clearTimeout(this.#timer);
    this.#timer = 0;
    this.#hidden.clear();
  }

  readonly #start = (): void => {
    this.#timer = 0;
    const view = this.#view;
    const { scene } = this.#host.snapshot();
    if (view !== null && scene !== null) this.#test(view, scene, this.#places, 0, false);
  };

  /** Tests places from `first` on; `differs`: some before were found to differ. */
  #test(
    view: Projection,
    scene: SceneSnapshot,
    places: readonly (readonly [Key, Vec3])[],
    first: number,
    differs: boolean,
  ): void {
    const end = performance.now() + SLICE;
    let other = differs;
    let next = first;
    while (next < places.length && (next === first || performance.now() < end)) {
      const [key, place] = places[next]!;
      const hidden = isBehind(place, view, scene);
      if (hidden !== this.#hidden.has(key)) other = true;
      if (hidden) this.#hidden.add(key);
      else this.#hidden.delete(key);
      next += 1;
    }
    if (next < places.length)
      this.#timer = window.setTimeout(() => {
        this.#timer = 0;
        this.#test(view, scene, places, next, other);
      });
    else if (other) this.#changed();
  }
}

function isBehind(place: Vec3, view: Projection, scene: SceneSnapshot): boolean {
  const point = view.point(place);
  if (point === null) return false;
  const { width, height } = scene;
  const hit = pick(scene, (point.x / view.width) * width - 0.5, (point.y / view.height) * height - 0.5);
  return hit !== null && hit.depth < view.depthOf(place) * (1 - TOLERANCE);
}
