// Fits the camera to the scene for `auto`, and measures how deep the scene is. Measures the scene when its meshes have
// changed, and moves the orbit when scene, field of view or the picture's aspect have.
import { type Bounds, fitPose, fitRadius } from '../camera/fit.js';
import type { Orbit } from '../camera/orbit.js';
import type { Vec3 } from '../math/vector.js';
import { type Extent, measure, NO_EXTENT, radiusOf } from './bounds.js';
import type { SceneTree } from './scene-tree.js';

/** Target and radius as declared: `auto`, or a value. */
export interface Framing {
  readonly target: Vec3 | 'auto';
  readonly radius: number | 'auto';
}

/** Where `auto` puts the camera. */
export interface Fit {
  readonly target: Vec3;
  readonly radius: number;
  /** The scene shows nothing: any place would do. */
  readonly empty: boolean;
}

/** Frames several pictures as one. */
export interface SharedFit {
  /** The scene, the size or the field of view of a picture has changed. */
  changed(): void;
  /** The fit of all pictures together. */
  fit(framing: Framing): Fit;
}

export class AutoFit {
  readonly #tree: SceneTree;
  readonly #orbit: Orbit;
  #framing: Framing | null = { target: 'auto', radius: 'auto' };
  #extent: Extent = NO_EXTENT;
  #bounds: Bounds | null = null;
  #extentStale = true;
  #fitStale = true;
  #depthBounds: Bounds | null = null;
  /** Width over height of the last size above 0: a hidden picture keeps its camera. */
  #aspect = 1;
  #shared: SharedFit | null = null;

  constructor(tree: SceneTree, orbit: Orbit) {
    this.#tree = tree;
    this.#orbit = orbit;
  }

  /** How target and radius are found; null leaves them where the user put them. */
  get framing(): Framing | null {
    return this.#framing;
  }

  set framing(framing: Framing | null) {
    this.#framing = framing;
    this.#fitStale = true;
  }

  /** Frames this picture together with others; null, the default: alone. */
  set shared(shared: SharedFit | null) {
    this.#shared = shared;
    this.#fitStale = true;
  }

  /** The meshes' bounds as last measured; null where the scene shows nothing. */
  get bounds(): Bounds | null {
    return this.#bounds;
  }

  /**
   * A sphere about the same centre that holds everything visible under the present world matrices, objects that moved
   * since the last measurement included. The same object while nothing changes. Null where the scene shows nothing.
   */
  depthBounds(): Bounds | null {
    const center = this.#bounds?.center ?? ORIGIN;
    const radius = radiusOf(this.#tree.scene, center);
    const last = this.#depthBounds;
    if (last === null || last.center !== center || last.radius !== radius)
      this.#depthBounds = radius === 0 && this.#bounds === null ? null : { center, radius };
    return this.#depthBounds;
  }

  /** Meshes were added, removed or moved, or their vertices changed. */
  reshaped(): void {
    this.#extentStale = true;
    this.#changed();
  }

  resized(width: number, height: number): void {
    if (width > 0 && height > 0) this.#aspect = width / height;
    this.#changed();
  }

  /** The field of view has changed. */
  fovChanged(): void {
    this.#changed();
  }

  /** Measures and fits where something has changed. `fov` is vertical, in degrees. True if the orbit moved. */
  settle(fov: number): boolean {
    if (this.#extentStale) this.#measure();
    if (!this.#fitStale) return false;
    this.#fitStale = false;
    return this.#fit(fov);
  }

  /**
   * Where this framing puts the camera for this picture alone. The radius is that of `auto`, whatever the framing says.
   */
  fitOf({ target }: Framing, fov: number): Fit {
    if (this.#extentStale) this.#measure();
    const { empty } = this.#extent;
    const fitted = fitPose(this.#bounds, fov, this.#aspect);
    if (target === 'auto') return { ...fitted, empty };
    const radius = empty ? fitted.radius : fitRadius(this.#extent.radiusAbout(target), fov, this.#aspect);
    return { target, radius, empty };
  }

  #changed(): void {
    this.#fitStale = true;
    this.#shared?.changed();
  }

  #measure(): void {
    this.#extentStale = false;
    this.#tree.update();
    this.#extent = measure(this.#tree.scene);
    const { center } = this.#extent;
    this.#bounds = this.#extent.empty ? null : { center, radius: this.#extent.radiusAbout(center) };
  }

  #fit(fov: number): boolean {
    if (this.#framing === null) return false;
    const { radius } = this.#framing;
    const fitted = this.#shared?.fit(this.#framing) ?? this.fitOf(this.#framing, fov);
    const before = this.#orbit.version;
    this.#orbit.set({ target: fitted.target, radius: radius === 'auto' ? fitted.radius : radius });
    return this.#orbit.version !== before;
  }
}

const ORIGIN: Vec3 = [0, 0, 0];
