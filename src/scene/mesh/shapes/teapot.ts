// The Utah teapot in three.js's size, spout toward +x. In a chunk of its own because of its table of control points.
import type { BufferGeometry } from 'three';
import { TeapotGeometry } from 'three/addons/geometries/TeapotGeometry.js';

/** Bézier patches that make one turn round the body. */
const PATCHES_AROUND = 4;

/** @param segments once round the body, at least 12; rounded to whole divisions of a patch. */
export function teapotGeometry(segments: number): BufferGeometry {
  return new TeapotGeometry(1, Math.round(segments / PATCHES_AROUND));
}
