// The radius that shows the whole scene, the limits of zoom, and the near and far planes, all from
// one bounding sphere. Lengths in scene units, world space; angles in degrees. Every result is
// finite and above 0, for any input.
import { cosDegrees, sinDegrees } from '../math/angle.js';
import type { Vec3 } from '../math/vector.js';
import type { RadiusLimits } from './drag.js';
import { basisOf, LARGEST_LENGTH, newBasis, type Pose } from './orbit.js';

/** A sphere that contains every vertex of the scene. `null` stands for an empty scene. */
export interface Bounds {
  readonly center: Vec3;
  /** Reaches the farthest vertex; 0 for a single point. */
  readonly radius: number;
}

export interface DepthRange {
  near: number;
  far: number;
  /** Whether parts of the sphere may be nearer than `near`. */
  cuts: boolean;
}

/**
 * Free space around the scene: the sphere fills 1/1.05 of the sine of half the smaller field of
 * view.
 */
const MARGIN = 1.05;
/** Radius, in scene units, where there is nothing to fit to. */
const EMPTY_RADIUS = 4;
/** How many times nearer or farther than `auto` the user can zoom. */
const ZOOM_REACH = 1e3;

/**
 * What `auto` stands for. An empty scene gives the origin and 4, a single point its place and 4.
 */
export function fitPose(
  bounds: Bounds | null,
  fov: number,
  aspect: number,
): Pick<Pose, 'target' | 'radius'> {
  if (bounds === null || !bounds.center.every(Number.isFinite)) {
    return { target: [0, 0, 0], radius: EMPTY_RADIUS };
  }
  return { target: bounds.center, radius: fitRadius(bounds.radius, fov, aspect) };
}

/**
 * 1.05 R / sin(half the smaller of the vertical and horizontal fields), at most {@link
 * LARGEST_LENGTH}. `fov` is vertical, in degrees; `aspect` is width over height, and counts as 1 if
 * the picture has no size.
 */
export function fitRadius(sphereRadius: number, fov: number, aspect: number): number {
  const sinVertical = sinDegrees(fov / 2);
  const tanHorizontal =
    (sinVertical / cosDegrees(fov / 2)) * (aspect > 0 && aspect < 1 ? aspect : 1);
  const sinHalf = Math.min(
    sinVertical,
    tanHorizontal / Math.sqrt(1 + tanHorizontal * tanHorizontal),
  );
  const radius = (MARGIN * sphereRadius) / sinHalf;
  return radius > 0 ? Math.min(radius, LARGEST_LENGTH) : EMPTY_RADIUS;
}

/** Zoom limits: 1e-3 to 1e3 times the scene's radius, which counts as 1 if it is 0. */
export function zoomLimits(bounds: Bounds | null): RadiusLimits {
  const radius = bounds !== null && bounds.radius > 0 ? bounds.radius : 1;
  return {
    min: Math.min(radius, LARGEST_LENGTH) / ZOOM_REACH,
    max: Math.min(radius * ZOOM_REACH, LARGEST_LENGTH),
  };
}

/**
 * Near and far as distances along the view, written to `out`. They enclose a sphere that lies
 * wholly in front of the eye while far/near stays below 1000. Otherwise (the eye inside the sphere,
 * or just outside) near is far/1000, or a tenth of the orbit's radius if that is less, and the
 * scene may reach nearer: see {@link nearBefore}.
 */
export function depthRange(
  pose: Pose,
  bounds: Bounds | null,
  out: DepthRange = { near: 0, far: 0, cuts: false },
): DepthRange {
  const radius = Math.max(pose.radius, SMALLEST_DEPTH);
  const { back } = basisOf(pose, scratch);
  let center = radius;
  for (let i = 0; bounds !== null && i < 3; i++) {
    center += (pose.target[i]! - bounds.center[i]!) * back[i]!;
  }
  let reach = bounds === null ? 0 : Math.max(bounds.radius, 0);
  if (!(Math.abs(center) + reach < LARGEST_DEPTH)) {
    center = radius;
    reach = 0;
  }
  // 1 % covers rounding to float32 and keeps near and far apart for a single point. Behind the eye
  // any range will do.
  out.far = 1.01 * Math.max(center + reach, radius / 1000);
  out.near = Math.max(0.99 * (center - reach), Math.min(out.far / 1000, radius / 10));
  out.cuts = bounds !== null && center - reach < out.near;
  return out;
}

/**
 * A near plane in front of a surface at this depth: a tenth nearer, which is more than float32
 * loses for vertices 1e5 times as far away.
 */
export const nearBefore = (depth: number, radius: number): number =>
  Math.max(0.9 * depth, LEAST_NEAR * radius);

/**
 * Share of the orbit's radius. Closer to the eye, float32 positions relative to the target are no
 * longer distinct.
 */
const LEAST_NEAR = 2 ** -23;

// Between these limits near and far are normal float32 numbers, with room to spare.
const SMALLEST_DEPTH = 1e-30;
const LARGEST_DEPTH = 1e30;
const scratch = newBasis();
