// Shading space: where it is, the eye in it, and its way to clip space; as uniforms that all
// materials of a picture share.
import { type Camera, Matrix4, Vector3 } from 'three';
import { sameValue } from '../fields/field-store.js';
import { dot, type Vec3 } from '../math/vector.js';

/**
 * From where a picture is seen. Shading space has the world's axes and its origin at `origin`.
 * Differences to it are taken in float64, so that scenes far from the world's origin shade like
 * scenes at it. It does not move while the camera turns about its target, and the packed lights
 * stay as they are.
 */
export interface ShadingFrame {
  /** World position of shading space's origin: the camera's target. */
  readonly origin: Vec3;
  readonly eye: Vec3;
  /** Camera basis, orthonormal, in world axes; back points from the target to the eye. */
  readonly right: Vec3;
  readonly up: Vec3;
  readonly back: Vec3;
}

export class ShadingSpace {
  /** Uniform `uEye`. */
  readonly eye = { value: new Vector3() };
  /** Uniform `uShadingToClip`; see {@link aim}. */
  readonly clip = { value: new Matrix4() };
  /** Uniform `uMapBias`: levels added to the one that a map is sampled from. Default 0. */
  readonly mapBias = { value: 0 };
  #origin: Vec3 = [0, 0, 0];
  /** Shading space to the view of the frame's own camera. */
  readonly #frameView = new Matrix4();
  #frameCamera: Camera | null = null;
  /** Goes up with {@link clip}. */
  #aims = 0;
  readonly #aimed = { view: new Matrix4(), projection: new Matrix4() };

  /** World position that fragments are shaded relative to. Another array after each move. */
  get origin(): Vec3 {
    return this.#origin;
  }

  /** A frame begins. `camera` as in {@link PhongLighting.updateFrame}. */
  follow(frame: ShadingFrame, camera: Camera | null): void {
    const { origin, eye } = frame;
    this.#frameCamera = camera;
    writeView(this.#frameView, frame, eye);
    this.eye.value.set(eye[0], eye[1], eye[2]);
    if (!sameValue(origin, this.#origin)) {
      this.#origin = [origin[0], origin[1], origin[2]];
    }
  }

  /**
   * Call before each draw: updates {@link clip} to `camera`. Returns a version that increments when
   * it changes.
   */
  aim(camera: Camera): number {
    const { view: last, projection } = this.#aimed;
    const seen = camera === this.#frameCamera ? this.#frameView : this.#viewOf(camera);
    if (last.equals(seen) && projection.equals(camera.projectionMatrix)) return this.#aims;
    last.copy(seen);
    projection.copy(camera.projectionMatrix);
    this.clip.value.multiplyMatrices(projection, last);
    return (this.#aims += 1);
  }

  #viewOf({ matrixWorldInverse }: Camera): Matrix4 {
    const [x, y, z] = this.#origin;
    return view.makeTranslation(x, y, z).premultiply(matrixWorldInverse);
  }
}

/** Overwritten by each call of `#viewOf`. */
const view = /* @__PURE__ */ new Matrix4();

type Axes = Pick<ShadingFrame, 'right' | 'up' | 'back'>;

/** Writes the matrix from the view of an eye to the space of these axes' coordinates. */
export function writeCamera(into: Matrix4, { right, up, back }: Axes, eye: Vec3): void {
  // oxfmt-ignore
  into.set(
    right[0], up[0], back[0], eye[0],
    right[1], up[1], back[1], eye[1],
    right[2], up[2], back[2], eye[2],
    0, 0, 0, 1,
  );
}

/** Writes the inverse of {@link writeCamera}'s matrix. */
export function writeView(into: Matrix4, { right, up, back }: Axes, eye: Vec3): void {
  // oxfmt-ignore
  into.set(
    right[0], right[1], right[2], -dot(right, eye),
    up[0], up[1], up[2], -dot(up, eye),
    back[0], back[1], back[2], -dot(back, eye),
    0, 0, 0, 1,
  );
}
