// What of a light stays while it moves: colours as the shader takes them, cone, shape. Found once and kept until one of the
// values it is found from changes: most frames of a moving light only move it.
import { radians } from '../math/angle.js';
import { srgbDecode } from '../math/color.js';
import { map, normalize, scale, type Vec3 } from '../math/vector.js';
import { isAttenuated, isBlack, isSpot, kindOf, type LightKind } from './light-kind.js';
import { LARGEST_MILD, LEAST_EXPONENT, LIMIT_OPEN, SHAPE } from './light-layout.js';
import type { LightValues } from './light-state.js';

type Values = Readonly<LightValues>;

export class SteadyLight {
  /** Whose it is; live. */
  readonly light: Values;
  /** Where it was packed: its first row, or -1 where it is not sent. */
  row = -1;
  readonly kind: LightKind;
  /** A cone or a decay: a directional light's are the same everywhere. */
  readonly spot: boolean;
  /** Unit, or zero. */
  readonly axis: Vec3;
  /** 1 is full; decoded where the picture is linear. */
  readonly ambient: Vec3;
  readonly diffuse: Vec3;
  readonly specular: Vec3;
  /** Diffuse or specular light at all. */
  readonly shines: boolean;
  /** The cone, as the shader compares with it. */
  readonly limit: number;
  /** SHAPE's bits: of a spot, and of a light without cone and decay. */
  readonly spotShape: number;
  readonly pointShape: number;
  readonly #last: Values;
  readonly #linear: boolean;

  constructor(light: Values, linear: boolean) {
    // A copy of what it was found from; arrays are never written to, so they tell by themselves.
    this.#last = { ...light };
    this.light = light;
    this.#linear = linear;
    const color = (c: Vec3): Vec3 => {
      const unit = scale(c, 1 / 255);
      return linear ? map(unit, srgbDecode) : unit;
    };
    this.kind = kindOf(light);
    this.spot = isSpot(light);
    this.axis = normalize(light.axis);
    this.ambient = color(light.ambient);
    this.diffuse = color(light.diffuse);
    this.specular = color(light.specular);
    this.shines = !(isBlack(light.diffuse) && isBlack(light.specular));
    this.limit = packedLimit(light.aperture);
    this.pointShape = termsOf(light) + attenuationShape(light);
    this.spotShape = this.pointShape + (isBlack(light.ambient) ? 0 : SHAPE.ambient) + coneShape(light);
  }

  /** Whether it still stands for `light` as it is now, wherever in its space that is. */
  holds(light: Values, linear: boolean): boolean {
    const last = this.#last;
    return (
      light === this.light &&
      last.ambient === light.ambient &&
      last.diffuse === light.diffuse &&
      last.specular === light.specular &&
      last.axis === light.axis &&
      last.attenuation === light.attenuation &&
      last.aperture === light.aperture &&
      last.cutoff === light.cutoff &&
      last.space === light.space &&
      last.position[3] === light.position[3] &&
      linear === this.#linear
    );
  }
}

const termsOf = ({ diffuse, specular }: Values): number =>
  (isBlack(diffuse) ? 0 : SHAPE.diffuse + (isGrey(diffuse) ? 0 : SHAPE.tintedDiffuse)) +
  (isBlack(specular) ? 0 : SHAPE.specular + (isGrey(specular) ? 0 : SHAPE.tintedSpecular));

const isGrey = ([r, g, b]: Vec3): boolean => r === g && g === b;

/** `clamped` also of what is not attenuated: in a loop with others that are, all take their sum. */
function attenuationShape(light: Values): number {
  if (kindOf(light) === 'directional') return 0;
  const [kc, kl] = light.attenuation;
  const clamped = kc < 1 ? SHAPE.clamped : 0;
  return (isAttenuated(light) ? SHAPE.attenuated : 0) + clamped + (kl > 0 ? SHAPE.linear : 0);
}

/**
 * How far from 0 and 180 degrees an edge is that a cosine finds: float32 leaves an error of 4e-7 in it on the worst lawful
 * driver, which at this angle is 1.5e-6 rad.
 */
const LEAST_BY_COSINE = 15;

/** A cone that is found by its cosine. */
const isBlunt = (aperture: number): boolean =>
  aperture >= LEAST_BY_COSINE && aperture <= 180 - LEAST_BY_COSINE;

function coneShape({ aperture, cutoff }: Values): number {
  const open = aperture >= 180;
  // Below 1 a power is steep where the light shines backwards, above LARGEST_MILD at the axis.
  const tame = cutoff < LEAST_EXPONENT || (cutoff >= 1 && cutoff <= LARGEST_MILD);
  const chords = tame && (open || isBlunt(aperture)) ? 0 : SHAPE.chords;
  const side = packedLimit(aperture) < 0 ? SHAPE.wide : SHAPE.narrow;
  const cone = (open ? 0 : side) + chords;
  if (cutoff < LEAST_EXPONENT) return cone;
  if (isWholePower(cutoff)) return cone + (cutoff << SHAPE.powerShift);
  return cone + SHAPE.decay + (isMildPower(cutoff) ? SHAPE.mild : 0);
}

/** An exponent that is multiplied out where a program is made for it. */
export const isWholePower = (exponent: number): boolean =>
  Number.isInteger(exponent) && exponent >= 1 && exponent <= LARGEST_MILD;

/** An exponent whose power needs no series. */
export const isMildPower = (exponent: number): boolean =>
  exponent >= LEAST_EXPONENT && exponent <= LARGEST_MILD;

/** An aperture in degrees as the one float the shader compares with; see LIMIT_OPEN. */
export function coneLimit(aperture: number): number {
  if (aperture >= 180) return LIMIT_OPEN;
  // Beyond 90° the chord to the far side is the short one, and precise; degrees to 180 are exact.
  return aperture <= 90 ? Math.sin(radians(aperture) / 2) ** 2 : farLimit(aperture);
}

/** As it is compared on the far side of the axis. */
const farLimit = (aperture: number): number => -(Math.sin(radians(180 - aperture) / 2) ** 2);

/**
 * The same for float32: unit vectors there may be 2 ULP too long or short (inversesqrt's allowance) and round beside, so
 * what lies exactly on the axis can be 1e-6 rad off it, and a cone of no width must be that wide to hold its axis.
 * Where a cosine finds the edge it is compared on the far side, whichever is nearer.
 */
function packedLimit(aperture: number): number {
  const limit = isBlunt(aperture) ? farLimit(aperture) : coneLimit(aperture);
  return limit < 0 ? limit : Math.max(limit, LEAST_LIMIT);
}

/** sin² of half of 1e-6 rad. */
const LEAST_LIMIT = 2.5e-13;
