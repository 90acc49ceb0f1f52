// Explains one fragment of a viewer's picture, with each light's terms by the equation in float64:
// at the fragment, or under Gouraud shading at the triangle's corners, interpolated.
import type { Mesh } from 'three';
import type { LightValues, Term } from '../../phong/light/light-state.js';
import { add, map, subtract, type Vec3 } from '../../phong/math/vector.js';
import { coefficientsOf, type LightShare, shade, sumOf } from '../../phong/reference/equation.js';
import type {
  FragmentExplanation,
  PhongMesh,
  PhongViewer,
  ViewerSnapshot,
} from '../../viewer/extra.js';
import { type Hit, pick, pickNear, shadedPoint } from './pick.js';
import { inTasks } from './in-tasks.js';
import { weighted } from './ray-triangles.js';

/** Rejects with TypeError or RangeError unless x and y are finite numbers. */
export async function shadeAt(
  { scene, width, height, lights }: ViewerSnapshot,
  x: number,
  y: number,
  { exact = false }: Parameters<PhongViewer['shadeAt']>[2] = {},
): Promise<FragmentExplanation | null> {
  const column = pixel('x', x, width, scene?.width ?? 0, exact);
  const row = pixel('y', y, height, scene?.height ?? 0, exact);
  return scene === null ? null : explained(await inTasks(pick(scene, column, row)), lights);
}

/** Explains the surface at a point in world space. */
export async function explain(
  { scene, lights }: ViewerSnapshot,
  point: unknown,
): Promise<FragmentExplanation | null> {
  if (!Array.isArray(point) || point.length !== 3 || !point.every((x) => typeof x === 'number')) {
    throw new TypeError(`explain: expected a point of three numbers, got ${String(point)}`);
  }
  if (!point.every(Number.isFinite)) {
    throw new RangeError(`explain: the point must be finite, got ${String(point)}`);
  }
  if (scene === null) return null;
  return explained(await inTasks(pickNear(scene, point as unknown as Vec3)), lights);
}

function explained(
  hit: Hit<PhongMesh | PhongViewer> | null,
  lights: ViewerSnapshot['lights'],
): FragmentExplanation | null {
  if (hit === null) return null;
  const { object, owner, phong } = hit.drawn;
  const lightsHere = lights.map(({ values }) => relative(values, hit.frame.origin));
  const { surface, shaded } = shadeHit(hit, lightsHere);
  const { ka, kd, ks } = coefficientsOf(surface, phong.linear);
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
    filtered: hit.filtered,
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

/**
 * The device pixel at CSS pixel `at`; the GPU draws the fragment at its centre. `exact`: the place
 * from there.
 */
function pixel(name: string, at: unknown, size: number, pixels: number, exact: boolean): number {
  if (typeof at !== 'number') {
    throw new TypeError(`shadeAt: ${name} must be a number of CSS pixels, got ${String(at)}`);
  }
  if (!Number.isFinite(at)) {
    throw new RangeError(`shadeAt: ${name} must be finite, got ${String(at)}`);
  }
  const place = (at * pixels) / size;
  return exact ? place - 0.5 : Math.floor(place);
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

/**
 * The surface at a hit, and what the picture shows there. Lights are relative to the frame's
 * origin, like the hit.
 */
function shadeHit(hit: Hit, lights: readonly LightValues[]) {
  const { frame, weights } = hit;
  const { style, linear } = hit.drawn.phong;
  const { corners, surface, normal } = shadedPoint(hit);
  const options = { camera: frame, reflection: style.reflection, terms: style.terms, linear };
  const at = (p: Vec3, N: Vec3) =>
    shade({ p, normal: N, eye: frame.eye }, surface, lights, options);
  const here = at(hit.p, normal);
  if (style.shading !== 'gouraud') return { surface, shaded: here };
  const [a, b, c] = corners;
  // Only terms and sum come from the corners, which use the fragment's base colour, so that it is
  // not interpolated.
  const shaded = [at(a.p, a.N), at(b.p, b.N), at(c.p, c.N)] as const;
  const shares = here.shares.map((share, i) => {
    if (share === null) return null;
    const term = (name: Term): Vec3 => {
      const [x, y, z] = shaded;
      return weighted(weights, [x.shares[i]![name], y.shares[i]![name], z.shares[i]![name]]);
    };
    return {
      ...share,
      ambient: term('ambient'),
      diffuse: term('diffuse'),
      specular: term('specular'),
    };
  });
  return { surface, shaded: { ...here, shares, ...sumOf(shares, surface, linear) } };
}

/**
 * A light with its position relative to `origin`: subtracting first keeps precision far from the
 * world's origin.
 */
function relative(values: LightValues, origin: Vec3): LightValues {
  const [x, y, z, w] = values.position;
  if (w === 0 || values.space === 'camera') return values;
  return { ...values, position: [...subtract([x, y, z], origin), 1] };
}
