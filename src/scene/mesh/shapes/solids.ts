// The less common shapes, in one chunk: separate chunks would be smaller than a request costs.
import { type BufferGeometry, ConeGeometry, CylinderGeometry, TorusGeometry } from 'three';
import { pyramidGeometry } from './pyramid.js';
import { torusKnotGeometry } from './torus-knot.js';

// The ring's radius and the tube's add up to the outer radius 1/2.
const TORUS_RING = 0.35;
const TORUS_TUBE = 0.15;
/** Fewest segments round the tube that enclose it. */
const LEAST_TUBE = 3;

export const SOLIDS: Readonly<
  Record<'cylinder' | 'cone' | 'pyramid' | 'torus' | 'torus-knot', (segments: number) => BufferGeometry>
> = {
  cylinder: (n) => new CylinderGeometry(0.5, 0.5, 1, n),
  cone: (n) => new ConeGeometry(0.5, 1, n),
  pyramid: pyramidGeometry,
  torus: (n) => new TorusGeometry(TORUS_RING, TORUS_TUBE, Math.max(LEAST_TUBE, Math.round(n / 2)), n),
  'torus-knot': torusKnotGeometry,
};
