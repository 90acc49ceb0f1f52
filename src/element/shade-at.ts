// One fragment of a viewer's picture, explained: what is seen at a pixel joined with the lights, term by term, by the
// equation in float64, whose code is fetched with the first explanation. Knows nothing of rays or triangles.
import type { Mesh } from 'three';
import type { LightValues } from '../light/light-state.js';
import { srgbDecode } from '../math/color.js';
import { add, multiply, scale, subtract, type Vec3 } from '../math/vector.js';
import type { LightShare } from '../reference/index.js';
import { cornersOf } from '../scene/pick/corners.js';
import type { Viewport } from '../scene/viewport.js';
import type { PhongLight } from './phong-light.js';
import type { PhongMesh } from './phong-mesh.js';
import type { PhongViewer } from './phong-viewer.js';
import { shadeHit, type Subject } from './shade-hit.js';
import type { ViewerChildren } from './viewer-children.js';

/** One light's part in a fragment. Frozen. */
export interface LightExplanation extends LightShare {
  /** The light's element; null for the light at the eye that a viewer without any light has. */
  readonly light: PhongLight | null;
  /** Its name as the panel shows it. */
  readonly name: string;
}

/** What the equation makes of one fragment, in float64. Frozen; lengths in scene units, vectors in world space. */
export interface FragmentExplanation {
  /** The point of the surface. */
  readonly p: Vec3;
  /** Unit normal, interpolated and turned to the side that is seen; zero where the surface has none. */
  readonly N: Vec3;
  /** Unit vector toward the eye. */
  readonly V: Vec3;
  /** Whose surface it is: a child, or the viewer itself for its own `src` or `geometry`. */
  readonly mesh: PhongMesh | PhongViewer;
  /** The part of it in {@link PhongViewer.scene}. */
  readonly object: Mesh;
  /** Which of the object's triangles, counted from 0 in the order of its geometry's index. */
  readonly triangle: number;
  /** Ka, Kd and Ks as the equation takes them: 0–1 a channel, times the base colour, decoded where shading is linear. */
  readonly ka: Vec3;
  readonly kd: Vec3;
  readonly ks: Vec3;
  /** The specular exponent n. */
  readonly shininess: number;
  /** What of ka and kd a model's own colour, texture and vertex colours make. Encoded sRGB, 0–1; 1 1 1 without any. */
  readonly baseColor: Vec3;
  /** How much of `color` the picture shows, 0–1; the rest is what lies behind. */
  readonly opacity: number;
  /**
   * One for each of {@link PhongViewer.lights}, in their order, null where it is not active; or the one light at the eye
   * of a viewer without any. The terms of all of them add up to the sum.
   */
  readonly shares: readonly (LightExplanation | null)[];
  /** The sum over the lights before it is clamped; encoded where shading is linear. 1 is full. */
  readonly sum: Vec3;
  /** As it is drawn: the sum clamped to 0–1. */
  readonly color: Vec3;
}

export interface ShadeAtHost {
  readonly viewer: PhongViewer;
  readonly viewport: Viewport;
  readonly children: Pick<ViewerChildren, 'elementOf' | 'lightOf'>;
  /** The picture's, in CSS pixels before any transform or zoom. */
  readonly size: { readonly width: number; readonly height: number };
}

/** Rejects with TypeError or RangeError where x or y is no finite number. */
export async function shadeAt(host: ShadeAtHost, x: number, y: number): Promise<FragmentExplanation | null> {
  const { viewport, size, children } = host;
  const { holder } = viewport;
  // Inside CSS zoom pointer events count in the page's pixels, sizes in the element's own. Not all browsers know the name.
  const zoom = (holder as { currentCSSZoom?: number }).currentCSSZoom ?? 1;
  const column = pixel('x', x, size.width * zoom, viewport.width);
  const row = pixel('y', y, size.height * zoom, viewport.height);
  const isPlaced = holder.getClientRects().length > 0;
  const hit = isPlaced ? viewport.pick(column, row) : null;
  const mesh = hit === null ? undefined : viewport.meshOf(hit.object);
  if (hit === null || mesh === undefined) return null;
  // Whatever may change until the equation's code is here is taken now.
  const { surface, style, linear } = hit.material;
  const subject: Subject = { hit, corners: cornersOf(hit), surface, style, linear };
  const element = children.elementOf(mesh) ?? host.viewer;
  const lights = viewport.lighting.lights.lights.map((state) => {
    const light = children.lightOf(state);
    return { light, name: light?.name ?? 'head-light', values: relative(state.values, hit.frame.origin) };
  });
  const { shade } = await import('../reference/index.js');
  const shaded = shadeHit(
    shade,
    subject,
    lights.map(({ values }) => values),
  );
  const { color: baseColor, opacity } = hit.base;
  return Object.freeze({
    p: frozen(add(hit.frame.origin, hit.p)),
    N: frozen(shaded.N),
    V: frozen(shaded.V),
    mesh: element,
    object: hit.object,
    triangle: hit.triangle,
    ka: coefficient(surface.ka, baseColor, linear),
    kd: coefficient(surface.kd, baseColor, linear),
    ks: coefficient(surface.ks, WHITE, linear),
    shininess: surface.shininess,
    baseColor: frozen(baseColor),
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

/** Which device pixel lies at CSS pixel `at`: the fragment that the GPU draws is the one at its centre. */
function pixel(name: string, at: unknown, size: number, pixels: number): number {
  if (typeof at !== 'number')
    throw new TypeError(`shadeAt: ${name} must be a number of CSS pixels, got ${String(at)}`);
  if (!Number.isFinite(at)) throw new RangeError(`shadeAt: ${name} must be finite, got ${String(at)}`);
  return Math.floor((at * pixels) / size);
}

/** A snapshot of a light with its place relative to `origin`: far from the world's origin differences come first. */
function relative(values: Readonly<LightValues>, origin: Vec3): LightValues {
  const [x, y, z, w] = values.position;
  if (w === 0 || values.space === 'camera') return { ...values };
  return { ...values, position: [...subtract([x, y, z], origin), 1] };
}

/** 255 to 1, times the base colour. */
function coefficient(k: Vec3, base: Vec3, linear: boolean): Vec3 {
  const decoded = (v: Vec3): Vec3 => (linear ? map(v, srgbDecode) : v);
  return frozen(multiply(decoded(scale(k, 1 / 255)), decoded(base)));
}

const WHITE: Vec3 = [1, 1, 1];

const map = (v: Vec3, f: (x: number) => number): Vec3 => [f(v[0]), f(v[1]), f(v[2])];

/** Adding 0 turns -0 into 0, so that equal vectors print alike. */
const frozen = (v: Vec3): Vec3 => Object.freeze(map(v, (x) => x + 0));

const frozenVectors = (share: LightShare): LightShare => ({
  ...share,
  L: frozen(share.L),
  ambient: frozen(share.ambient),
  diffuse: frozen(share.diffuse),
  specular: frozen(share.specular),
});
