// From how far is all of the scene seen, how far may one zoom, and where do near and far lie? Everything from one bounding
// sphere. Lengths in scene units, world space; angles in degrees. Every result is finite and above 0, whatever goes in.

import { cosDegrees, sinDegrees } from '../math/angle.js';
import type { Vec3 } from '../math/vector.js';
import type { RadiusLimits } from './drag.js';
import { basisOf, LARGEST_LENGTH, newBasis } from './orbit.js';
import type { Pose } from './orbit.js';

/** A sphere that holds every vertex of the scene. `null` in its place means an empty scene. */
export interface Bounds {
  readonly centre: Vec3;
  /** Reaches the farthest vertex; 0 for a single point. */
  readonly radius: number;
}

export interface DepthRange {
  near: number;
  far: number;
}

/** What is left free around the scene: the sphere fills 1/1.05 of the sine of the smaller half field. */
const MARGIN = 1.05;
const EMPTY_RADIUS = 4;
const ZOOM_REACH = 1e3;

/** The target and radius that `auto` stands for. An empty scene is seen from 4 at the origin, a single point from 4 too. */
export function fitPose(bounds: Bounds | null, fov: number, aspect: number): Pick<Pose, 'target' | 'radius'> {
  if (bounds === null || !bounds.centre.every(Number.isFinite)) {
    return { target: [0, 0, 0], radius: EMPTY_RADIUS };
  }
  return { target: bounds.centre, radius: fitRadius(bounds.radius, fov, aspect) };
}

/**
 * 1.05 R / sin(half the smaller of the vertical and horizontal fields), at most {@link LARGEST_LENGTH}. `fov` is vertical,
 * in degrees; `aspect` is width over height, taken as 1 where the picture has no size.
 */
export function fitRadius(sphereRadius: number, fov: number, aspect: number): number {
  const sinVertical = sinDegrees(fov / 2);
  const tanHorizontal = (sinVertical / cosDegrees(fov / 2)) * (aspect > 0 && aspect < 1 ? aspect : 1);
  const sinHalf = Math.min(sinVertical, tanHorizontal / Math.hypot(1, tanHorizontal));
  const radius = (MARGIN * sphereRadius) / sinHalf;
  return radius > 0 ? Math.min(radius, LARGEST_LENGTH) : EMPTY_RADIUS;
}

/** How near and far zooming goes: 1e-3 to 1e3 of the scene's radius; of 1 where the scene has none. */
export function zoomLimits(bounds: Bounds | null): RadiusLimits {
  const radius = bounds !== null && bounds.radius > 0 ? bounds.radius : 1;
  return {
    min: Math.min(radius, LARGEST_LENGTH) / ZOOM_REACH,
    max: Math.min(radius * ZOOM_REACH, LARGEST_LENGTH),
  };
}

/**
 * Near and far, as distances along the view. They hold all of a sphere that lies wholly before the eye, as long as far/near
 * stays under 1000; else (the eye inside it, or just outside) near is far/1000, or a tenth of the orbit's radius where that
 * is less, so that the target is never cut off however near one zooms. Written into `out`.
 */
export function depthRange(
  pose: Pose,
  bounds: Bounds | null,
  out: DepthRange = { near: 0, far: 0 },
): DepthRange {
  const radius = Math.max(pose.radius, SMALLEST_DEPTH);
  const { back } = basisOf(pose, scratch);
  let centre = radius;
  for (let i = 0; bounds !== null && i < 3; i++) centre += (pose.target[i]! - bounds.centre[i]!) * back[i]!;
  let reach = bounds === null ? 0 : Math.max(bounds.radius, 0);
  if (!(Math.abs(centre) + reach < LARGEST_DEPTH)) {
    centre = radius;
    reach = 0;
  }
  // One part in 100 covers roundings to float32, and keeps near and far apart for a single point. A sphere behind the eye
  // leaves nothing to hold, only the need of a range.
  out.far = 1.01 * Math.max(centre + reach, radius / 1000);
  out.near = Math.max(0.99 * (centre - reach), Math.min(out.far / 1000, radius / 10));
  return out;
}

// Within them, with room to spare, near and far are normal numbers of float32.
const SMALLEST_DEPTH = 1e-30;
const LARGEST_DEPTH = 1e30;
const scratch = newBasis();
