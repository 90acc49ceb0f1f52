// Fragments and lights to build adversarial cases from: ordinary ones, and ones placed where a
// formula is weakest.
import type { LightValues } from '../../src/phong/light/light-state.js';
import { LIMITS } from '../../src/phong/light/light-state.js';
import {
  add,
  dot,
  normalize,
  scale,
  subtract,
  type Vec3,
  type Vec4,
} from '../../src/phong/math/vector.js';
import type { Surface } from '../../src/phong/reference/equation.js';
import { CAMERA, lightWith, ORIGIN, type StressCase, type Variant } from './case.js';
import { BRANCHES } from './contract.js';
import { float32, type Random } from './random.js';

/** The angle between unit vectors with 1 - cosine = y; y in [0, 2]. */
export const chordAngle = (y: number): number => 2 * Math.asin(Math.sqrt(Math.min(y / 2, 1)));

export const place = (v: Vec3): Vec4 => [v[0], v[1], v[2], 1];
export const direction = (v: Vec3): Vec4 => [v[0], v[1], v[2], 0];

/** Interpolated between unit normals of vertices: a little short. */
export const shortNormal = (random: Random, N: Vec3): Vec3 =>
  float32(scale(N, random.from(0.3, 1)));

export function surface(random: Random, shininess: number): Surface {
  return { ka: random.color(), kd: random.color(), ks: random.color(), shininess };
}

/** All white: the largest errors that a surface can show. */
export const white = (shininess: number): Surface => ({
  ka: [255, 255, 255],
  kd: [255, 255, 255],
  ks: [255, 255, 255],
  shininess,
});

export const WHITE: Vec3 = [255, 255, 255];

interface Seen {
  readonly p: Vec3;
  readonly normal: Vec3;
  readonly eye: Vec3;
}

/** A point, its normal and an eye that mostly sees its front. */
export function seen(random: Random): Seen & { readonly N: Vec3 } {
  const p = float32(random.vector(-2, 2));
  const normal = shortNormal(random, random.unit());
  const N = normalize(normal);
  let V = random.unit();
  if (dot(V, N) < 0 && random.chance(0.9)) {
    V = scale(V, -1);
  }
  return { p, normal, N, eye: float32(add(p, scale(V, random.from(1, 6)))) };
}

export const stressCase = (
  { p, normal, eye }: Seen,
  material: Surface,
  lights: readonly LightValues[],
): StressCase => ({ p, normal, eye, origin: ORIGIN, camera: CAMERA, surface: material, lights });

type LightColors = Pick<LightValues, 'ambient' | 'diffuse' | 'specular'>;

/** Together no brighter than `full`. */
export function colors(random: Random, full = 255): LightColors {
  // No round numbers: a colour half-way between two codes has no nearest one.
  const ambient = random.from(0, 0.2);
  const diffuse = random.from(0, 0.6);
  return {
    ambient: scale(random.color(), (ambient * full) / 255),
    diffuse: scale(random.color(), (diffuse * full) / 255),
    specular: scale(random.color(), ((1 - ambient - diffuse) * full) / 255),
  };
}

/** A light of any kind that shines on p from a distance of 0.2 to 8. */
export function anyLight(random: Random, p: Vec3, light: LightColors): LightValues {
  const L = random.unit();
  if (random.chance(0.3)) {
    return lightWith({ ...light, position: direction(scale(L, random.magnitude(0.01, 100))) });
  }
  const at = add(p, scale(L, random.magnitude(0.2, 8)));
  const point = {
    ...light,
    position: place(at),
    attenuation: random.chance(0.5) ? fading(random) : NONE,
  };
  if (random.chance(0.4)) return lightWith(point);
  const axis = scale(random.around(scale(L, -1), random.from(0, 1.2)), random.magnitude(0.1, 10));
  return lightWith({
    ...point,
    axis,
    aperture: random.chance(0.3) ? 180 : random.from(5, 120),
    cutoff: random.pick([0, 1, 4, random.from(1, 64)]),
  });
}

const NONE: Vec3 = [1, 0, 0];
const fading = (random: Random): Vec3 => [
  random.from(0, 2),
  random.from(0, 1),
  random.from(0, 0.5),
];

/**
 * The eye near the mirrored light: n·(1 - R·V) (or N·H) from 1e-3, the middle of the highlight, to
 * 30, where it has faded to 1e-13. Above n = 1, that is; below, the eye is anywhere.
 */
export function highlight(random: Random, n: number, { reflection }: Variant): StressCase {
  const normal = shortNormal(random, random.unit());
  const N = normalize(normal);
  const L = random.around(N, Math.acos(random.from(0.02, 1)));
  const angle = n < 1 ? random.from(0, 1.6) : chordAngle(random.magnitude(1e-3, 30) / n);
  const H = random.around(N, angle);
  const R = subtract(scale(N, 2 * dot(N, L)), L);
  const V = reflection === 'phong' ? random.around(R, angle) : subtract(scale(H, 2 * dot(L, H)), L);
  // With Blinn's half vector such a light is beside the branch point.
  const isOpen = reflection === 'phong' && random.chance(0.3);
  return shining(random, n, { normal, L, V }, isOpen);
}

/**
 * A point p where float32 rounds the direction to a light the most: a light in direction L at
 * {@link openDistance} has coordinates just above a power of two, where float32 is coarsest.
 */
export const openPoint = (random: Random, L: Vec3): Vec3 =>
  float32(
    scale([Math.sign(L[0]), Math.sign(L[1]), Math.sign(L[2])], 1 - random.magnitude(1e-6, 0.01)),
  );

/** As near as such a light may be. */
export const openDistance = (random: Random): number => BRANCHES.near * random.from(1, 1.2);

interface Directions {
  readonly normal: Vec3;
  readonly L: Vec3;
  readonly V: Vec3;
}

/** The specular term alone under a white light from L, near or far, seen from V. */
function shining(random: Random, n: number, { normal, L, V }: Directions, isOpen = false) {
  const p = isOpen ? openPoint(random, L) : float32(random.vector(-1, 1));
  const eye = float32(add(p, scale(V, isOpen ? random.from(0.02, 0.1) : random.from(1, 5))));
  const position =
    !isOpen && random.chance(0.5)
      ? direction(scale(L, random.magnitude(0.01, 100)))
      : place(add(p, scale(L, isOpen ? openDistance(random) : random.magnitude(0.02, 5))));
  const light = lightWith({ position, diffuse: [0, 0, 0], specular: WHITE });
  return stressCase({ p, normal, eye }, white(n), [light]);
}

/**
 * Light and eye nearly opposite each other, and N within 3/√n of the half vector: what float32
 * makes of L and V is divided by |L + V| there, and multiplied by √n.
 */
export function nearlyOpposite(random: Random, n: number): StressCase {
  const normal = shortNormal(random, random.unit());
  const H = random.around(normalize(normal), random.from(0, 3) / Math.sqrt(n));
  const T = random.around(H, Math.PI / 2);
  const half = random.magnitude(BRANCHES.half, 0.3) / 2;
  const across = scale(T, Math.sqrt(1 - half * half));
  const along = scale(H, half);
  return shining(random, n, { normal, L: add(along, across), V: subtract(along, across) });
}

/**
 * The middle of a highlight, N = V = L = R or nearly, all lengths just below powers of two: there a
 * unit vector is as wrong as inversesqrt may make it, and N counts four times in R·V.
 */
export function straight(random: Random, n: number): StressCase {
  const length = (sizes: readonly number[]) =>
    random.pick(sizes) * (1 - random.magnitude(1e-7, 1e-2));
  const N = random.unit();
  const normal = float32(scale(N, length([0.5, 1])));
  const beside = () => random.around(N, chordAngle(random.magnitude(1e-6, 0.1) / n));
  const p = float32(random.vector(-1, 1));
  const eye = float32(add(p, scale(beside(), length([1, 2, 4]))));
  const far = scale(beside(), length([0.5, 1, 2, 4]));
  const position = random.chance(0.5) ? direction(far) : place(add(p, far));
  const light = lightWith({ position, diffuse: [0, 0, 0], specular: WHITE });
  return stressCase({ p, normal, eye }, white(n), [light]);
}

/** A white spot over p whose axis is this far, in radians, off the line to p. */
export function spotOver(
  random: Random,
  p: Vec3,
  angle: number,
  values: Partial<LightValues>,
  toLight = scale(random.unit(), random.magnitude(0.05, 5)),
): LightValues {
  const L = normalize(toLight);
  const at = add(p, toLight);
  const axis = scale(random.around(scale(L, -1), angle), random.magnitude(0.1, 10));
  const dark: Vec3 = [0, 0, 0];
  return lightWith({
    position: place(at),
    axis,
    ambient: WHITE,
    diffuse: dark,
    specular: dark,
    ...values,
  });
}

/**
 * The same case with every length times s; attenuation so that it stays what it was, where that is
 * in its domain.
 */
export function scaled(stress: StressCase, s: number): StressCase {
  const lights = stress.lights.map((light): LightValues => {
    if (light.position[3] === 0) return light;
    const [x, y, z] = light.position;
    const [kc, kl, kq] = light.attenuation;
    const cap = (k: number) => Math.min(k, LIMITS.attenuation);
    return {
      ...light,
      position: [x * s, y * s, z * s, 1],
      attenuation: [kc, cap(kl / s), cap(kq / s / s)],
    };
  });
  const grown = (v: Vec3) => float32(scale(v, s));
  return { ...stress, p: grown(stress.p), eye: grown(stress.eye), lights };
}

/**
 * The same case elsewhere in the world. The fragment is put on a grid that doubles at that distance
 * still resolve.
 */
export function moved(random: Random, stress: StressCase, distance: number): StressCase {
  const grid = (v: Vec3): Vec3 => [snap(v[0]), snap(v[1]), snap(v[2])];
  const origin = grid(scale(random.unit(), distance));
  const lights = stress.lights.map((light) => {
    if (light.position[3] === 0 || light.space === 'camera') return light;
    const [x, y, z] = light.position;
    return { ...light, position: place(add(origin, [x, y, z])) };
  });
  return { ...stress, p: grid(stress.p), eye: grid(stress.eye), origin, lights };
}

/** To 2^-20: exact in float32 below 16, and in float64 below 1e9. */
const snap = (x: number) => Math.round(x * 2 ** 20) / 2 ** 20;
