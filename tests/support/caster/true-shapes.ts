// Rays against the true round shapes, in closed form and in the shapes' own space.
import type { Hit, Intersect } from './hit.js';
import { rootsIn } from './polynomial.js';
import type { TrueShape } from './scene.js';

const RADIUS = 0.5;
const HALF_HEIGHT = 0.5;

export function trueShape(shape: TrueShape): Intersect {
  switch (shape.kind) {
    case 'sphere':
      return sphere;
    case 'cylinder':
      return cylinder;
    case 'cone':
      return cone;
    case 'torus':
      return torus(shape.ring ?? 0.35, shape.tube ?? 0.15);
  }
}

/** Writes a hit if it is the nearest so far, before the eye, and on a side that is there. */
function offer(
  hit: Hit,
  culled: boolean,
  t: number,
  nx: number,
  ny: number,
  nz: number,
  facing: number,
): boolean {
  const front = facing < 0;
  if (!(t > 0 && t < hit.t) || (culled && !front)) return false;
  hit.t = t;
  hit.nx = nx;
  hit.ny = ny;
  hit.nz = nz;
  hit.front = front;
  return true;
}

const sphere: Intersect = (ox, oy, oz, dx, dy, dz, culled, hit) => {
  const a = dx * dx + dy * dy + dz * dz;
  const middle = -(ox * dx + oy * dy + oz * dz) / a;
  // From the sphere's centre to the ray's nearest point: the discriminant without cancellation.
  const mx = ox + middle * dx;
  const my = oy + middle * dy;
  const mz = oz + middle * dz;
  const inside = RADIUS * RADIUS - (mx * mx + my * my + mz * mz);
  if (inside < 0) return false;
  const half = Math.sqrt(inside / a);
  const at = (t: number): boolean => {
    const x = ox + t * dx;
    const y = oy + t * dy;
    const z = oz + t * dz;
    return offer(hit, culled, t, x, y, z, x * dx + y * dy + z * dz);
  };
  return at(middle - half) || at(middle + half);
};

/** A flat end at this y, whose normal points up or down. */
function end(
  y: number,
  up: 1 | -1,
  ...[ox, oy, oz, dx, dy, dz, culled, hit]: Parameters<Intersect>
): boolean {
  const t = (y - oy) / dy;
  const [x, z] = [ox + t * dx, oz + t * dz];
  return x * x + z * z <= RADIUS * RADIUS && offer(hit, culled, t, 0, up, 0, up * dy);
}

/** Roots of a t² + 2 b t + c, in ascending order. */
function forQuadratic(a: number, b: number, c: number, at: (t: number) => boolean): boolean {
  const discriminant = b * b - a * c;
  if (!(discriminant >= 0)) return false;
  const q = -(b + Math.sign(b || 1) * Math.sqrt(discriminant));
  const [first, second] = [q / a, c / q];
  const near = at(Math.min(first, second));
  return at(Math.max(first, second)) || near;
}

const cylinder: Intersect = (ox, oy, oz, dx, dy, dz, culled, hit) => {
  const side = forQuadratic(
    dx * dx + dz * dz,
    ox * dx + oz * dz,
    ox * ox + oz * oz - RADIUS * RADIUS,
    (t) => {
      const x = ox + t * dx;
      const y = oy + t * dy;
      const z = oz + t * dz;
      return Math.abs(y) <= HALF_HEIGHT && offer(hit, culled, t, x, 0, z, x * dx + z * dz);
    },
  );
  const top = end(HALF_HEIGHT, 1, ox, oy, oz, dx, dy, dz, culled, hit);
  return end(-HALF_HEIGHT, -1, ox, oy, oz, dx, dy, dz, culled, hit) || top || side;
};

/** The apex is at the top: x² + z² = (k (h − y))². */
const cone: Intersect = (ox, oy, oz, dx, dy, dz, culled, hit) => {
  const slope = RADIUS / (2 * HALF_HEIGHT);
  const k = slope * slope;
  const below = HALF_HEIGHT - oy;
  const side = forQuadratic(
    dx * dx + dz * dz - k * dy * dy,
    ox * dx + oz * dz + k * below * dy,
    ox * ox + oz * oz - k * below * below,
    (t) => {
      const x = ox + t * dx;
      const y = oy + t * dy;
      const z = oz + t * dz;
      if (!(Math.abs(y) <= HALF_HEIGHT)) return false; // the other half of the double cone, too
      const out = k * (HALF_HEIGHT - y);
      return offer(hit, culled, t, x, out, z, x * dx + out * dy + z * dz);
    },
  );
  return end(-HALF_HEIGHT, -1, ox, oy, oz, dx, dy, dz, culled, hit) || side;
};

/** (|p|² + R² − r²)² = 4 R² (x² + y²). */
function torus(ring: number, tube: number): Intersect {
  const roots = new Float64Array(4);
  const outer = ring + tube;
  return (ox, oy, oz, dx, dy, dz, culled, hit) => {
    const a = dx * dx + dy * dy + dz * dz;
    // From the ray's point nearest to the centre, in units of its direction made unit: coefficients stay near 1.
    const middle = -(ox * dx + oy * dy + oz * dz) / a;
    const mx = ox + middle * dx;
    const my = oy + middle * dy;
    const mz = oz + middle * dz;
    const squared = mx * mx + my * my + mz * mz;
    if (squared > outer * outer) return false;
    const length = Math.sqrt(a);
    const ux = dx / length;
    const uy = dy / length;
    const uz = dz / length;
    const reach = Math.sqrt(outer * outer - squared);
    const least = Math.min(Math.abs(mz - reach * uz), Math.abs(mz + reach * uz));
    if (least > tube && mz * mz > reach * reach * uz * uz) return false;
    const k = squared + ring * ring - tube * tube;
    const four = 4 * ring * ring;
    const count = rootsIn(
      [
        k * k - four * (mx * mx + my * my),
        -2 * four * (mx * ux + my * uy),
        2 * k - four * (ux * ux + uy * uy),
        0,
        1,
      ],
      -reach - tube,
      reach + tube,
      roots,
    );
    for (let i = 0; i < count; i++) {
      const s = roots[i]!;
      const x = mx + s * ux;
      const y = my + s * uy;
      const z = mz + s * uz;
      const across = Math.hypot(x, y);
      const shrink = 1 - ring / across;
      const nx = x * shrink;
      const ny = y * shrink;
      if (offer(hit, culled, middle + s / length, nx, ny, z, nx * ux + ny * uy + z * uz)) return true;
    }
    return false;
  };
}
