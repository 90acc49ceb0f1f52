// The code that a light needs: its kind and its feature mask (LIGHT_FEATURES); and the mask of the
// lights given, which PhongLighting accumulates for the general program.
import { isBlack } from '../math/color.js';
import { FEATURES_OF, LIGHT_FEATURES } from './light-layout.js';
import type { LightKind, LightValues } from './light-state.js';
import { isIntegerPower, LEAST_EXPONENT } from './precision.js';

type Values = Readonly<LightValues>;

/** What a light's kind depends on. */
type Shape = Pick<Values, 'position' | 'axis' | 'aperture' | 'cutoff'>;

/** Has a cone or a decay, and an axis to measure it from. */
export const isSpot = (light: Omit<Shape, 'position'>): boolean =>
  !isBlack(light.axis) && (light.aperture < 180 || light.cutoff >= LEAST_EXPONENT);

export function kindOf(light: Shape): LightKind {
  if (light.position[3] === 0) return 'directional'; // its cone and decay are constants: see pack-lights
  return isSpot(light) ? 'spot' : 'point';
}

/**
 * What a program for any number of such lights needs, as bits of LIGHT_FEATURES without integer
 * powers: the lights' kinds, and their features with those that another colour, cone or cutoff of
 * the same kind would add. Inactive lights count, so that toggling or recolouring one never needs
 * another program. DECLARED_FEATURES in the GLSL.
 */
export function declaredFeatures(lights: Iterable<Values>): number {
  let declared = 0;
  for (const light of lights) {
    const kind = kindOf(light);
    declared |= LIGHT_FEATURES[kind];
    for (const { bit, ever } of FEATURES_OF[kind]) {
      if (ever(light)) {
        declared |= bit;
      }
    }
    if (!isBlack(light.ambient)) {
      declared |= LIGHT_FEATURES.ambient; // any light's: see HEADER
    }
  }
  // Without a cone there is no side to compare it on.
  return (declared & LIGHT_FEATURES.wide) === 0 ? declared & ~LIGHT_FEATURES.narrow : declared;
}

export function featuresOf(light: Values, kind: LightKind): number {
  const { cutoff } = light;
  let mask = kind === 'spot' && isIntegerPower(cutoff) ? cutoff << LIGHT_FEATURES.powerShift : 0;
  for (const feature of FEATURES_OF[kind]) {
    if (feature.now(light)) {
      mask |= feature.bit;
    }
  }
  return mask;
}

/** The bits of a mask; above them is an integer power. */
const BITS = (1 << LIGHT_FEATURES.powerShift) - 1;

/** What lights of both masks need. Cutoffs that differ need a general power. */
export function unionOf(a: number, b: number): number {
  const power = a >> LIGHT_FEATURES.powerShift;
  const samePower =
    power === b >> LIGHT_FEATURES.powerShift && ((a ^ b) & LIGHT_FEATURES.decay) === 0;
  const decay = samePower ? power << LIGHT_FEATURES.powerShift : LIGHT_FEATURES.decay;
  return ((a | b) & BITS) | decay;
}
