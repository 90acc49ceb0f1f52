// Where `auto` puts the camera: measures the scene when it has changed, and moves the orbit when scene, angle of view or the
// picture's shape ask for it. Knows nothing of drawing.
import type { Object3D } from 'three';
import { type Bounds, fitPose, fitRadius } from '../camera/fit.js';
import type { Orbit } from '../camera/orbit.js';
import type { Vec3 } from '../math/vector.js';
import { measure, NO_EXTENT, type Extent } from './bounds.js';

/** What stands for `auto`, or the value that was given. */
export interface Framing {
  readonly target: Vec3 | 'auto';
  readonly radius: number | 'auto';
}

export class AutoFit {
  readonly #scene: Object3D;
  readonly #orbit: Orbit;
  #framing: Framing | null = { target: 'auto', radius: 'auto' };
  #extent: Extent = NO_EXTENT;
  #bounds: Bounds | null = null;
  #extentStale = true;
  #fitStale = true;
  /** Width over height of the last size that was not nothing: a hidden picture keeps its camera. */
  #aspect = 1;

  constructor(scene: Object3D, orbit: Orbit) {
    this.#scene = scene;
    this.#orbit = orbit;
  }

  /** How target and radius are found; null leaves them where the user has put them. */
  get framing(): Framing | null {
    return this.#framing;
  }

  set framing(framing: Framing | null) {
    this.#framing = framing;
    this.#fitStale = true;
  }

  /** Of the scene as last measured; null where it shows nothing. */
  get bounds(): Bounds | null {
    return this.#bounds;
  }

  /** Meshes came, went, moved or changed their triangles. */
  reshaped(): void {
    this.#extentStale = true;
    this.#fitStale = true;
  }

  resized(width: number, height: number): void {
    if (width > 0 && height > 0) this.#aspect = width / height;
    this.#fitStale = true;
  }

  /** Another angle of view. */
  refit(): void {
    this.#fitStale = true;
  }

  /** Brings the orbit in step, `fov` being vertical and in degrees; true where that has moved it. */
  settle(fov: number): boolean {
    if (this.#extentStale) this.#measure();
    if (!this.#fitStale) return false;
    this.#fitStale = false;
    return this.#fit(fov);
  }

  #measure(): void {
    this.#extentStale = false;
    this.#scene.updateMatrixWorld();
    this.#extent = measure(this.#scene);
    const { center } = this.#extent;
    this.#bounds = this.#extent.empty ? null : { centre: center, radius: this.#extent.radiusAbout(center) };
  }

  #fit(fov: number): boolean {
    if (this.#framing === null) return false;
    const { target, radius } = this.#framing;
    const fitted = fitPose(this.#bounds, fov, this.#aspect);
    const place = target === 'auto' ? fitted.target : target;
    const distance =
      target === 'auto' || this.#extent.empty
        ? fitted.radius
        : fitRadius(this.#extent.radiusAbout(target), fov, this.#aspect);
    const before = this.#orbit.version;
    this.#orbit.set({ target: place, radius: radius === 'auto' ? distance : radius });
    return this.#orbit.version !== before;
  }
}
