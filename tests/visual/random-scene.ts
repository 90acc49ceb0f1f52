// Random scenes as data and as markup, from a seed that failures print. Values are what authors
// write: moderate numbers with a few decimals.
import type { LightValues } from '../../src/phong/light/light-state.js';
import { scale, type Vec3, type Vec4 } from '../../src/phong/math/vector.js';
import { lightWith } from '../stress/case.js';
import { Random } from '../stress/random.js';
import type { CastMesh, DeclaredScene } from './ray-cast.js';

/** Uniform numbers from a seed: mulberry32. */
export function seeded(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = state;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

export class Dice extends Random {
  constructor(seed: number) {
    super(seed, seeded(seed));
  }

  /** Uniform, to three decimals. */
  override from(low: number, high: number): number {
    return Number(super.from(low, high).toFixed(3));
  }

  /** One of the list, as often as its weight says. */
  weighted<T>(list: readonly T[], weightOf: (one: T) => number): T {
    let left = this.from(0, 1) * list.reduce((sum, one) => sum + weightOf(one), 0);
    return list.find((one) => (left -= weightOf(one)) <= 0) ?? list[0]!;
  }

  override color(high: number): Vec3 {
    return this.vector(0, high).map(Math.round) as unknown as Vec3;
  }
}

export function randomLight(dice: Dice): LightValues {
  const kind = dice.pick(['directional', 'point', 'spot', 'directional spot'] as const);
  const positional = kind === 'point' || kind === 'spot';
  const spot = kind.endsWith('spot');
  const place = dice.vector(-3, 3);
  const position: Vec4 = [...place, positional ? 1 : 0];
  return lightWith({
    active: dice.chance(0.9),
    ambient: dice.color(40),
    diffuse: dice.color(dice.chance(0.2) ? 400 : 160),
    specular: dice.color(200),
    position,
    axis: spot
      ? ([-place[0], -place[1], -place[2]].map((x) => x + dice.from(-0.5, 0.5)) as unknown as Vec3)
      : [0, 0, -1],
    aperture: spot ? dice.pick([8, 20, 45, 80, 120, 180]) : 180,
    cutoff: spot ? dice.pick([0, 0.5, 1, 4, 20]) : 0,
    attenuation: dice.chance(0.5)
      ? [dice.from(0, 2), dice.from(0, 0.5), dice.from(0, 0.2)]
      : [1, 0, 0],
    space: dice.chance(0.2) ? 'camera' : 'world',
  });
}

/** With a share of its intensities. */
export const dimmed = (light: LightValues, share: number): LightValues => ({
  ...light,
  ambient: scale(light.ambient, share),
  diffuse: scale(light.diffuse, share),
  specular: scale(light.specular, share),
});

export function randomMesh(dice: Dice, geometry: CastMesh['geometry']): CastMesh {
  const size = dice.from(1, 4);
  const turned = dice.chance(0.5);
  return {
    geometry,
    position: dice.chance(0.3) ? dice.vector(-1, 1) : [0, 0, 0],
    rotation: turned ? dice.vector(-180, 180) : [0, 0, 0],
    scale: dice.chance(0.5)
      ? [size, size, size]
      : [size * dice.from(0.5, 2), size, -size * dice.from(0.5, 2)],
    ka: dice.color(255),
    kd: dice.color(255),
    ks: dice.color(255),
    shininess: dice.pick([0, 0.5, 1, 5, 32, 100, 300]),
  };
}

export function randomScene(seed: number, geometry: CastMesh['geometry'] = 'plane'): DeclaredScene {
  const dice = new Dice(seed);
  const count = 1 + Math.floor(dice.from(0, 5.999));
  return {
    pose: {
      theta: dice.from(-180, 180),
      phi: dice.from(5, 175),
      radius: dice.from(2, 6),
      target: dice.chance(0.3) ? dice.vector(-0.5, 0.5) : [0, 0, 0],
    },
    fov: dice.from(20, 70),
    meshes: [randomMesh(dice, geometry)],
    lights: Array.from({ length: count }, () => randomLight(dice)),
    options: {
      reflection: dice.chance(0.3) ? 'blinn-phong' : 'phong',
      terms: dice.chance(0.2)
        ? [dice.pick(['ambient', 'diffuse', 'specular'] as const)]
        : ['ambient', 'diffuse', 'specular'],
      linear: dice.chance(0.3),
    },
  };
}

/** The scene as an author would write it. */
export function sceneMarkup(
  { pose, fov, meshes, lights, options }: DeclaredScene,
  shading = 'phong',
): string {
  const list = (v: readonly number[]) => v.join(' ');
  const mesh = (m: CastMesh) =>
    `<phong-mesh geometry="${m.geometry}" ${m.segments === undefined ? '' : `segments="${m.segments}" `}position="${list(m.position)}" rotation="${list(m.rotation)}" scale="${list(m.scale)}" ` +
    `ka="${list(m.ka)}" kd="${list(m.kd)}" ks="${list(m.ks)}" shininess="${String(m.shininess)}"></phong-mesh>`;
  const light = (l: LightValues) =>
    `<phong-light active="${String(l.active)}" ambient="${list(l.ambient)}" diffuse="${list(l.diffuse)}" ` +
    `specular="${list(l.specular)}" position="${list(l.position)}" axis="${list(l.axis)}" aperture="${String(l.aperture)}" ` +
    `cutoff="${String(l.cutoff)}" attenuation="${list(l.attenuation)}" space="${l.space}"></phong-light>`;
  return (
    `<phong-viewer theta="${String(pose.theta)}" phi="${String(pose.phi)}" radius="${String(pose.radius)}" ` +
    `target="${list(pose.target)}" fov="${String(fov)}" shading="${shading}" reflection="${options.reflection ?? 'phong'}" ` +
    `terms="${(options.terms ?? []).join(' ')}" color-interpolation="${options.linear === true ? 'linear' : 'srgb'}">` +
    `${meshes.map(mesh).join('')}${lights.map(light).join('')}</phong-viewer>`
  );
}
