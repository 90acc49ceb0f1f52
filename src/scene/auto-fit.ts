// Fits the camera to the scene for `auto`, and measures how deep the scene is. Measures the scene when its meshes have
// changed, and moves the orbit when scene, field of view or the picture's aspect have.
import type { Mesh } from 'three';
import { type Bounds, fitPose, fitRadius } from '../camera/fit.js';
import type { Vec3 } from '../math/vector.js';
import { type Extent, measure, radiusOf } from './bounds.js';
import type { Size } from './gpu/atlas.js';
import type { Picture } from './picture.js';

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
  /** The scene, its shading, the size or the field of view of a picture has changed. */
  changed(): void;
  /** The fit of all pictures together. */
  fit(framing: Framing): Fit;
}

export class AutoFit {
  readonly #picture: Picture;
  #framing: Framing | null = { target: 'auto', radius: 'auto' };
  #fov = 45;
  /** Width over height of the last size above 0: a hidden picture keeps its camera. */
  #aspect = 1;
  #shared: SharedFit | null = null;
  /** Null after a change of the scene. */
  #measured: { readonly extent: Extent; readonly bounds: Bounds | null } | null = null;
  /** Where the orbit was put; null after a change of anything that this follows from. */
  #fitted: Fit | null = null;
  readonly #depthBounds = { center: ORIGIN, radius: 0 };

  constructor(picture: Picture) {
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

  /** Meshes were added, removed or moved, or their vertices changed. */
  reshaped(): void {
    this.#measured = null;
    this.#refit();
  }

  /**
   * A mesh has moved; its world matrix is where it was. Inside the bounds at both places it leaves them as they are.
   */
  moved(mesh: Mesh): void {
    if (this.#staysInside(mesh)) this.#picture.invalidate();
    else this.reshaped();
  }

  #staysInside({ geometry, matrixWorld, matrix, parent }: Mesh): boolean {
    const { extent, bounds = null } = this.#measured ?? {};
    // Other points than the bounds' centre have other farthest vertices.
    const { target = 'auto', radius = 0 } = this.#framing ?? {};
    const isFitted = this.#fitted !== null || this.#framing === null;
    if (bounds === null || !isFitted || this.#shared !== null || parent !== this.#picture.scene) return false;
    if (target !== 'auto' && radius === 'auto') return false;
    return [matrixWorld, matrix].every(({ elements }) => extent!.holds(geometry, elements, bounds.radius));
  }

  resized({ width, height }: Size): void {
    if (width > 0 && height > 0) this.#aspect = width / height;
    this.#refit();
  }

  /** The meshes' bounds, measured where the scene has changed; null where it shows nothing. */
  measure(): Bounds | null {
    return this.#measure().bounds;
  }

  /**
   * A sphere about the same centre that holds everything visible under the present world matrices, objects that moved
   * since the last measurement included. Null where the scene shows nothing. Overwritten by the next call.
   */
  depthBounds(): Bounds | null {
    const { bounds } = this.#measure();
    const depth = this.#depthBounds;
    depth.center = bounds?.center ?? ORIGIN;
    depth.radius = radiusOf(this.#picture.scene, depth.center);
    return bounds === null && depth.radius === 0 ? null : depth;
  }

  /** Measures and fits where something has changed. True if the orbit moved. */
  settle(): boolean {
    this.#measure();
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
   * Where this framing puts the camera for this picture alone. The radius is that of `auto`, whatever the framing says.
   */
  fitOf({ target }: Framing): Fit {
    const { extent, bounds } = this.#measure();
    const { empty } = extent;
    const fitted = fitPose(bounds, this.#fov, this.#aspect);
    if (target === 'auto') return { ...fitted, empty };
    const radius = empty ? fitted.radius : fitRadius(extent.radiusAbout(target), this.#fov, this.#aspect);
    return { target, radius, empty };
  }

  #refit(): void {
    this.#fitted = null;
    this.#shared?.changed();
    this.#picture.invalidate();
  }

  #measure(): { readonly extent: Extent; readonly bounds: Bounds | null } {
    if (this.#measured !== null) return this.#measured;
    this.#picture.place();
    const extent = measure(this.#picture.scene);
    const { center, empty } = extent;
    const bounds = empty ? null : { center, radius: extent.radiusAbout(center) };
    return (this.#measured = { extent, bounds });
  }
}

const ORIGIN: Vec3 = [0, 0, 0];
