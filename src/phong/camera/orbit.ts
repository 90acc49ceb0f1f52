// The camera's pose: the eye lies on a sphere around the target, given by azimuth and polar angle,
// in float64. Angles in degrees, lengths in scene units, world axes. The basis comes from the
// angles, never from an up vector, so it is orthonormal at the poles too.
import { cosDegrees, sinDegrees } from '../math/angle.js';
import { clamp, type Vec3 } from '../math/vector.js';

/** Position and direction of the camera. Angles in degrees, lengths in scene units. */
export interface Pose {
  /**
   * Azimuth about +y, any finite number; 0 looks from +z, 90 from +x. Not wrapped: use
   * `wrapDegrees` for display.
   */
  readonly theta: number;
  /** Polar angle from +y, 0 to 180. */
  readonly phi: number;
  /** Distance of the eye from the target, above 0, up to {@link LARGEST_LENGTH}. */
  readonly radius: number;
  /** The point that the eye looks at; each coordinate within ±{@link LARGEST_LENGTH}. */
  readonly target: Vec3;
}

export type MutableVec3 = [number, number, number];

/** The camera's axes as unit vectors in world space. `back` points from the target to the eye. */
export interface Basis {
  readonly right: MutableVec3;
  readonly up: MutableVec3;
  readonly back: MutableVec3;
}

/** Larger coordinates would make products overflow float32 on the GPU. */
export const LARGEST_LENGTH = 1e15;

const DEFAULT_POSE: Pose = Object.freeze({
  theta: 30,
  phi: 70,
  radius: 4,
  target: Object.freeze([0, 0, 0] as const),
});

export class Orbit {
  #pose = DEFAULT_POSE;
  #version = 0;

  constructor(start: Partial<Pose> = {}) {
    this.set(start);
    this.#version = 0;
  }

  /** Incremented by every change of a value. Setting the present values does not count. */
  get version(): number {
    return this.#version;
  }

  get theta(): number {
    return this.#pose.theta;
  }

  get phi(): number {
    return this.#pose.phi;
  }

  get radius(): number {
    return this.#pose.radius;
  }

  /** Frozen. */
  get target(): Vec3 {
    return this.#pose.target;
  }

  /** The camera as it is now: a frozen value, not affected by later changes. */
  get pose(): Pose {
    return this.#pose;
  }

  /**
   * Moves the camera; omitted values stay. `phi`, large radii and large coordinates are clamped to
   * their ranges. Throws `RangeError` and changes nothing if a number is not finite or the radius
   * is not above 0.
   */
  set(change: Partial<Pose>): void {
    const before = this.#pose;
    const {
      theta = before.theta,
      phi = before.phi,
      radius = before.radius,
      target = before.target,
    } = change;
    if (![theta, phi, radius].every(Number.isFinite) || !(radius > 0)) {
      throw new RangeError('a camera needs finite angles and a finite radius above 0');
    }
    const pose: Pose = Object.freeze({
      // Adding 0 turns -0 into 0, so that equal cameras print alike.
      theta: theta + 0,
      phi: clamp(phi, 0, 180) + 0,
      radius: Math.min(radius, LARGEST_LENGTH),
      target: reachableTarget(target),
    });
    if (samePose(pose, before)) return;
    this.#pose = pose;
    this.#version += 1;
  }

  /** Eye minus target, in world axes. */
  offset(out: MutableVec3 = [0, 0, 0]): MutableVec3 {
    const { back } = basisOf(this.#pose, scratch);
    for (let i = 0; i < 3; i++) {
      out[i] = back[i]! * this.#pose.radius;
    }
    return out;
  }

  /** The eye in world space. */
  eye(out: MutableVec3 = [0, 0, 0]): MutableVec3 {
    this.offset(out);
    for (let i = 0; i < 3; i++) {
      out[i]! += this.#pose.target[i]!;
    }
    return out;
  }

  /**
   * The camera's axes, orthonormal to 1e-15 at every angle. Exactly 0 and ±1 at multiples of 90°.
   */
  basis(out: Basis = newBasis()): Basis {
    return basisOf(this.#pose, out);
  }
}

export const samePose = (a: Pose, b: Pose): boolean =>
  a.theta === b.theta &&
  a.phi === b.phi &&
  a.radius === b.radius &&
  a.target.every((x, i) => x === b.target[i]);

export const newBasis = (): Basis => ({ right: [1, 0, 0], up: [0, 1, 0], back: [0, 0, 1] });

const scratch = newBasis();

/** The axes of a camera at these angles, written to `out`. */
export function basisOf(angles: Pick<Pose, 'theta' | 'phi'>, out: Basis = newBasis()): Basis {
  const { right, up, back } = out;
  const sinTheta = sinDegrees(angles.theta);
  const cosTheta = cosDegrees(angles.theta);
  const sinPhi = sinDegrees(angles.phi);
  const cosPhi = cosDegrees(angles.phi);
  // `0 - x` instead of `-x`: it never gives -0.
  right[0] = cosTheta;
  right[1] = 0;
  right[2] = 0 - sinTheta;
  up[0] = 0 - cosPhi * sinTheta;
  up[1] = sinPhi;
  up[2] = 0 - cosPhi * cosTheta;
  back[0] = sinPhi * sinTheta + 0;
  back[1] = cosPhi;
  back[2] = sinPhi * cosTheta + 0;
  return out;
}

/** A frozen copy clamped to the domain. */
function reachableTarget(target: Vec3): Vec3 {
  if (!target.every(Number.isFinite)) throw new RangeError('a camera needs a finite target');
  return Object.freeze([clampLength(target[0]), clampLength(target[1]), clampLength(target[2])]);
}

export const clampLength = (x: number): number => clamp(x, -LARGEST_LENGTH, LARGEST_LENGTH) + 0;
