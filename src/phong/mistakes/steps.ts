// The equation of one light as a row of named steps, each a function of those before it. A usual
// mistake is a step that is written wrongly, so one evaluation serves the right equation, every
// mistake, and two mistakes at once. World space, float64; 1 is full.
import { LEAST_EXPONENT, NEAREST } from '../light/precision.js';
import { falloff, type LightValues, type ShadedValue, type Term } from '../light/light-state.js';
import { radians } from '../math/angle.js';
import { colorOf } from '../math/color.js';
import {
  add,
  cross,
  dot,
  length,
  multiply,
  negate,
  normalize,
  scale,
  subtract,
  type Vec3,
} from '../math/vector.js';

/** One lamp at one point, as a learner's function is given it. */
export interface Given {
  /** Without an axis, or with aperture 180 and cutoff 0, it has neither cone nor decay. */
  readonly light: Readonly<Pick<LightValues, ShadedValue>>;
  readonly material: {
    readonly ka: Vec3;
    readonly kd: Vec3;
    readonly ks: Vec3;
    readonly shininess: number;
  };
  readonly p: Vec3;
  /** On the side that is seen; any length. */
  readonly normal: Vec3;
  readonly eye: Vec3;
  readonly reflection: 'phong' | 'blinn-phong';
  /** The terms that are asked for. */
  readonly terms: readonly Term[];
}

/** What is computed for each term. */
export const eachTerm = <Value>(of: (term: Term) => Value): Readonly<Record<Term, Value>> => ({
  ambient: of('ambient'),
  diffuse: of('diffuse'),
  specular: of('specular'),
});

/** A light with 1 as full, or decoded where shading is linear. */
export function lampOf(light: Readonly<LightValues>, linear: boolean): Given['light'] {
  return {
    ...light,
    ...eachTerm((term) => colorOf(light[term], linear)),
  };
}

/** What the steps compute, in their order. */
export interface Values {
  N: Vec3;
  V: Vec3;
  /** To the light, not normalized. */
  toLight: Vec3;
  d: number;
  L: Vec3;
  /** The spot's axis; zero where the light is no spot. */
  A: Vec3;
  /** Cosine of the angle between axis and fragment. */
  c: number;
  isInside: boolean;
  decay: number;
  /** 1 for directional lights. */
  att: number;
  NoL: number;
  /** The diffuse factor. */
  lambert: number;
  /** R·V or N·H. */
  cosine: number;
  /** The cosine raised to the exponent. */
  lobe: number;
  /** The specular factor. */
  spec: number;
  /** Each term with its attenuation, without cone and decay. */
  ambient: Vec3;
  diffuse: Vec3;
  specular: Vec3;
  /** What the cone and the decay leave of each term. */
  shares: Readonly<Record<Term, number>>;
  /** What everything is multiplied by at the end. */
  full: number;
}

type Step<K extends keyof Values> = (so: Readonly<Values>, given: Given) => Values[K];

export type Steps = { readonly [K in keyof Values]: Step<K> };

export const BLACK: Vec3 = [0, 0, 0];

/** What decides the way to a light. */
interface PlacedLight {
  readonly light: Pick<LightValues, 'position'>;
  readonly p: Vec3;
}

export const isPositional = ({ light }: Pick<PlacedLight, 'light'>): boolean =>
  light.position[3] === 1;

export const placeOf = ({ light: { position } }: Pick<PlacedLight, 'light'>): Vec3 => [
  position[0],
  position[1],
  position[2],
];

/** To the light, not normalized. */
export const toLightOf = (given: PlacedLight): Vec3 =>
  isPositional(given) ? subtract(placeOf(given), given.p) : placeOf(given);

/** Angle off the spot's axis in radians. */
export const angleOf = ({ L, A }: Readonly<Pick<Values, 'L' | 'A'>>): number =>
  Math.atan2(length(cross(L, negate(A))), dot(L, negate(A)));

const isSpot = ({ A, L }: Readonly<Values>) => dot(A, A) > 0 && dot(L, L) > 0;

/** max(x, 0)^n, with x^0 = 1 for every x. */
export const power = (x: number, n: number): number =>
  n < LEAST_EXPONENT ? 1 : Math.max(x, 0) ** n;

/** R·V: L mirrored by the normal, and the eye. */
export const RoV = ({ N, NoL, L, V }: Readonly<Values>): number =>
  dot(subtract(scale(N, 2 * NoL), L), V);

/** N·H, with H half-way between light and eye. */
export const NoH = ({ N, L, V }: Readonly<Values>): number => dot(N, normalize(add(L, V)));

export const RIGHT: Steps = {
  N: (_, { normal }) => normalize(normal),
  V: (_, { eye, p }) => normalize(subtract(eye, p)),
  toLight: (_, given) => toLightOf(given),
  d: ({ toLight }) => length(toLight),
  L: ({ toLight, d }, given) => (isPositional(given) && d < NEAREST ? BLACK : normalize(toLight)),
  A: (_, { light }) =>
    light.aperture >= 180 && light.cutoff < LEAST_EXPONENT ? BLACK : normalize(light.axis),
  c: ({ L, A }) => dot(L, negate(A)),
  isInside: (so, { light }) =>
    !isSpot(so) || light.aperture >= 180 || angleOf(so) <= radians(light.aperture),
  decay: (so, { light }) => (isSpot(so) ? power((so.c + 1) / 2, light.cutoff) : 1),
  att: (so, given) => (isPositional(given) ? 1 / Math.max(falloff(given.light, so.d), 1) : 1),
  NoL: ({ N, L }) => dot(N, L),
  lambert: ({ NoL }) => Math.max(NoL, 0),
  cosine: (so, { reflection }) => (reflection === 'phong' ? RoV(so) : NoH(so)),
  lobe: ({ cosine }, { material }) => power(cosine, material.shininess),
  spec: ({ NoL, lobe }) => (NoL > 0 ? lobe : 0),
  ambient: (_, { material, light }) => multiply(material.ka, light.ambient),
  diffuse: ({ att, lambert }, { material, light }) =>
    scale(multiply(material.kd, light.diffuse), att * lambert),
  specular: ({ att, spec }, { material, light }) =>
    scale(multiply(material.ks, light.specular), att * spec),
  shares: ({ isInside, decay }) => {
    const share = isInside ? decay : 0;
    return eachTerm(() => share);
  },
  full: () => 1,
};

const ORDER = Object.keys(RIGHT) as (keyof Values)[];

/** The terms of one light at a point, not clamped. */
type LightTerms = Readonly<Record<Term, Vec3>>;

/** What the steps give, with some of them replaced; without `wrong`, as it is right. */
export function valuesAt(given: Given, wrong: Partial<Steps> = {}): Values {
  const so: Partial<Record<keyof Values, unknown>> = {};
  for (const key of ORDER) {
    so[key] = (wrong[key] ?? RIGHT[key])(so as Values, given);
  }
  return so as Values;
}

/** The equation of {@link valuesAt}. */
export function evaluate(given: Given, wrong?: Partial<Steps>): LightTerms {
  const so = valuesAt(given, wrong);
  return eachTerm((term) =>
    given.terms.includes(term) ? scale(so[term], so.shares[term] * so.full) : BLACK,
  );
}

export const sumOfTerms = ({ ambient, diffuse, specular }: LightTerms): Vec3 =>
  add(add(ambient, diffuse), specular);
