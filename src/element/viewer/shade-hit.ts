// Shades one hit by the equation: at the fragment, or under Gouraud shading at the triangle's corners, interpolated. Knows
// neither elements nor how the equation's code is loaded.
import type { LightValues } from '../../light/light-state.js';
import type { SurfaceValues } from '../../material/material-values.js';
import type { ShadingStyle } from '../../material/phong-material.js';
import type { Term } from '../../material/program/variant.js';
import { srgbEncode } from '../../math/color.js';
import { add, map, scale, type Vec3 } from '../../math/vector.js';
import type { shade as Shade, Shaded } from '../../reference/index.js';
import type { Hit } from '../../scene/snapshot/pick.js';
import type { Corner } from '../../scene/snapshot/corners.js';

/** The hit and how it is shaded. */
export interface Subject {
  readonly hit: Hit;
  readonly corners: readonly [Corner, Corner, Corner];
  readonly surface: Readonly<SurfaceValues>;
  readonly style: ShadingStyle;
  readonly linear: boolean;
}

/**
 * Lights are relative to the frame's origin, like the hit. Under Gouraud shading only the terms and their sum come from the
 * corners; everything else is the fragment's own.
 */
export function shadeHit(shade: typeof Shade, subject: Subject, lights: readonly LightValues[]): Shaded {
  const { hit, corners, style, linear } = subject;
  const { frame, weights } = hit;
  const surface = { ...subject.surface, baseColor: hit.base.color };
  const options = { camera: frame, reflection: style.reflection, terms: style.terms, linear };
  const at = ({ p, N }: Corner): Shaded => shade({ p, normal: N, eye: frame.eye }, surface, lights, options);
  const here = at({ p: hit.p, N: weighted(weights, [corners[0].N, corners[1].N, corners[2].N]) });
  if (style.shading !== 'gouraud') return here;
  const atCorners = [at(corners[0]), at(corners[1]), at(corners[2])] as const;
  return withTermsOf(here, atCorners, weights, linear);
}

/** The corners' terms, interpolated. All corners use the fragment's base colour, so that it is not interpolated. */
function withTermsOf(
  here: Shaded,
  [a, b, c]: readonly [Shaded, Shaded, Shaded],
  weights: Vec3,
  linear: boolean,
): Shaded {
  let sum: Vec3 = [0, 0, 0];
  const shares = here.shares.map((share, i) => {
    if (share === null) return null;
    const term = (name: Term): Vec3 =>
      weighted(weights, [a.shares[i]![name], b.shares[i]![name], c.shares[i]![name]]);
    const terms = { ambient: term('ambient'), diffuse: term('diffuse'), specular: term('specular') };
    sum = add(sum, add(add(terms.ambient, terms.diffuse), terms.specular));
    return { ...share, ...terms };
  });
  if (linear) sum = map(sum, srgbEncode);
  return { ...here, shares, sum, color: map(sum, (x) => Math.min(Math.max(x, 0), 1)) };
}

const weighted = (weights: Vec3, [a, b, c]: readonly [Vec3, Vec3, Vec3]): Vec3 =>
  add(add(scale(a, weights[0]), scale(b, weights[1])), scale(c, weights[2]));
