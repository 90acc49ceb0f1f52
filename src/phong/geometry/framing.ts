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

/** The camera that shows a scene of this extent, about `target`. `fov`: vertical, in degrees. */
export function fitTo(extent: Extent, target: Framing['target'], fov: number, aspect: number): Fit {
  const { bounds } = extent;
  const empty = bounds === null;
  const fitted = fitPose(bounds, fov, aspect);
  if (target === 'auto') return { ...fitted, empty };
  return {
    target,
    empty,
    // A step for each mesh, so it is computed only when it is read: a given radius replaces it.
    get radius() {
      return empty ? fitted.radius : fitRadius(extent.radiusAbout(target), fov, aspect);
    },
  };
}
