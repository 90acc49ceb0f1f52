// Where a ray meets a surface. Rays start at the eye and are `t · direction`; `t` is the depth,
// since directions have length 1 along the view. One record is written over and over.
import type { Vec3 } from '../../phong/math/vector.js';

export interface Hit {
  /** Infinity: nothing is met. */
  t: number;
  /** Outward normal, any length; in the space of whoever wrote it. */
  nx: number;
  ny: number;
  nz: number;
  /** Seen from the front. */
  front: boolean;
  /** Index of the object in its scene. */
  object: number;
  /** Of the object's triangles; -1 on a true shape. */
  triangle: number;
  /** Shares of a triangle's corners; they add up to 1. */
  a: number;
  b: number;
  c: number;
}

export const newHit = (): Hit => ({
  t: Infinity,
  nx: 0,
  ny: 0,
  nz: 0,
  front: true,
  object: -1,
  triangle: -1,
  a: 0,
  b: 0,
  c: 0,
});

/** Finds the first hit nearer than `hit.t` of a ray from `o` along `d`, and writes it there. */
export type Intersect = (o: Vec3, d: Vec3, hit: Hit) => boolean;
