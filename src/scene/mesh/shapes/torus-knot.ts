// The (2, 3) torus knot in three.js's size.
import { TorusKnotGeometry, type BufferGeometry } from 'three';

// three.js's defaults: the strands do not touch.
const RADIUS = 1;
const TUBE = 0.4;

/** @param segments along the knot, at least 32; those around the tube grow with it, from 8 to 64. */
export function torusKnotGeometry(segments: number): BufferGeometry {
  const round = Math.min(64, Math.max(8, Math.round(segments / 8)));
  return new TorusKnotGeometry(RADIUS, TUBE, segments, round);
}
