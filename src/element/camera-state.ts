// Where a viewer's camera is, and what moved it. Types only.
import type { Vec3 } from '../math/vector.js';

/** What moved the camera. */
export type CameraSource = 'pointer' | 'wheel' | 'key' | 'panel' | 'script' | 'auto';

/** The camera as it is now. Frozen. Angles in degrees, lengths in scene units, vectors in world space. */
export interface CameraState {
  readonly eye: Vec3;
  readonly target: Vec3;
  readonly up: Vec3;
  /** In [-180, 180). */
  readonly theta: number;
  readonly phi: number;
  readonly radius: number;
}
