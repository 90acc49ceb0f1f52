// What one drawing of a picture shows, whatever it is for: its size, its samples and its camera.
// The matrices are written from the orbit's own basis, without an up vector or an inverse: poles
// and distant targets lose no accuracy.
import { type Object3D, PerspectiveCamera } from 'three';
import { depthRange, type Bounds, type DepthRange, nearBefore } from '../../phong/camera/fit.js';
import { type Basis, type MutableVec3, newBasis, type Orbit } from '../../phong/camera/orbit.js';
import { type ShadingFrame, writeCamera, writeView } from '../../phong/material/shading-space.js';
import { radians } from '../../phong/math/angle.js';
import type { Region, Size } from '../../phong/math/region.js';
import { nearestDepth } from './near-depth.js';
import type { Frustum } from '../../phong/geometry/frustum-clip.js';

/** One object for all frames of a picture: {@link update} and then {@link aim} overwrite it. */
export class Frame {
  /** Device pixels of the whole picture. */
  width = 0;
  height = 0;
  /** Number of drawings that are averaged. 1: the plain picture. */
  samples = 1;
  /** Share of the pixels a side that is drawn. */
  share = 1;
  /** The version of what is in it, lights aside. */
  #version = -1;
  readonly camera = new PerspectiveCamera();
  readonly shading: ShadingFrame;
  /** The whole picture's sides. */
  readonly view: { -readonly [K in keyof Frustum]: Frustum[K] };
  readonly #orbit: Orbit;
  readonly #basis: Basis = newBasis();
  readonly #eye: MutableVec3 = [0, 0, 0];
  readonly #offset: MutableVec3 = [0, 0, 0];
  readonly #depth: DepthRange = { near: 0.1, far: 100, cuts: false };

  constructor(orbit: Orbit) {
    this.#orbit = orbit;
    this.shading = {
      get origin() {
        return orbit.target;
      },
      eye: this.#offset,
      ...this.#basis,
    };
    this.view = { frame: this.shading, slopeX: 1, slopeY: 1, radius: 1 };
    this.camera.matrixAutoUpdate = false;
    this.camera.matrixWorldAutoUpdate = false;
  }

  /**
   * Takes the orbit's place; {@link aim} follows. `fov` is vertical, in degrees. False if only lights
   * can differ.
   */
  update(fov: number, { width, height }: Size, samples = 1, version = 0, share = 1): boolean {
    const { view, camera } = this;
    const isSameSize = width === this.width && height === this.height;
    const isAlike = isSameSize && samples === this.samples && share === this.share;
    const isOther = !isAlike || version !== this.#version;
    this.#version = version;
    this.width = width;
    this.height = height;
    this.samples = samples;
    this.share = share;
    this.#orbit.basis(this.#basis);
    const { radius, target } = this.#orbit;
    for (let i = 0; i < 3; i++) {
      this.#offset[i] = this.#basis.back[i]! * radius;
      this.#eye[i] = this.#offset[i]! + target[i]!;
    }
    camera.fov = fov;
    camera.aspect = width / height;
    view.slopeY = Math.tan(radians(fov) / 2);
    view.slopeX = view.slopeY * camera.aspect;
    view.radius = radius;
    return isOther;
  }

  /**
   * Writes the camera. Its near plane lies before whatever is visible below `root`, which `bounds`
   * hold.
   */
  aim(root: Object3D, bounds: Bounds | null): void {
    const { camera, view } = this;
    const { near, far, cuts } = depthRange(this.#orbit.pose, bounds, this.#depth);
    camera.near = cuts
      ? Math.min(near, nearBefore(nearestDepth(root, view, 2 * near), view.radius))
      : near;
    camera.far = far;
    writeCamera(camera.matrixWorld, this.#basis, this.#eye);
    writeView(camera.matrixWorldInverse, this.#basis, this.#eye);
    camera.matrix.copy(camera.matrixWorld);
    // Helpers of three.js, such as its raycaster, read these.
    camera.matrix.decompose(camera.position, camera.quaternion, camera.scale);
    this.show();
  }

  /** The camera takes in this part of the picture; without one, the whole of it. */
  show(part?: Region): void {
    const { camera, width, height } = this;
    if (part === undefined) {
      camera.clearViewOffset();
    } else {
      camera.setViewOffset(width, height, part.x, part.y, part.width, part.height);
    }
    camera.updateProjectionMatrix();
    if (camera.far > DEEPEST * camera.near) {
      removeFarPlane(camera);
    }
    scaleClipSpace(camera, this.view.radius);
  }
}

/**
 * Moves the far plane to infinity: depth is then w − 2 near, so its row equals that of w except for
 * one number. Both are rounded alike at any size of the vertices, and no vertex falls behind the
 * far plane by rounding.
 */
function removeFarPlane({
  near,
  projectionMatrix,
  projectionMatrixInverse,
}: PerspectiveCamera): void {
  const { elements } = projectionMatrix;
  elements[10] = -1;
  elements[14] = -2 * near;
  projectionMatrixInverse.copy(projectionMatrix).invert();
}

/**
 * Far over near. Beyond, far lies less than 20 roundings of w behind the scene, and could cut it.
 */
const DEEPEST = 2 ** 14;

/**
 * Brings w in clip space near 1 for very small and very large scenes. A multiple of a projection
 * draws the same picture, but software GL interpolates wrongly in scenes of size 1e-14 and 2e11.
 * Other scenes keep w as the distance: three.js's sprites and points recognise a perspective by it.
 */
function scaleClipSpace(camera: PerspectiveCamera, radius: number): void {
  if (radius > 1 / USUAL_RADIUS && radius < USUAL_RADIUS) return;
  const scale = 2 ** -Math.round(Math.log2(radius)); // a power of two rounds nothing
  camera.projectionMatrix.multiplyScalar(scale);
  camera.projectionMatrixInverse.multiplyScalar(1 / scale);
}

/** Far from where interpolation begins to fail, on either side. */
const USUAL_RADIUS = 1e9;
