// Shades one hit by the equation: at the fragment, or under Gouraud shading at the triangle's corners, interpolated.
import type { LightValues, Term } from '../../light/light-state.js';
import { add, scale, subtract, type Vec3, type Vec4 } from '../../math/vector.js';
import type { shade as Shade, Shaded, sumOf as SumOf } from '../../reference/index.js';
import { cornersOf } from '../../scene/snapshot/corners.js';
import type { Hit } from '../../scene/snapshot/pick.js';
import { mappedNormalAt, type SurfaceHere, surfaceAt } from '../../scene/snapshot/surface-at.js';

/** The equation's code, which is loaded with the first explanation. */
export interface ReferenceCode {
  readonly shade: typeof Shade;
  readonly sumOf: typeof SumOf;
}

/**
 * The surface at a hit, and what the picture shows there. Lights are relative to the frame's origin, like the hit.
 * Under Gouraud shading only the terms and their sum come from the corners; everything else is the fragment's own.
 */
export function shadeHit(
  equation: ReferenceCode,
  hit: Hit,
  lights: readonly LightValues[],
): { readonly surface: SurfaceHere; readonly shaded: Shaded } {
  const { frame, weights } = hit;
  const { phong, geometry } = hit.drawn;
  const corners = cornersOf(hit);
  const surface = surfaceAt(phong, geometry, hit, hit.base);
  const { style, linear } = phong;
  const options = { camera: frame, reflection: style.reflection, terms: style.terms, linear };
  const at = (p: Vec3, normal: Vec3): Shaded => equation.shade({ p, normal, eye: frame.eye }, surface, lights, options);
  const [a, b, c] = corners;
  const N = weighted(weights, [a.N, b.N, c.N]);
  const here = at(hit.p, mappedNormalAt(phong, geometry, hit, N, tangentAt(weights, corners)));
  if (style.shading !== 'gouraud') return { surface, shaded: here };
  // All corners use the fragment's base colour, so that it is not interpolated.
  const shaded = [at(a.p, a.N), at(b.p, b.N), at(c.p, c.N)] as const;
  const shares = here.shares.map((share, i) => {
    if (share === null) return null;
    const term = (name: Term): Vec3 => {
      const [x, y, z] = shaded;
      return weighted(weights, [x.shares[i]![name], y.shares[i]![name], z.shares[i]![name]]);
    };
    return { ...share, ambient: term('ambient'), diffuse: term('diffuse'), specular: term('specular') };
  });
  return { surface, shaded: { ...here, shares, ...equation.sumOf(shares, surface, linear) } };
}

/** A light with its position relative to `origin`: subtracting first keeps precision far from the world's origin. */
export function relative(values: LightValues, origin: Vec3): LightValues {
  const [x, y, z, w] = values.position;
  if (w === 0 || values.space === 'camera') return values;
  return { ...values, position: [...subtract([x, y, z], origin), 1] };
}

const weighted = (weights: Vec3, [a, b, c]: readonly [Vec3, Vec3, Vec3]): Vec3 =>
  add(add(scale(a, weights[0]), scale(b, weights[1])), scale(c, weights[2]));

function tangentAt(weights: Vec3, corners: ReturnType<typeof cornersOf>): Vec4 | null {
  const [a, b, c] = corners.map(({ tangent }) => tangent);
  if (!a || !b || !c) return null;
  const mix = (i: 0 | 1 | 2 | 3): number => a[i] * weights[0] + b[i] * weights[1] + c[i] * weights[2];
  return [mix(0), mix(1), mix(2), mix(3)];
}
