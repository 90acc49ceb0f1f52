// The sRGB transfer curve, on single channels where 1 is full. Constants: IEC 61966-2-1. The GLSL
// of the same curve is generated from SRGB. Colours by channels.
import { pow } from './elementary.js';
import { map, type Vec3 } from './vector.js';

export const SRGB = {
  /** Encoded value up to which the curve is a straight line. */
  encodedKnee: 0.04045,
  /** The same knee on the linear side. */
  linearKnee: 0.0031308,
  slope: 12.92,
  offset: 0.055,
  exponent: 2.4,
} as const;

/**
 * Encoded to linear light. The power branch continues above 1, as bright lights need; negative
 * values give 0.
 */
export function srgbDecode(encoded: number): number {
  if (!(encoded > 0)) return 0;
  if (encoded <= SRGB.encodedKnee) return encoded / SRGB.slope;
  return pow((encoded + SRGB.offset) / (1 + SRGB.offset), SRGB.exponent);
}

/**
 * Linear light to encoded: the inverse of {@link srgbDecode}, continued above 1 in the same way.
 */
export function srgbEncode(linear: number): number {
  if (!(linear > 0)) return 0;
  if (linear <= SRGB.linearKnee) return linear * SRGB.slope;
  return (1 + SRGB.offset) * pow(linear, 1 / SRGB.exponent) - SRGB.offset;
}

/** A channel of 0–255 as the equation takes it: 255 is 1, decoded where shading is linear. */
export const channelOf = (code: number, linear: boolean): number =>
  linear ? srgbDecode(code / 255) : code / 255;

/** {@link channelOf} of a colour. */
export const colorOf = (codes: Vec3, linear: boolean): Vec3 =>
  map(codes, (code) => channelOf(code, linear));

/** All three components are 0. */
export const isBlack = (c: Vec3): boolean => c[0] === 0 && c[1] === 0 && c[2] === 0;

export const isGrey = (c: Vec3): boolean => c[0] === c[1] && c[1] === c[2];
