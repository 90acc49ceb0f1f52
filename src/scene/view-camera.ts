// The three.js camera of an orbit. Matrices are written from the orbit's own basis, without an up vector or an inverse:
// poles and distant targets lose no accuracy.
import { type Object3D, PerspectiveCamera } from 'three';
import { depthRange, type Bounds, type DepthRange, nearBefore } from '../camera/fit.js';
import { type Basis, type MutableVec3, newBasis, type Orbit } from '../camera/orbit.js';
import { type ShadingFrame, writeView } from '../material/lighting.js';
import { radians } from '../math/angle.js';
import { sameValue } from '../fields/field-store.js';
import type { Region } from './gpu/stage.js';
import { nearestDepth } from './near-depth.js';
import type { View } from './frustum-clip.js';

export class ViewCamera {
  readonly camera = new PerspectiveCamera();
  /** The shading frame that {@link look} or {@link aim} last wrote. */
  readonly frame: ShadingFrame;
  readonly #orbit: Orbit;
  readonly #basis: Basis = newBasis();
  readonly #eye: MutableVec3 = [0, 0, 0];
  readonly #offset: MutableVec3 = [0, 0, 0];
  readonly #depth: DepthRange = { near: 0.1, far: 100, cuts: false };
  /** What {@link camera} shows. */
  readonly #view: { -readonly [K in keyof View]: View[K] };
  /** The orbit's version and the arguments of the last {@link aim}. */
  #aimed: readonly unknown[] = [];

  constructor(orbit: Orbit) {
    this.#orbit = orbit;
    this.frame = {
      get origin() {
        return orbit.target;
      },
      eye: this.#offset,
      ...this.#basis,
    };
    this.#view = { frame: this.frame, slopeX: 1, slopeY: 1, radius: 1 };
    this.camera.matrixAutoUpdate = false;
    this.camera.matrixWorldAutoUpdate = false;
  }

  /** The whole picture's sides, as {@link look} or {@link aim} last wrote them. */
  get view(): View {
    return this.#view;
  }

  /**
   * Writes the matrices for a picture of `width` × `height`, or for a part of it. `fov` is vertical, in degrees. The
   * near plane is that of the whole picture: before whatever is visible below `root`, which `bounds` hold.
   */
  aim(
    fov: number,
    root: Object3D,
    bounds: Bounds | null,
    width: number,
    height: number,
    part?: Region,
  ): void {
    const near = this.#nearPlane(fov, root, bounds, width / height);
    const aimed = [this.#orbit.version, fov, bounds, near, width, height, part];
    if (sameValue(aimed, this.#aimed)) return;
    this.#aimed = aimed;
    const { camera } = this;
    this.#place();
    camera.near = near;
    camera.far = this.#depth.far;
    camera.fov = fov;
    camera.aspect = width / height;
    if (part === undefined) camera.clearViewOffset();
    else camera.setViewOffset(width, height, part.x, part.y, part.width, part.height);
    camera.updateProjectionMatrix();
    if (camera.far > DEEPEST * near) removeFarPlane(camera);
    scaleClipSpace(camera, this.#orbit.pose.radius);
  }

  /** Writes {@link frame} and {@link view}, but neither matrices nor the depth range. `fov` is vertical, in degrees. */
  look(fov: number, aspect: number): View {
    this.#orbit.basis(this.#basis);
    this.#writeEye();
    const view = this.#view;
    view.slopeY = Math.tan(radians(fov) / 2);
    view.slopeX = view.slopeY * aspect;
    view.radius = this.#orbit.radius;
    return view;
  }

  /** Also writes the depth range. */
  #nearPlane(fov: number, root: Object3D, bounds: Bounds | null, aspect: number): number {
    const view = this.look(fov, aspect);
    const { near, cuts } = depthRange(this.#orbit.pose, bounds, this.#depth);
    if (!cuts) return near;
    const depth = nearestDepth(root, view, 2 * near);
    return Math.min(near, nearBefore(depth, view.radius));
  }

  #place(): void {
    const { camera } = this;
    const { right, up, back } = this.#basis;
    const eye = this.#eye;
    // prettier-ignore
    camera.matrixWorld.set(
      right[0], up[0], back[0], eye[0],
      right[1], up[1], back[1], eye[1],
      right[2], up[2], back[2], eye[2],
      0, 0, 0, 1,
    );
    writeView(camera.matrixWorldInverse, this.#basis, eye);
    camera.matrix.copy(camera.matrixWorld);
    // Helpers of three.js, such as its raycaster, read these.
    camera.matrix.decompose(camera.position, camera.quaternion, camera.scale);
  }

  /** From the basis, which has taken the sines and cosines. */
  #writeEye(): void {
    const { radius, target } = this.#orbit;
    const { back } = this.#basis;
    for (let i = 0; i < 3; i++) {
      this.#offset[i] = back[i]! * radius;
      this.#eye[i] = this.#offset[i]! + target[i]!;
    }
  }
}

/**
 * Moves the far plane to infinity: depth is then w − 2 near, so its row equals that of w except for one number. Both
 * are rounded alike at any size of the vertices, and no vertex falls behind the far plane by rounding.
 */
function removeFarPlane({ near, projectionMatrix, projectionMatrixInverse }: PerspectiveCamera): void {
  const { elements } = projectionMatrix;
  elements[10] = -1;
  elements[14] = -2 * near;
  projectionMatrixInverse.copy(projectionMatrix).invert();
}

/**
 * Far over near. Beyond, the hundredth by which the far plane lies behind the scene is less than 20 roundings of w,
 * and surfaces near it could be cut.
 */
const DEEPEST = 2 ** 14;

/**
 * Brings w in clip space near 1 for very small and very large scenes. A multiple of a projection draws the same
 * picture, but software GL interpolates wrongly in scenes of size 1e-14 and 2e11. Other scenes keep w as the
 * distance: three.js's sprites and points recognise a perspective by it.
 */
function scaleClipSpace(camera: PerspectiveCamera, radius: number): void {
  if (radius > 1 / USUAL_RADIUS && radius < USUAL_RADIUS) return;
  const scale = 2 ** -Math.round(Math.log2(radius)); // a power of two rounds nothing
  camera.projectionMatrix.multiplyScalar(scale);
  camera.projectionMatrixInverse.multiplyScalar(1 / scale);
}

/** Far from where interpolation begins to fail, on either side. */
const USUAL_RADIUS = 1e9;
