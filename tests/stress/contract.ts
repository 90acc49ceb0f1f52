// The numerical contract: how far a picture may be from the equation in float64, and beside which
// points nothing is promised, because there the equation itself jumps or is infinitely steep.
import type { LightValues } from '../../src/phong/light/light-state.js';
import { LEAST_EXPONENT, NEAREST } from '../../src/phong/light/precision.js';
import { radians } from '../../src/phong/math/angle.js';
import { add, cross, dot, length, normalize, type Vec3 } from '../../src/phong/math/vector.js';
import type { LightShare, Shaded } from '../../src/phong/reference/equation.js';
import type { StressCase, Variant } from './case.js';

/**
 * Largest errors of the sum, in 1/255, over max(1, the sum of the lights' intensities). Each is
 * above what climbing to the largest error found on any driver: see REPORT.md.
 *
 * `generic`: exponents to 100. `mildPower`: exponents to LARGEST_MILD_POWER. N counts four times in
 * R·V, L and V once each, and an inversesqrt that is 2 ULP off is off by 2^-22: six times that,
 * times 150, is 0.055 of a code; log2 may add 0.013, a spot's decay 0.004, and the driver that runs
 * a worst one errs by up to half as much again.
 *
 * `shininess…` and `cutoff…`: what float32 leaves open of L, times the steepest slope of the power.
 * A light's position is rounded by 2^-24 of each coordinate, √(8/3) times that across L, over a
 * distance of BRANCHES.near: 4.9e-6. A lobe's slope is at most √(n/e), a decay's 0.43·√cutoff. At
 * 1e6 that makes 0.75 and 0.53; N, V and the axis add up to a tenth of it.
 *
 * `smallExponent`: exponents below 1 are steepest where the branches begin, a lobe's 53 at
 * BRANCHES.lobe and a decay's 49 at BRANCHES.back: 0.066 and 0.061.
 */
export const BOUNDS = {
  generic: 0.05,
  smallExponent: 0.075,
  mildPower: 0.125,
  shininess1e4: 0.1,
  shininess1e5: 0.35,
  shininess1e6: 1,
  cutoff1e4: 0.06,
  cutoff1e6: 0.6,
} as const;

/**
 * At least this share of 8-bit codes is exactly the nearest to float64, over all categories
 * whose bound is at most `upTo` together, and in each of them: larger errors move more of them, by
 * one.
 */
export const EXACT = { share: 0.9998, upTo: BOUNDS.generic } as const;

/**
 * Of all categories together on the worst lawful drivers: 99.952 to 99.982 % were measured on six
 * stacks and seeds, where real ones have 99.987 to 99.99. The least is llvmpipe's, in Firefox.
 */
export const WORST_SHARE = 0.9995;

/**
 * The same of each category alone. The least that was measured: 99.954 %, of 357,921 codes in and
 * around highlights with exponents from 1 to 64, on an H200 through OpenGL with every built-in
 * function rounded up; 99.966 to 99.977 % on the seven other drivers.
 */
export const WORST_CATEGORY_SHARE = 0.9995;

/** Nearer to a cone's edge than this, radians, a fragment may be on either side. */
export const CONE_EDGE = 5e-6;

/**
 * Where a base of powers below 1 is steeper than what float32 keeps of it, and where the specular
 * term begins.
 */
export const BRANCHES = {
  /**
   * dot(N, L) around 0, where the specular term begins: some roundings of a float32 dot product.
   */
  gate: 1e-6,
  /** R·V (or N·H) around 0 with shininess below 1: the lobe is infinitely steep there. */
  lobe: 1e-3,
  /** Radians from straight behind a spot with cutoff below 1: the same. */
  back: 1e-3,
  /**
   * Distance to a light over the largest coordinate in shading space, or over the distance where
   * that is larger: nearer, the float32 coordinates themselves leave the light's direction open by
   * more than 3e-6.
   */
  near: 2e-2,
  /**
   * That share, at most 1, times |L + V|, for Blinn's half vector: where light and eye are opposite
   * each other, it is that much more open than the light's direction. Exactly opposite, there is no
   * half vector, and nothing is open.
   */
  half: 4e-2,
  /**
   * Largest component of an interpolated normal: of a shorter one, which is not zero, a device that
   * flushes denormals keeps too little.
   */
  normal: 2 ** -100,
} as const;

/** Angle between the spot's axis and the fragment; exact at both ends, where the cosine is not. */
function spotAngle(light: LightValues, share: LightShare) {
  const A = normalize(light.axis);
  return Math.atan2(length(cross(share.L, A)), -dot(share.L, A));
}

const hasCone = (light: LightValues) => light.aperture < 180 && dot(light.axis, light.axis) > 0;

/**
 * Radians to the nearest edge of a cone, negative inside of it; Infinity where no light has a cone.
 */
export function coneMargin(lights: readonly LightValues[], shaded: Shaded): number {
  let least = Infinity;
  lights.forEach((light, i) => {
    const share = shaded.shares[i];
    if (!share || !hasCone(light) || dot(share.L, share.L) === 0) return;
    const margin = spotAngle(light, share) - radians(light.aperture);
    if (Math.abs(margin) < Math.abs(least)) {
      least = margin;
    }
  });
  return least;
}

/** The name of the branch point that this case is too near to; null where the contract holds. */
export function branch(stress: StressCase, shaded: Shaded, variant: Variant): string | null {
  const size = Math.max(...stress.normal.map(Math.abs));
  if (size > 0 && size < BRANCHES.normal) return 'normal';
  const edge = Math.abs(coneMargin(stress.lights, shaded));
  // On the axis of a cone without width is where such a cone is; beside it is its edge.
  if (edge < CONE_EDGE && edge > 0) return 'edge';
  for (const [i, light] of stress.lights.entries()) {
    const share = shaded.shares[i];
    if (!share?.insideCone) continue;
    const found = nearLight(stress, light, share) ?? lobe(stress, shaded, light, share, variant);
    if (found !== null) return found;
  }
  return null;
}

function nearLight(stress: StressCase, light: LightValues, share: LightShare): string | null {
  if (share.d < Infinity && share.d >= NEAREST && openness(stress, share) < BRANCHES.near) {
    return 'near';
  }
  const isFlat = light.cutoff >= LEAST_EXPONENT && light.cutoff < 1;
  const hasAngle = dot(light.axis, light.axis) > 0 && dot(share.L, share.L) > 0;
  return isFlat && hasAngle && Math.PI - spotAngle(light, share) < BRANCHES.back ? 'back' : null;
}

/** Distance to the light over the largest coordinate; 1 where that is at most the distance. */
function openness({ p, eye }: StressCase, { d }: LightShare) {
  const size = Math.max(...p.map(Math.abs), ...eye.map(Math.abs));
  return d < size ? d / size : 1;
}

function lobe(
  stress: StressCase,
  shaded: Shaded,
  light: LightValues,
  share: LightShare,
  { reflection }: Variant,
): string | null {
  const { surface } = stress;
  if (!lit(light.specular) || !lit(surface.ks) || dot(share.L, share.L) === 0) return null;
  if (dot(shaded.N, shaded.N) === 0) return null;
  if (Math.abs(share.NoL) < BRANCHES.gate) return 'gate';
  if (share.NoL < 0) return null;
  if (surface.shininess < 1 && Math.abs(share.RoV) < BRANCHES.lobe) return 'lobe';
  if (reflection === 'blinn-phong') {
    const sum = length(add(share.L, shaded.V));
    if (sum > 0 && sum * openness(stress, share) < BRANCHES.half) return 'half';
  }
  return null;
}

const lit = (color: Vec3) => color[0] > 0 || color[1] > 0 || color[2] > 0;
