// Which kind of light a light's values make, and which facts about declared lights the shader must know.
// Knows nothing of packing or GLSL.
import { LEAST_EXPONENT } from './light-layout.js';
import type { Vec3 } from '../math/vector.js';
import type { LightValues } from './light-state.js';

export type LightKind = 'directional' | 'point' | 'spot';

type Values = Readonly<LightValues>;

/** All three components are 0. */
export const isBlack = (v: Vec3): boolean => v[0] === 0 && v[1] === 0 && v[2] === 0;

/** A cone or a decay, and an axis to measure it from. */
export const isSpot = (light: Values): boolean =>
  !isBlack(light.axis) && (light.aperture < 180 || light.cutoff >= LEAST_EXPONENT);

export function kindOf(light: Values): LightKind {
  if (light.position[3] === 0) return 'directional'; // its cone and decay are the same everywhere: see pack-lights
  return isSpot(light) ? 'spot' : 'point';
}

/** Attenuation that can be anything but 1. */
export const isAttenuated = (light: Values): boolean => {
  const [kc, kl, kq] = light.attenuation;
  return light.position[3] === 1 && (kc > 1 || kl > 0 || kq > 0);
};

const FACTS = [
  ...['directional', 'point', 'spot', 'attenuation', 'cone', 'decay'],
  ...['ambient', 'diffuse', 'specular'],
] as const;

/** What any light declared so far needs of the program. */
export type LightFacts = Record<(typeof FACTS)[number], boolean>;

export const noFacts = (): LightFacts => Object.fromEntries(FACTS.map((fact) => [fact, false])) as LightFacts;

/**
 * Adds what this light needs, active or not, so that toggling it never needs another program. Facts are never taken
 * back: what has been declared once may come again.
 */
export function gatherFacts(light: Values, facts: LightFacts): void {
  const kind = kindOf(light);
  facts[kind] = true;
  facts.cone ||= kind === 'spot' && light.aperture < 180;
  facts.decay ||= kind === 'spot' && light.cutoff >= LEAST_EXPONENT;
  facts.attenuation ||= isAttenuated(light);
  facts.ambient ||= !isBlack(light.ambient);
  facts.diffuse ||= !isBlack(light.diffuse);
  facts.specular ||= !isBlack(light.specular);
}
