// Fits the camera to the scene for `auto`, again when meshes have changed, and measures in each
// frame how deep it is.
import type { Object3D, Scene } from 'three';
import type { Bounds } from '../../phong/camera/fit.js';
import { type Fit, fitTo, type Framing } from '../../phong/geometry/framing.js';
import type { Orbit } from '../../phong/camera/orbit.js';
import { ORIGIN } from '../../phong/math/vector.js';
import { type Extent, measure, radiusOf } from '../../phong/geometry/bounds.js';
import type { Size } from '../../phong/math/region.js';

/** Frames several pictures as one. */
interface SharedFit {
  /** The scene, its shading, the size or the field of view of a picture has changed. */
  changed(): void;
  /** The fit of all pictures together. */
  fit(framing: Framing): Fit;
}

/** What is framed. */
interface FramedScene {
  readonly scene: Scene;
  readonly orbit: Orbit;
  /** Another version is to be drawn. */
  invalidate(): void;
  /** Brings the world matrices up to date. */
  updateMatrices(): void;
}

export class AutoFit {
  readonly #picture: FramedScene;
  #framing: Framing | null = { target: 'auto', radius: 'auto' };
  #fov = 45;
  /** Width over height of the last size above 0: a hidden picture keeps its camera. */
  #aspect = 1;
  #shared: SharedFit | null = null;
  /** Null after a change of the scene. */
  #measured: Extent | null = null;
  /** Where the orbit was put; null after a change of anything that this follows from. */
  #fitted: Fit | null = null;
  readonly #depthBounds = { center: ORIGIN, radius: 0 };

  constructor(picture: FramedScene) {
    this.#picture = picture;
  }

  /** How target and radius are found; null leaves them where the user put them. */
  get framing(): Framing | null {
    return this.#framing;
  }

  set framing(framing: Framing | null) {
    this.#framing = framing;
    this.#fitted = null;
    this.#picture.invalidate();
  }

  /** Frames this picture together with others; null, the default: alone. */
  set shared(shared: SharedFit | null) {
    this.#shared = shared;
    this.#fitted = null;
  }

  /** Vertical, in degrees. Default 45. */
  get fov(): number {
    return this.#fov;
  }

  set fov(degrees: number) {
    if (degrees === this.#fov) return;
    this.#fov = degrees;
    this.#refit();
  }

  /** Meshes were added or removed, or their vertices changed; `moved`: this one was only moved. */
  reshaped(moved?: Object3D): void {
    if (moved === undefined) {
      this.#measured = null;
    } else {
      this.#measured?.moved(moved);
    }
    this.#refit();
  }

  resized({ width, height }: Size): void {
    if (width > 0 && height > 0) {
      this.#aspect = width / height;
    }
    this.#refit();
  }

  measure(): Extent {
    if (this.#measured !== null) return this.#measured;
    this.#picture.updateMatrices();
    return (this.#measured = measure(this.#picture.scene));
  }

  /**
   * Holds all that is visible now, about the same centre; null for nothing. Overwritten by the next
   * call.
   */
  depthBounds(): Bounds | null {
    const { bounds } = this.measure();
    const depth = this.#depthBounds;
    depth.center = bounds?.center ?? ORIGIN;
    depth.radius = radiusOf(this.#picture.scene, depth.center);
    return bounds === null && depth.radius === 0 ? null : depth;
  }

  /** Measures and fits where something has changed. True if the orbit moved. */
  settle(): boolean {
    if (this.#fitted !== null || this.#framing === null) return false;
    this.#fitted = this.#shared?.fit(this.#framing) ?? this.fitOf(this.#framing);
    const { radius } = this.#framing;
    const { orbit } = this.#picture;
    const before = orbit.version;
    orbit.set({
      target: this.#fitted.target,
      radius: radius === 'auto' ? this.#fitted.radius : radius,
    });
    return orbit.version !== before;
  }

  /**
   * The camera of this framing for this picture alone. With an automatic target its radius is
   * automatic too, whatever the framing says.
   */
  fitOf(framing: Framing): Fit {
    return fitTo(this.measure(), framing, this.#fov, this.#aspect);
  }

  #refit(): void {
    this.#fitted = null;
    this.#shared?.changed();
    this.#picture.invalidate();
  }
}
