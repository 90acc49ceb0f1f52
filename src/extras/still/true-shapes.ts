// Rays against the round shapes of the second degree, in closed form and in the shapes' own space.
import { add, dot, scale, type Vec3 } from '../../phong/math/vector.js';
import type { Hit, Intersect } from './hit.js';
import type { TrueShape } from './cast-scene.js';

const RADIUS = 0.5;
const HALF_HEIGHT = 0.5;

export const trueShape = (kind: TrueShape['kind']): Intersect =>
  ({ sphere, cylinder: tapered(RADIUS), cone: tapered(0) })[kind];

/** The place at `t` on a ray. */
const at = (o: Vec3, d: Vec3, t: number): Vec3 => add(o, scale(d, t));

/**
 * Writes a hit if it is the nearest so far and before the eye. `d`: the ray's direction; `n`: the
 * normal.
 */
function offer(hit: Hit, t: number, d: Vec3, n: Vec3): boolean {
  if (!(t > 0 && t < hit.t)) return false;
  hit.t = t;
  hit.normal = n;
  hit.front = dot(n, d) < 0;
  return true;
}

const sphere: Intersect = (o, d, hit) => {
  const a = dot(d, d);
  const middle = -dot(o, d) / a;
  // From the sphere's centre to the ray's nearest point: the discriminant without cancellation.
  const m = at(o, d, middle);
  const inside = RADIUS * RADIUS - dot(m, m);
  if (inside < 0) return false;
  const half = Math.sqrt(inside / a);
  return [middle - half, middle + half].some((t) => offer(hit, t, d, at(o, d, t)));
};

/** Roots of a t² + 2 b t + c, in ascending order. */
function forQuadratic(a: number, b: number, c: number, offered: (t: number) => boolean): boolean {
  const discriminant = b * b - a * c;
  if (!(discriminant >= 0)) return false;
  const q = -(b + Math.sign(b || 1) * Math.sqrt(discriminant));
  const [first, second] = [q / a, c / q];
  const near = offered(Math.min(first, second));
  return offered(Math.max(first, second)) || near;
}

/** x² + z² = (top + slope (h − y))², with flat ends. `top`: the radius there. */
const tapered =
  (top: number): Intersect =>
  (o, d, hit) => {
    const slope = (RADIUS - top) / (2 * HALF_HEIGHT);
    const [ox, oy, oz] = o;
    const [dx, dy, dz] = d;
    const radius = (y: number): number => top + slope * (HALF_HEIGHT - y);
    const width = radius(oy);
    const a = dx * dx + dz * dz - slope * slope * dy * dy;
    const b = ox * dx + oz * dz + slope * width * dy;
    let met = forQuadratic(a, b, ox * ox + oz * oz - width * width, (t) => {
      const [x, y, z] = at(o, d, t);
      if (!(Math.abs(y) <= HALF_HEIGHT)) return false; // the other half of the double cone, too
      return offer(hit, t, d, [x, slope * radius(y), z]);
    });
    for (const up of [1, -1]) {
      const t = (up * HALF_HEIGHT - oy) / dy;
      const [x, , z] = at(o, d, t);
      const r = radius(up * HALF_HEIGHT);
      met = (x * x + z * z <= r * r && offer(hit, t, d, [0, up, 0])) || met;
    }
    return met;
  };
