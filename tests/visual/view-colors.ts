// What must a view show of a fragment? From the equation's own numbers in float64, written here again rather than taken
// from src.
import type { View } from '../../src/material/views.js';
import type { Vec3 } from '../../src/math/vector.js';
import type { LightShare } from '../../src/reference/index.js';

/** The part of a result that `shade` and `shadeAt` share. */
export interface Explained {
  readonly N: Vec3;
  readonly shares: readonly (LightShare | null)[];
}

const grey = (value: number): Vec3 => [value, value, value];
const clamped = (value: number): number => Math.min(Math.max(value, 0), 1);

/**
 * The colour of a fragment, 0–1. `shares` are those of the lights that the view is limited to; a view of one light
 * takes the first active one. Not for `shaded`, `triangles` and `error`. Without `linear`: sums are not encoded.
 */
export function viewColor(view: View, { N, shares }: Explained): Vec3 {
  const active = shares.filter((share) => share !== null);
  const [first] = active;
  const sum = (term: 'ambient' | 'diffuse' | 'specular'): Vec3 =>
    [0, 1, 2].map((i) => clamped(active.reduce((all, share) => all + share[term][i]!, 0))) as unknown as Vec3;
  switch (view) {
    case 'ambient':
    case 'diffuse':
    case 'specular':
      return sum(view);
    case 'normals':
      return [(N[0] + 1) / 2, (N[1] + 1) / 2, (N[2] + 1) / 2];
    case 'n-dot-l':
      return grey(clamped(first?.NoL ?? 0));
    case 'r-dot-v':
      return grey(first !== undefined && first.NoL > 0 ? clamped(first.RoV) : 0);
    case 'attenuation':
      return grey(first?.att ?? 0);
    case 'decay':
      return grey(first?.decay ?? 0);
    default:
      throw new Error(`no colour of a fragment: ${view}`);
  }
}
