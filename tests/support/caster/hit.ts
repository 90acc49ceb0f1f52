// Where a ray meets a surface. Rays start at the eye and are `t · direction`; `t` is the depth, since directions have
// length 1 along the view. One record is written over and over: nothing is allocated per ray.

export interface Hit {
  /** Infinity: nothing is met. */
  t: number;
  /** Outward normal, any length; in the space of whoever wrote it. */
  nx: number;
  ny: number;
  nz: number;
  /** Seen from the front. */
  front: boolean;
  u: number;
  v: number;
  /** Index of the object in its scene. */
  object: number;
}

export const newHit = (): Hit => ({
  ...{ t: Infinity, nx: 0, ny: 0, nz: 0 },
  ...{ front: true, u: 0, v: 0, object: -1 },
});

/** Finds the first hit nearer than `hit.t` and writes it there; back faces only where `culled` is false. */
export type Intersect = (
  ox: number,
  oy: number,
  oz: number,
  dx: number,
  dy: number,
  dz: number,
  culled: boolean,
  hit: Hit,
) => boolean;
