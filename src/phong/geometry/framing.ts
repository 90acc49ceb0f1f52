// The camera that shows a scene, for `auto`.
import { fitPose, fitRadius } from '../camera/fit.js';
import type { Vec3 } from '../math/vector.js';
import type { Extent } from './bounds.js';

/** Target and radius as declared: `auto`, or a value. */
export interface Framing {
  readonly target: Vec3 | 'auto';
  readonly radius: number | 'auto';
}

export interface Fit {
  readonly target: Vec3;
  readonly radius: number;
  /** The scene shows nothing: any place would do. */
  readonly empty: boolean;
}

/**
 * The camera that shows a scene of this extent. `fov`: vertical, in degrees. About a given target,
 * a given radius stays: an automatic one takes a step for each mesh.
 */
export function fitTo(
  extent: Extent,
  { target, radius }: Framing,
  fov: number,
  aspect: number,
): Fit {
  const empty = extent.bounds === null;
  const fitted = fitPose(extent.bounds, fov, aspect);
  if (target === 'auto') return { ...fitted, empty };
  if (radius !== 'auto') return { target, radius, empty };
  const reach = extent.radiusAbout(target);
  return { target, radius: empty ? fitted.radius : fitRadius(reach, fov, aspect), empty };
}
