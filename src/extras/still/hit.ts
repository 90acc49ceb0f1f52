// Where a ray meets a surface. Rays start at the eye and are `t · direction`; `t` is the depth,
// since directions have length 1 along the view. Records are written over and over.
import type { Vec3 } from '../../phong/math/vector.js';

export class Hit {
  /** Infinity: nothing is met. */
  t = Infinity;
  /** Unit, or zero; in world space. */
  normal: Vec3 = [0, 0, 0];
  /** Seen from the front. */
  front = true;
  /** Index among all triangles, in the scene's order. */
  thing = -1;
  /** Index of the object in its scene. */
  object = -1;
  /** Index among the object's triangles. */
  triangle = -1;
  /** Shares of a triangle's corners; they add up to 1. */
  a = 0;
  b = 0;
  c = 0;
}
