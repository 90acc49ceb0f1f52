// The code that a light needs: its kind, its feature mask (LIGHT_FEATURES) and the packed limit of its cone; and the
// mask of all lights declared so far, which the general program is compiled for.
import { radians } from '../math/angle.js';
import type { Vec3 } from '../math/vector.js';
import {
  LARGEST_INTEGER_POWER,
  LARGEST_MILD_CUTOFF,
  LARGEST_MILD_POWER,
  LEAST_EXPONENT,
  LIGHT_FEATURES,
  LIMIT_OPEN,
} from './light-layout.js';
import type { LightValues } from './light-state.js';

export type LightKind = 'directional' | 'point' | 'spot';

/** In the order of their packed rows. */
export const KINDS = ['directional', 'point', 'spot'] as const satisfies readonly LightKind[];

type Values = Readonly<LightValues>;

/** All three components are 0. */
export const isBlack = (v: Vec3): boolean => v[0] === 0 && v[1] === 0 && v[2] === 0;

/** Has a cone or a decay, and an axis to measure it from. */
export const isSpot = (light: Values): boolean =>
  !isBlack(light.axis) && (light.aperture < 180 || light.cutoff >= LEAST_EXPONENT);

export function kindOf(light: Values): LightKind {
  if (light.position[3] === 0) return 'directional'; // its cone and decay are constants: see pack-lights
  return isSpot(light) ? 'spot' : 'point';
}

/** Attenuation that can differ from 1. */
const isAttenuated = ({ position, attenuation }: Values): boolean =>
  position[3] === 1 && (attenuation[0] > 1 || attenuation[1] > 0 || attenuation[2] > 0);

/**
 * What a program for any number of such lights needs, as bits of LIGHT_FEATURES without integer powers: the lights'
 * kinds, and their features with those that another colour, cone or cutoff of the same kind would add. Inactive lights
 * count, so that toggling or recolouring one never needs another program. DECLARED_FEATURES in the GLSL.
 */
export function declaredFeatures(lights: Iterable<Values>): number {
  let declared = 0;
  for (const light of lights) declared |= declaredByOne(light);
  // Without a cone there is no side to compare it on.
  return (declared & LIGHT_FEATURES.wide) === 0 ? declared & ~LIGHT_FEATURES.narrow : declared;
}

function declaredByOne(light: Values): number {
  const kind = kindOf(light);
  const { ambient, diffuse, specular } = light;
  return (
    LIGHT_FEATURES[kind] |
    (isBlack(ambient) ? 0 : LIGHT_FEATURES.ambient) |
    (isBlack(diffuse) ? 0 : LIGHT_FEATURES.diffuse | LIGHT_FEATURES.tintedDiffuse) |
    (isBlack(specular) ? 0 : LIGHT_FEATURES.specular | LIGHT_FEATURES.tintedSpecular) |
    (isAttenuated(light) ? ANY_ATTENUATION : 0) |
    (kind === 'spot' ? declaredCone(light) : 0)
  );
}

const ANY_ATTENUATION = LIGHT_FEATURES.attenuated | LIGHT_FEATURES.clamped | LIGHT_FEATURES.linear;

/** Steep cones are compared on either side, gentle ones on the far side. */
function declaredCone(light: Values): number {
  return (
    (light.aperture < 180 ? LIGHT_FEATURES.wide : 0) |
    (light.cutoff < LEAST_EXPONENT ? 0 : LIGHT_FEATURES.decay) |
    (isSteep(light) ? LIGHT_FEATURES.chords | LIGHT_FEATURES.narrow : 0)
  );
}

/** The feature mask of a light of this kind. */
export function featuresOf(light: Values, kind: LightKind): number {
  const terms = termFeatures(light);
  if (kind === 'directional') return terms;
  const positional = terms + attenuationFeatures(light);
  if (kind === 'point') return positional;
  return positional + (isBlack(light.ambient) ? 0 : LIGHT_FEATURES.ambient) + coneFeatures(light);
}

function termFeatures({ diffuse, specular }: Values): number {
  let features = 0;
  if (!isBlack(diffuse))
    features += LIGHT_FEATURES.diffuse + (isGrey(diffuse) ? 0 : LIGHT_FEATURES.tintedDiffuse);
  if (!isBlack(specular))
    features += LIGHT_FEATURES.specular + (isGrey(specular) ? 0 : LIGHT_FEATURES.tintedSpecular);
  return features;
}

const isGrey = (c: Vec3): boolean => c[0] === c[1] && c[1] === c[2];

/** `clamped` also without attenuation: in a loop with attenuated lights every light takes its sum. */
function attenuationFeatures(light: Values): number {
  const { attenuation } = light;
  return (
    (isAttenuated(light) ? LIGHT_FEATURES.attenuated : 0) +
    (attenuation[0] < 1 ? LIGHT_FEATURES.clamped : 0) +
    (attenuation[1] > 0 ? LIGHT_FEATURES.linear : 0)
  );
}

/**
 * Least angle in degrees between a cone's edge and 0 or 180 for which a cosine finds the edge: float32 leaves an error
 * of 4e-7 in the cosine on the worst lawful driver, 1.5e-6 rad at this angle.
 */
const LEAST_BY_COSINE = 15;

/** A cone whose edge a cosine finds. */
const isBlunt = (aperture: number): boolean =>
  aperture >= LEAST_BY_COSINE && aperture <= 180 - LEAST_BY_COSINE;

/**
 * A cone or decay that needs chords. A power below 1 is steep behind the light, one above LARGEST_MILD_CUTOFF at the
 * axis.
 */
function isSteep({ aperture, cutoff }: Values): boolean {
  const gentle = cutoff < LEAST_EXPONENT || (cutoff >= 1 && cutoff <= LARGEST_MILD_CUTOFF);
  return !gentle || !(aperture >= 180 || isBlunt(aperture));
}

function coneFeatures(light: Values): number {
  const { aperture, cutoff } = light;
  const side = isOnFarSide(aperture) ? LIGHT_FEATURES.wide : LIGHT_FEATURES.narrow;
  const cone = (aperture >= 180 ? 0 : side) + (isSteep(light) ? LIGHT_FEATURES.chords : 0);
  if (cutoff < LEAST_EXPONENT) return cone;
  if (isIntegerPower(cutoff)) return cone + (cutoff << LIGHT_FEATURES.powerShift);
  return cone + LIGHT_FEATURES.decay;
}

/** An exponent that a specialised program multiplies out. */
export const isIntegerPower = (exponent: number): boolean =>
  Number.isInteger(exponent) && exponent >= 1 && exponent <= LARGEST_INTEGER_POWER;

/** A shininess whose power needs no series near 1; 0 included. */
export const isMildPower = (exponent: number): boolean => exponent <= LARGEST_MILD_POWER;

/** The bits of a mask; above them is an integer power. */
const BITS = (1 << LIGHT_FEATURES.powerShift) - 1;

/** What lights of both masks need. Cutoffs that differ need a general power. */
export function unionOf(a: number, b: number): number {
  const power = a >> LIGHT_FEATURES.powerShift;
  const samePower = power === b >> LIGHT_FEATURES.powerShift && ((a ^ b) & LIGHT_FEATURES.decay) === 0;
  const decay = samePower ? power << LIGHT_FEATURES.powerShift : LIGHT_FEATURES.decay;
  return ((a | b) & BITS) | decay;
}

/** An aperture in degrees as the one float that the shader compares with; see LIMIT_OPEN. */
export function coneLimit(aperture: number): number {
  if (aperture >= 180) return LIMIT_OPEN;
  // Beyond 90° the chord to the far side is the short one, and precise; degrees to 180 are exact.
  return aperture <= 90 ? Math.sin(radians(aperture) / 2) ** 2 : farLimit(aperture);
}

/** The limit as it is compared on the far side of the axis. */
const farLimit = (aperture: number): number => -(Math.sin(radians(180 - aperture) / 2) ** 2);

/**
 * The limit for float32. A fragment exactly on the axis can be 1e-6 rad off it there (inversesqrt may be 2 ULP off), so
 * a cone of no width must be that wide to hold its axis. An edge that a cosine finds is compared on the far side.
 */
export const packedLimit = (aperture: number): number =>
  isOnFarSide(aperture) ? farLimit(aperture) : Math.max(coneLimit(aperture), LEAST_LIMIT);

/** The packed limit is compared on the far side of the axis, and negative. */
const isOnFarSide = (aperture: number): boolean => isBlunt(aperture) || (aperture > 90 && aperture < 180);

/** sin² of half of 1e-6 rad. */
const LEAST_LIMIT = 2.5e-13;

/**
 * For each kind, the features that any of its lights needs; 0 without a light of that kind.
 * @param packed lights sorted by kind.
 */
export function kindFeatures({
  counts,
  features,
}: {
  readonly counts: Readonly<Record<LightKind, number>>;
  readonly features: ArrayLike<number>;
}): Record<LightKind, number> {
  const all: Record<LightKind, number> = { directional: 0, point: 0, spot: 0 };
  let light = 0;
  for (const kind of KINDS) {
    for (let i = 0; i < counts[kind]; i++, light++) {
      const own = features[light]!;
      all[kind] = i === 0 ? own : unionOf(all[kind], own);
    }
  }
  return all;
}
