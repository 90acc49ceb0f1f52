// What float32 can tell apart, on the worst lawful driver too: thresholds that TypeScript and GLSL
// share, and the cones and powers that a cosine and log2 are precise enough for.
import { sinDegrees } from '../math/angle.js';

/**
 * The cone's limit is one float: from 0 the largest allowed (1 - c)/2, below 0 minus the smallest
 * allowed (1 + c)/2; this value, above any (1 - c)/2, lets every direction through.
 */
export const LIMIT_OPEN = 4;

/**
 * Largest shininess that log2 and the lobe's cosine are precise enough for: an eighth of a code on
 * the worst lawful driver. log2 near 1 may be 2^-21 off, which an exponent of 150 turns into 5e-5,
 * or 0.013 of a code; the lengths of N, L and V make four times as much.
 */
export const LARGEST_MILD_POWER = 150;

/**
 * The same of a spot's decay. Its (c + 1)/2 may be 2e-7 off as well: an exponent of 32 makes 1.1e-5
 * and 6e-6 of them, 0.007 of a code at most.
 */
export const LARGEST_MILD_CUTOFF = 32;

/**
 * Largest integer power that a specialised program multiplies out: six squarings round to 0.001 of
 * a code.
 */
export const LARGEST_INTEGER_POWER = 64;

/**
 * A light nearer to the fragment than this has no direction: NoL = spec = 0, inside any cone, decay
 * 1. Its square is a normal float32, so the comparison cannot be lost to flushed denormals.
 */
export const NEAREST = 1e-15;

/** Exponents below this are 0: x^0 = 1 for every x. */
export const LEAST_EXPONENT = 1e-6;

/**
 * Positive numbers below this count as zero: a device may flush numbers below 2^-126. Not 2^-126
 * itself, because Firefox 153 on Mesa reads literals of 1.2e-38 and less as zero.
 */
export const TINY = 2 ** -120;

/** An exponent that a specialised program multiplies out. */
export const isIntegerPower = (exponent: number): boolean =>
  Number.isInteger(exponent) && exponent >= 1 && exponent <= LARGEST_INTEGER_POWER;

/** A shininess whose power needs no series near 1; 0 included. */
export const isMildPower = (exponent: number): boolean => exponent <= LARGEST_MILD_POWER;

/**
 * Least angle in degrees between a cone's edge and 0 or 180 for which a cosine finds the edge:
 * float32 leaves an error of 4e-7 in the cosine on the worst lawful driver, 1.5e-6 rad at this
 * angle.
 */
const LEAST_BY_COSINE = 15;

/** What a light's spot is made of: the half-angle in degrees and the exponent of its decay. */
interface Cone {
  readonly aperture: number;
  readonly cutoff: number;
}

/** A cone whose edge a cosine finds. */
const isBlunt = (aperture: number) =>
  aperture >= LEAST_BY_COSINE && aperture <= 180 - LEAST_BY_COSINE;

/**
 * Whether a cone or decay needs chords. A power below 1 is steep behind the light, one above
 * LARGEST_MILD_CUTOFF at the axis.
 */
export function isSteep({ aperture, cutoff }: Cone): boolean {
  const gentle = cutoff < LEAST_EXPONENT || (cutoff >= 1 && cutoff <= LARGEST_MILD_CUTOFF);
  return !gentle || !(aperture >= 180 || isBlunt(aperture));
}

/** An aperture in degrees as the one float that the shader compares with; see LIMIT_OPEN. */
export function coneLimit(aperture: number): number {
  if (aperture >= 180) return LIMIT_OPEN;
  // Beyond 90° the chord to the far side is the short one, and precise; degrees to 180 are exact.
  return aperture <= 90 ? squaredSine(aperture / 2) : farLimit(aperture);
}

/** The limit as it is compared on the far side of the axis. */
const farLimit = (aperture: number) => -squaredSine((180 - aperture) / 2);

const squaredSine = (degrees: number) => sinDegrees(degrees) * sinDegrees(degrees);

/**
 * The limit for float32. A fragment exactly on the axis can be 1e-6 rad off it there (inversesqrt
 * may be 2 ULP off), so a cone of no width must be that wide to hold its axis. An edge that a
 * cosine finds is compared on the far side.
 */
export const packedLimit = (aperture: number): number =>
  isOnFarSide(aperture) ? farLimit(aperture) : Math.max(coneLimit(aperture), LEAST_LIMIT);

/** The packed limit is compared on the far side of the axis, and negative. */
export const isOnFarSide = (aperture: number): boolean =>
  isBlunt(aperture) || (aperture > 90 && aperture < 180);

/** sin² of half of 1e-6 rad. */
const LEAST_LIMIT = 2.5e-13;
