// Explains one fragment of a viewer's picture: what a pixel shows, with each light's terms by the equation in float64.
// That code is fetched with the first explanation.
import type { Mesh } from 'three';
import { add, map, type Vec3 } from '../../math/vector.js';
import type { LightShare } from '../../reference/index.js';
import { lazyCode } from '../../model/lazy-code.js';
import { type Hit, pick, pickNear } from '../../scene/snapshot/pick.js';
import type { PhongMesh, PhongViewer } from '../elements.js';
import type { FragmentExplanation, ShadeOptions } from '../explanation.js';
import type { ViewerSnapshot } from './viewer-snapshot.js';
import { relative, shadeHit } from './shade-hit.js';

const referenceCode = lazyCode(() => import('../../reference/index.js'), 'shadeAt');

/** Rejects with TypeError or RangeError unless x and y are finite numbers. */
export async function shadeAt(
  { scene, width, height, lights }: ViewerSnapshot,
  x: number,
  y: number,
  { exact = false }: ShadeOptions = {},
): Promise<FragmentExplanation | null> {
  const column = pixel('x', x, width, scene?.width ?? 0, exact);
  const row = pixel('y', y, height, scene?.height ?? 0, exact);
  return explained(scene === null ? null : pick(scene, column, row), lights);
}

/** The same of a point in world space. */
export async function explain({ scene, lights }: ViewerSnapshot, point: unknown): Promise<FragmentExplanation | null> {
  if (!Array.isArray(point) || point.length !== 3 || !point.every((x) => typeof x === 'number'))
    throw new TypeError(`explain: expected a point of three numbers, got ${String(point)}`);
  if (!point.every(Number.isFinite)) throw new RangeError(`explain: the point must be finite, got ${String(point)}`);
  return explained(scene === null ? null : pickNear(scene, point as unknown as Vec3), lights);
}

async function explained(
  hit: Hit<PhongMesh | PhongViewer> | null,
  lights: ViewerSnapshot['lights'],
): Promise<FragmentExplanation | null> {
  if (hit === null) return null;
  const { object, owner, phong } = hit.drawn;
  const equation = await referenceCode();
  const { surface, shaded } = shadeHit(
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

/** The device pixel at CSS pixel `at`; the GPU draws the fragment at its centre. `exact`: the place from there. */
function pixel(name: string, at: unknown, size: number, pixels: number, exact: boolean): number {
  if (typeof at !== 'number') throw new TypeError(`shadeAt: ${name} must be a number of CSS pixels, got ${String(at)}`);
  if (!Number.isFinite(at)) throw new RangeError(`shadeAt: ${name} must be finite, got ${String(at)}`);
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
