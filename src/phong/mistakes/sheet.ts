// The sheet of test scenes: each has one lamp, and each point sees the lamp, the surface and the
// eye in another way. Together they make every usual mistake visible. The same in each run, and
// with three decimals, so that others can read it as numbers.
import type { LightKind, Term } from '../light/light-state.js';
import { radians } from '../math/angle.js';
import {
  add,
  cross,
  dot,
  length,
  map,
  normalize,
  ORIGIN,
  perpendicular,
  scale,
  subtract,
  type Vec3,
  type Vec4,
} from '../math/vector.js';
import { BLACK, eachTerm, type Given, placeOf, toLightOf } from './steps.js';

/** What an exercise asks for. */
export interface Task {
  readonly kinds: readonly LightKind[];
  readonly terms: readonly Term[];
  readonly reflection: Given['reflection'];
}

export type Lamp = Given['light'];

/** A lamp beside a sphere of radius 1 around the origin, with the eye on the positive z axis. */
export interface Scene {
  readonly kind: LightKind;
  readonly position: Vec4;
  readonly axis: Vec3;
  readonly aperture: number;
  readonly cutoff: number;
  readonly attenuation: Vec3;
  readonly shininess: number;
  /** Least length of a normal; the greatest is 1. */
  readonly normal: number;
}

const AXIS: Vec3 = [0, 0, -1];
export const NO_CONE = { axis: AXIS, aperture: 180, cutoff: 0 };

const scene = (
  kind: LightKind,
  position: Vec4,
  shininess: number,
  rest: Partial<Scene> = {},
): Scene => ({
  kind,
  position,
  ...NO_CONE,
  attenuation: [1, 0, 0],
  shininess,
  normal: 0.5,
  ...rest,
});

export const SCENES = {
  sun: scene('directional', [1.2, 1.6, 1.4, 0], 6, { attenuation: [0.4, 0.3, 0.2] }),
  behind: scene('directional', [-0.9, 0.5, -1.1, 0], 1, { normal: 0.8 }),
  sharp: scene('directional', [0.4, 0.5, 0.6, 0], 120, { normal: 0.9 }),
  lamp: scene('point', [1.4, 1.6, 1.8, 1], 12, { attenuation: [0.4, 0.3, 0.25] }),
  near: scene('point', [0.4, 0.7, 1.2, 1], 3, { attenuation: [0.25, 0.2, 0.3] }),
  dull: scene('point', [-1.6, 0.8, -1.4, 1], 1, { attenuation: [1, 0.1, 0.05] }),
  spot: scene('spot', [0.6, 1.5, 1.9, 1], 8, {
    axis: [-0.75, -1.85, -2.25],
    aperture: 25,
    cutoff: 6,
    attenuation: [0.5, 0.2, 0.15],
  }),
  cone: scene('spot', [-1.2, 0.9, 1.6, 1], 4, { axis: [1.6, -1.3, -2.2], aperture: 25 }),
  narrow: scene('spot', [0.3, -0.4, 2.6, 1], 5, { axis: [-0.3, 0.4, -2.8], aperture: 2.5 }),
  soft: scene('spot', [1.1, -0.6, -1.7, 1], 1, { axis: [-1.5, 0.9, 2.4], cutoff: 3 }),
  wide: scene('spot', [0.2, 0.3, 0.1, 1], 1, {
    axis: [0.6, 1.2, 2.6],
    aperture: 100,
    cutoff: 1.5,
    attenuation: [0.4, 0.2, 0.1],
  }),
} as const satisfies Readonly<Record<string, Scene>>;

export type SceneName = keyof typeof SCENES;

export const SCENE_NAMES = Object.keys(SCENES) as readonly SceneName[];

/** A point of the sheet. */
export interface SheetPoint {
  readonly scene: SceneName;
  readonly given: Given;
}

/** The first `count` points of each scene of these kinds. */
export const sheetOf = (task: Task, count: number): SheetPoint[] =>
  SCENE_NAMES.filter((name) => task.kinds.includes(SCENES[name].kind)).flatMap((name) =>
    pointsOf(name, task, count),
  );

function pointsOf(name: SceneName, task: Task, count: number): SheetPoint[] {
  const about: Scene = SCENES[name];
  const random = randomFrom(SCENE_NAMES.indexOf(name) + 1);
  const points: SheetPoint[] = [];
  while (points.length < count) {
    const given = pointAt(about, task, random);
    if (isFarFromJumps(given)) {
      points.push({ scene: name, given });
    }
  }
  return points;
}

/** A lamp with the colours of these terms: a function that knows more of them is right too. */
export const only = (terms: readonly Term[], light: Lamp): Lamp => ({
  ...light,
  ...eachTerm((term) => (terms.includes(term) ? light[term] : BLACK)),
});

function pointAt(about: Scene, { terms, reflection }: Task, random: () => number): Given {
  const { axis, aperture, cutoff, attenuation, position, shininess } = about;
  const between = (low: number, high: number) => low + (high - low) * random();
  const vector = (low: number, high: number) => map(ORIGIN, () => between(low, high));
  // Neither the lamp nor the surface has a colour for the other terms.
  const of = (term: Term, color: Vec3) => (terms.includes(term) ? short(color) : BLACK);
  let p = vector(-1, 1);
  if (about.kind === 'spot') {
    // Mostly where a cone cuts, and some behind it.
    const most = random() < 0.7 ? Math.min(2.4 * aperture, 170) : 170;
    const angle = radians(between(0, most));
    const turn = between(-Math.PI, Math.PI);
    const A = normalize(axis);
    const side = perpendicular(A);
    const around = add(scale(side, Math.cos(turn)), scale(cross(A, side), Math.sin(turn)));
    const along = add(scale(A, Math.cos(angle)), scale(around, Math.sin(angle)));
    p = add(placeOf({ light: about }), scale(along, between(0.3, 3)));
  }
  const eye: Vec3 = [between(-1.5, 1.5), between(-1, 2), between(2.5, 4)];
  const L = normalize(toLightOf({ light: about, p }));
  // From the normal of the highlight to one that turns away from the light; half of them stray far.
  const V = normalize(subtract(eye, p));
  const stray = random() < 0.5 ? 0.35 : 1.5;
  const toward = add(normalize(add(scale(L, between(-0.7, 1)), V)), vector(-stray, stray));
  return {
    light: {
      ambient: of('ambient', vector(0.1, 0.5)),
      diffuse: of('diffuse', vector(0.4, 1)),
      specular: of('specular', vector(0.4, 1)),
      position,
      axis,
      aperture,
      cutoff,
      attenuation,
    },
    material: {
      ka: of('ambient', vector(0.2, 1)),
      kd: of('diffuse', vector(0.2, 1)),
      ks: of('specular', vector(0.3, 1)),
      shininess,
    },
    p: short(p),
    normal: short(scale(normalize(toward), between(about.normal, 1))),
    eye: short(eye),
    reflection,
    terms,
  };
}

const short = (v: Vec3) => map(v, (x) => Math.round(1000 * x) / 1000);

/**
 * Whether neither the right equation nor a wrong one jumps near the point: N·L is not near 0, and
 * the angle off the axis is near no edge of a cone. The distances are hundreds of roundings of
 * float32, and more than what three decimals of an input change.
 */
function isFarFromJumps(given: Given) {
  const { light, normal, eye, p } = given;
  const { aperture, axis } = light;
  const toLight = toLightOf(given);
  const L = normalize(toLight);
  const directed = normalize(placeOf(given));
  if (
    // A picture shows the side toward the eye, so a function may turn the normal there.
    dot(normal, subtract(eye, p)) < 0.02 ||
    length(toLight) < 0.2 ||
    [L, directed].some((l) => Math.abs(dot(normal, l)) < 0.02)
  ) {
    return false;
  }
  if (aperture >= 180) return true;
  const A = normalize(axis);
  for (const [l, a] of [
    [L, A],
    [toLight, A],
    [L, axis],
  ] as const) {
    const c = -dot(l, a);
    for (const edge of [
      radians(aperture),
      radians(aperture) / 2,
      2 * radians(aperture),
      aperture,
    ]) {
      // A driver's cos() may be off by 1e-4, which is much where a cone is narrow.
      if (Math.abs(Math.abs(c) - Math.abs(Math.cos(edge))) < 0.01 && aperture > 5) return false;
      const angle = Math.atan2(length(cross(l, a)), c);
      if (Math.abs(angle - edge) < (edge < 0.1 ? 0.15 * edge : 0.03 * Math.min(edge, 1)))
        return false;
    }
  }
  return true;
}

/** Numbers from 0 to 1 by a seed: three rounds of xorshift32 for each. */
function randomFrom(seed: number): () => number {
  let x = seed * 0x9e3779b1;
  return () => {
    for (let i = 0; i < 3; i++) {
      x ^= x << 13;
      x ^= x >>> 17;
      x ^= x << 5;
    }
    return (x >>> 0) / 2 ** 32;
  };
}
