// The three.js camera of an orbit. Matrices are written from the orbit's own basis, without an up vector or an inverse: poles
// and distant targets lose no accuracy. Knows neither lights nor meshes.
import { PerspectiveCamera } from 'three';
import { depthRange, type Bounds, type DepthRange } from '../camera/fit.js';
import { type Basis, type MutableVec3, newBasis, type Orbit } from '../camera/orbit.js';
import type { Vec3 } from '../math/vector.js';
import { type ShadingFrame, writeView } from '../material/lighting.js';
import { sameValue } from '../fields/field-store.js';
import type { Region } from './gpu/stage.js';

export class ViewCamera {
  readonly camera = new PerspectiveCamera();
  /** The shading frame that {@link aim} last wrote. */
  readonly frame: ShadingFrame;
  readonly #orbit: Orbit;
  readonly #basis: Basis = newBasis();
  readonly #eye: MutableVec3 = [0, 0, 0];
  readonly #offset: MutableVec3 = [0, 0, 0];
  readonly #depth: DepthRange = { near: 0.1, far: 100 };
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
    this.camera.matrixAutoUpdate = false;
    this.camera.matrixWorldAutoUpdate = false;
  }

  /** Writes the matrices for a picture of `width` × `height`, or for a part of it. `fov` is vertical, in degrees. */
  aim(fov: number, bounds: Bounds | null, width: number, height: number, part?: Region): void {
    const aimed = [this.#orbit.version, fov, bounds, width, height, part];
    if (sameValue(aimed, this.#aimed)) return;
    this.#aimed = aimed;
    const { camera } = this;
    const { right, up, back } = this.#orbit.basis(this.#basis);
    const eye = this.#writeEye();
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
    const { near, far } = depthRange(this.#orbit.pose, bounds, this.#depth);
    camera.near = near;
    camera.far = far;
    camera.fov = fov;
    camera.aspect = width / height;
    if (part === undefined) camera.clearViewOffset();
    else camera.setViewOffset(width, height, part.x, part.y, part.width, part.height);
    camera.updateProjectionMatrix();
    scaleClipSpace(camera, this.#orbit.pose.radius);
  }

  /** From the basis, which has taken the sines and cosines. */
  #writeEye(): Vec3 {
    const { radius, target } = this.#orbit;
    const { back } = this.#basis;
    for (let i = 0; i < 3; i++) {
      this.#offset[i] = back[i]! * radius;
      this.#eye[i] = this.#offset[i]! + target[i]!;
    }
    return this.#eye;
  }
}

/**
 * Brings w in clip space near 1 for very small and very large scenes. A multiple of a projection draws the same picture, but
 * software GL interpolates wrongly in scenes of size 1e-14 and 2e11. Other scenes keep w as the distance: three.js's
 * sprites and points recognise a perspective by it.
 */
function scaleClipSpace(camera: PerspectiveCamera, radius: number): void {
  if (radius > 1 / USUAL_RADIUS && radius < USUAL_RADIUS) return;
  const scale = 2 ** -Math.round(Math.log2(radius)); // a power of two rounds nothing
  camera.projectionMatrix.multiplyScalar(scale);
  camera.projectionMatrixInverse.multiplyScalar(1 / scale);
}

/** Far from where interpolation begins to fail, on either side. */
const USUAL_RADIUS = 1e9;
