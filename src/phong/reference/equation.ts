// The shading equation in float64. The picture is measured against this file, so it follows the
// textbook rather than the shader. World space throughout. Colours come in as in HTML (255 = 1) and
// go out with 1 as full.
import { LEAST_EXPONENT, NEAREST } from '../light/precision.js';
import { falloff, type LightValues } from '../light/light-state.js';
import { radians } from '../math/angle.js';
import { atan2, exp, log1p, pow } from '../math/elementary.js';
import { colorOf, srgbDecode, srgbEncode } from '../math/color.js';
import {
  add,
  clamp,
  cross,
  dot,
  length,
  map,
  multiply,
  negate,
  normalize,
  scale,
  subtract,
  type Vec3,
} from '../math/vector.js';

/** The fragment that is shaded. */
export interface Fragment {
  /** Position in world space. */
  readonly p: Vec3;
  /** Interpolated normal on the side that is seen; any length, including zero. */
  readonly normal: Vec3;
  /** The eye's position. */
  readonly eye: Vec3;
}

export interface Surface {
  /** Ka, Kd, Ks: 255 is 1. */
  readonly ka: Vec3;
  readonly kd: Vec3;
  readonly ks: Vec3;
  /** Specular exponent n, >= 0. */
  readonly shininess: number;
  /** Multiplies Ka and Kd; encoded sRGB, 0–1. Default 1 1 1. */
  readonly baseColor?: Vec3;
  /** m, 0–1: Kd is multiplied by 1 − m, and Ks by 1 − m + m · baseColor. Default 0. */
  readonly metalness?: number;
  /** The share of Ks that the part 1 − m keeps; see `lobeScale`. 0–1, default 1. */
  readonly lobeScale?: number;
  /** E, added once to the sum over the lights. Encoded sRGB; default black. */
  readonly emissive?: Vec3;
  /** The colour is the base colour, without any light. Default false. */
  readonly unlit?: boolean;
}

/** The eye's axes in world space, for lights with `space: 'camera'`. */
export interface CameraAxes {
  readonly right: Vec3;
  readonly up: Vec3;
  /** From the target to the eye. */
  readonly back: Vec3;
}

export interface ReferenceOptions {
  readonly camera?: CameraAxes;
  readonly reflection?: 'phong' | 'blinn-phong';
  readonly terms?: readonly ('ambient' | 'diffuse' | 'specular')[];
  readonly linear?: boolean;
}

/** One light's contribution to a fragment. */
export interface LightShare {
  /** Unit vector to the light; zero if it has no direction. */
  readonly L: Vec3;
  /** Distance; Infinity for directional lights. */
  readonly d: number;
  /**
   * Cosine of the angle between the axis and the fragment, with or without a cone; 1 if the axis or
   * L is zero.
   */
  readonly c: number;
  readonly insideCone: boolean;
  readonly att: number;
  readonly decay: number;
  /** dot(N, L), not clamped. */
  readonly NoL: number;
  /** dot(R, V), or dot(N, H) for Blinn–Phong, not clamped. */
  readonly RoV: number;
  readonly ambient: Vec3;
  readonly diffuse: Vec3;
  readonly specular: Vec3;
}

export interface Shaded {
  readonly N: Vec3;
  readonly V: Vec3;
  /** The sum over the lights before clamping; encoded if shading is linear. */
  readonly sum: Vec3;
  /** The sum clamped to 0–1. */
  readonly color: Vec3;
  /** One share per light, in order; null for inactive lights. */
  readonly shares: readonly (LightShare | null)[];
}

const BLACK: Vec3 = [0, 0, 0];
const WHITE: Vec3 = [1, 1, 1];

export function shade(
  fragment: Fragment,
  surface: Surface,
  lights: readonly Readonly<LightValues>[],
  options: ReferenceOptions = {},
): Shaded {
  const N = normalize(fragment.normal);
  const V = normalize(subtract(fragment.eye, fragment.p));
  const shares = lights.map((light) =>
    light.active ? share(light, fragment, N, V, surface, options) : null,
  );
  return { N, V, ...sumOf(shares, surface, options.linear), shares };
}

/** The sum over the lights and what the surface adds itself. */
export function sumOf(
  shares: readonly (Pick<LightShare, 'ambient' | 'diffuse' | 'specular'> | null)[],
  { unlit = false, baseColor = WHITE, emissive = BLACK }: Surface,
  linear = false,
): Pick<Shaded, 'sum' | 'color'> {
  let sum = unlit ? decoded(baseColor, linear) : decoded(emissive, linear);
  for (const s of unlit ? [] : shares) {
    if (s !== null) {
      sum = add(add(add(sum, s.ambient), s.diffuse), s.specular);
    }
  }
  if (linear) {
    sum = map(sum, srgbEncode);
  }
  return { sum, color: map(sum, (x) => clamp(x, 0, 1)) };
}

/**
 * Ka, Kd and Ks as they enter the sum: 0–1, with base colour and metalness, decoded if shading is
 * linear.
 */
export function coefficientsOf(surface: Surface, linear = false): Record<'ka' | 'kd' | 'ks', Vec3> {
  const { baseColor = WHITE, metalness = 0, lobeScale = 1, unlit = false } = surface;
  if (unlit) return { ka: BLACK, kd: BLACK, ks: BLACK };
  const base = decoded(baseColor, linear);
  return {
    ka: multiply(colorOf(surface.ka, linear), base),
    kd: scale(multiply(colorOf(surface.kd, linear), base), 1 - metalness),
    ks: multiply(
      colorOf(surface.ks, linear),
      map(base, (b) => (1 - metalness) * lobeScale + metalness * b),
    ),
  };
}

/** A colour in 0–1 as shading takes it: through the sRGB curve where shading is linear. */
export const decoded = (v: Vec3, linear: boolean): Vec3 => (linear ? map(v, srgbDecode) : v);

function share(
  light: Readonly<LightValues>,
  { p, eye }: Fragment,
  N: Vec3,
  V: Vec3,
  surface: Surface,
  options: ReferenceOptions,
): LightShare {
  const {
    linear = false,
    reflection = 'phong',
    terms = ['ambient', 'diffuse', 'specular'],
  } = options;
  const { toLight, axis, positional } = placeLight(light, p, eye, options.camera);
  const d = length(toLight);
  const distance = positional && d < NEAREST ? 0 : d;
  const L = distance > 0 ? normalize(toLight) : BLACK;

  const { c, insideCone, decay } = spot(light, L, axis);
  const att = positional ? 1 / Math.max(falloff(light, distance), 1) : 1;

  const NoL = dot(N, L);
  const R = subtract(scale(N, 2 * NoL), L);
  const H = normalize(add(L, V));
  const RoV = reflection === 'phong' ? dot(R, V) : dot(N, H);
  const y = reflection === 'phong' ? halfChord(R, V) : halfChord(N, H);
  const spec = NoL > 0 ? power(RoV, y, surface.shininess) : 0;

  const { ka, kd, ks } = coefficientsOf(surface, linear);
  const term = (name: (typeof terms)[number], k: Vec3, i: Vec3, factor: number): Vec3 =>
    insideCone && terms.includes(name)
      ? scale(multiply(k, colorOf(i, linear)), factor * decay)
      : BLACK;
  return {
    L,
    d: positional ? d : Infinity,
    c,
    insideCone,
    att,
    decay,
    NoL,
    RoV,
    ambient: term('ambient', ka, light.ambient, 1),
    diffuse: term('diffuse', kd, light.diffuse, att * Math.max(NoL, 0)),
    specular: term('specular', ks, light.specular, att * spec),
  };
}

/** A vector of the camera's space in world space. */
export const toWorld = ({ right, up, back }: CameraAxes, [x, y, z]: Vec3): Vec3 =>
  add(add(scale(right, x), scale(up, y)), scale(back, z));

/** The vector to the light and the spot's axis in world space. */
function placeLight(
  light: Readonly<LightValues>,
  p: Vec3,
  eye: Vec3,
  camera: CameraAxes | undefined,
) {
  const [x, y, z, w] = light.position;
  const positional = w === 1;
  if (light.space === 'world') {
    const toLight: Vec3 = positional ? subtract([x, y, z], p) : [x, y, z];
    return { toLight, axis: light.axis, positional };
  }
  if (camera === undefined) throw new TypeError('a light in camera space needs options.camera');
  const turned = toWorld(camera, [x, y, z]);
  return {
    // Subtract the fragment from the eye first: far from the origin, eye + turned would round the
    // light's offset away.
    toLight: positional ? add(subtract(eye, p), turned) : turned,
    axis: toWorld(camera, light.axis),
    positional,
  };
}

/**
 * Tolerance of the cone's edge in radians: a few roundings of float64. Simple directions do lie
 * exactly on an edge, such as 0 1 1 seen along 1 0 1 at 120°.
 */
export const EDGE = 16 * Number.EPSILON;

/**
 * Cone and decay. Everything passes if the axis or the direction is zero, or there is neither cone
 * nor cutoff.
 */
function spot(light: Readonly<LightValues>, L: Vec3, axis: Vec3) {
  const A = normalize(axis);
  const away = negate(A);
  if (dot(A, A) === 0 || dot(L, L) === 0) return { c: 1, insideCone: true, decay: 1 };
  const c = dot(L, away);
  const angle = atan2(length(cross(L, away)), c);
  return {
    c,
    insideCone: angle <= radians(light.aperture) + EDGE,
    // Both from chords: right behind the spot (1 + c)/2 would cancel all digits, and small
    // exponents need them.
    decay: power(halfChord(L, A) / 2, halfChord(L, away) / 2, light.cutoff),
  };
}

/** |a - b|²/2 for unit vectors: one minus their cosine, without cancellation at small angles. */
export function halfChord(a: Vec3, b: Vec3): number {
  const d = subtract(a, b);
  return dot(d, d) / 2;
}

/**
 * max(x, 0)^n with x^0 = 1 for every x. `y` = 1 - x, given separately because 1 - x would cancel
 * near x = 1.
 */
export function power(x: number, y: number, n: number): number {
  if (n < LEAST_EXPONENT) return 1;
  // H has no length where L and V are opposite, and y is then 1/2 or a rounding less.
  if (x <= 0) return 0;
  return y < 0.5 ? exp(n * log1p(-y)) : pow(x, n);
}
