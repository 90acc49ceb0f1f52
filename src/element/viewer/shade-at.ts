// Explains one fragment of a viewer's picture: what a pixel shows, with each light's terms by the equation in float64. That
// code is fetched with the first explanation. Knows nothing of rays or triangles.
import type { Mesh } from 'three';
import type { LightValues } from '../../light/light-state.js';
import { add, map, type Vec3 } from '../../math/vector.js';
import type { LightShare, Shaded } from '../../reference/index.js';
import { lazyCode } from '../../scene/lazy-code.js';
import { cornersOf } from '../../scene/snapshot/corners.js';
import { type Hit, pick } from '../../scene/snapshot/pick.js';
import { type SurfaceHere, surfaceAt } from '../../scene/snapshot/surface-at.js';
import type { ViewerSnapshot } from './viewer-snapshot.js';
import type { PhongLight } from '../phong-light.js';
import type { PhongMesh } from '../phong-mesh.js';
import type { PhongViewer } from '../phong-viewer.js';
import { type Equation, relative, shadeHit } from './shade-hit.js';

/** One light's share of a fragment. Frozen. */
export interface LightExplanation extends LightShare {
  /** The light's element; null for the head-light of a viewer without lights. */
  readonly light: PhongLight | null;
  /** Its name as the panel shows it. */
  readonly name: string;
}

/** One fragment by the equation in float64. Frozen; lengths in scene units, vectors in world space. */
export interface FragmentExplanation {
  /** The point on the surface. */
  readonly p: Vec3;
  /** Unit normal, interpolated and flipped toward the visible side; zero where the surface has none. */
  readonly N: Vec3;
  /** Unit vector toward the eye. */
  readonly V: Vec3;
  /** The element the surface belongs to: a `<phong-mesh>`, or the viewer for its own `src` or `geometry`. */
  readonly mesh: PhongMesh | PhongViewer;
  /** Its object in {@link PhongViewer.scene}. */
  readonly object: Mesh;
  /** The object's triangle, counted from 0 in the order of its geometry's index. */
  readonly triangle: number;
  /** Ka, Kd and Ks as the equation uses them: 0–1, with base colour and metalness, decoded if shading is linear. */
  readonly ka: Vec3;
  readonly kd: Vec3;
  readonly ks: Vec3;
  /** The specular exponent n. */
  readonly shininess: number;
  /** The factor of ka and kd from a model's own colour, texture and vertex colours. Encoded sRGB, 0–1; 1 1 1 without any. */
  readonly baseColor: Vec3;
  /** E, what the surface adds to the sum itself. Encoded sRGB; black for most. */
  readonly emissive: Vec3;
  /** m, 0–1: ka, kd and ks above include it. */
  readonly metalness: number;
  /** The colour is the base colour, whatever the lights; ka, kd and ks are black. */
  readonly unlit: boolean;
  /** How much of `color` the picture shows, 0–1; the rest comes from what lies behind. */
  readonly opacity: number;
  /**
   * One for each of {@link PhongViewer.lights}, in their order, null if it is not active; or the head-light alone. The
   * terms of all of them add up to the sum.
   */
  readonly shares: readonly (LightExplanation | null)[];
  /** The sum over the lights before it is clamped; encoded if shading is linear. 1 is full. */
  readonly sum: Vec3;
  /** The colour drawn: the sum clamped to 0–1. */
  readonly color: Vec3;
}

const referenceCode = lazyCode(() => import('../../reference/index.js'), 'shadeAt');

/** Rejects with TypeError or RangeError unless x and y are finite numbers. */
export async function shadeAt(
  { scene, width, height, lights }: ViewerSnapshot,
  x: number,
  y: number,
): Promise<FragmentExplanation | null> {
  const column = pixel('x', x, width, scene?.width ?? 0);
  const row = pixel('y', y, height, scene?.height ?? 0);
  const hit = scene === null ? null : pick(scene, column, row);
  if (hit === null) return null;
  const { object, owner, phong } = hit.drawn;
  const equation = await referenceCode();
  const { surface, shaded } = shadedAt(
    equation,
    hit,
    lights.map(({ values }) => relative(values, hit.frame.origin)),
  );
  const { ka, kd, ks } = equation.coefficientsOf(surface, phong.linear);
  const { color: baseColor, opacity } = hit.base;
  return Object.freeze({
    p: frozen(add(hit.frame.origin, hit.p)),
    N: frozen(shaded.N),
    V: frozen(shaded.V),
    mesh: owner,
    object: object as Mesh,
    triangle: hit.triangle,
    ka: frozen(ka),
    kd: frozen(kd),
    ks: frozen(ks),
    shininess: surface.shininess,
    baseColor: frozen(baseColor),
    emissive: frozen(surface.emissive),
    metalness: surface.metalness,
    unlit: surface.unlit,
    opacity,
    shares: Object.freeze(
      shaded.shares.map((share, i) => {
        const { light, name } = lights[i]!;
        return share === null ? null : Object.freeze({ light, name, ...frozenVectors(share) });
      }),
    ),
    sum: frozen(shaded.sum),
    color: frozen(shaded.color),
  });
}

/** What the picture shows of a hit, and its surface. `lights` are relative to the frame's origin. */
export function shadedAt(
  equation: Equation,
  hit: Hit,
  lights: readonly LightValues[],
): { readonly surface: SurfaceHere; readonly shaded: Shaded } {
  const { phong, geometry } = hit.drawn;
  const surface = surfaceAt(phong, geometry, hit, hit.base);
  return { surface, shaded: shadeHit(equation, { hit, corners: cornersOf(hit), surface }, lights) };
}

export { pick, relative };

/** The device pixel at CSS pixel `at`. The GPU draws the fragment at its centre. */
function pixel(name: string, at: unknown, size: number, pixels: number): number {
  if (typeof at !== 'number')
    throw new TypeError(`shadeAt: ${name} must be a number of CSS pixels, got ${String(at)}`);
  if (!Number.isFinite(at)) throw new RangeError(`shadeAt: ${name} must be finite, got ${String(at)}`);
  return Math.floor((at * pixels) / size);
}

/** Adding 0 turns -0 into 0, so that equal vectors print alike. */
const frozen = (v: Vec3): Vec3 => Object.freeze(map(v, (x) => x + 0));

const frozenVectors = (share: LightShare): LightShare => ({
  ...share,
  L: frozen(share.L),
  ambient: frozen(share.ambient),
  diffuse: frozen(share.diffuse),
  specular: frozen(share.specular),
});
