// What a model's file may say about a surface besides Ka, Kd, Ks and the exponent, and how that
// enters the equation. Roughness becomes an exponent, metalness moves the base colour from Kd to
// Ks. The shader's file_surface.glsl computes the same per fragment.
import type { Texture } from 'three';
import { isBlack } from '../math/color.js';
import type { Vec3 } from '../math/vector.js';
import type { ShadingStyle } from './material-values.js';

/** What a file says about a surface. */
export interface BaseLook {
  /** Multiplies Ka and Kd. Encoded sRGB, 0 to 1. */
  readonly baseColor: Vec3;
  /** 0 to 1; always 1 if `alphaMode` is `opaque`. */
  readonly opacity: number;
  readonly alphaMode: 'opaque' | 'mask' | 'blend';
  /** With `mask`, fragments with a lower alpha are discarded. */
  readonly alphaCutoff: number;
  /**
   * Multiplies the base colour. Encoded sRGB with `NoColorSpace`: filtered as it is stored, under
   * `linear` decoded before. Sampled with `uv` transformed by `map.matrix` (up to date), with the
   * file's filters and wrapping. The first row is the top of the image, as in glTF.
   */
  readonly map: Texture | null;
  /**
   * The geometry's attribute `color` multiplies the base colour. `true`: encoded sRGB, decoded
   * before it is interpolated under `linear`. `linear`: interpolated as stored, then encoded.
   */
  readonly vertexColors: boolean | 'linear';
  /** The colour is the base colour: no light is summed, and nothing is emitted besides. */
  readonly unlit: boolean;
  /**
   * E, added once to the sum over the lights. Encoded sRGB; 1 is full, more is brighter. Default
   * black.
   */
  readonly emissive: Vec3;
  /** Multiplies E; encoded sRGB. */
  readonly emissiveMap: Texture | null;
  /** m, 0–1: Kd is multiplied by 1 − m, and Ks by the base colour to the share m. Default 0. */
  readonly metalness: number;
  /**
   * 0–1; null: the file says nothing, or the author gave an exponent. Then the exponent is the
   * surface's own.
   */
  readonly roughness: number | null;
  /** Green multiplies the roughness, blue the metalness. */
  readonly metalRoughMap: Texture | null;
  /** Replaces N, in the space of the vertices' tangents. Phong shading only. */
  readonly normalMap: Texture | null;
  /** Multiplies the map's x and y. Default 1. */
  readonly normalScale: number;
}

/** The look of a built-in shape, and of a file that says nothing. */
export const PLAIN_LOOK: BaseLook = {
  baseColor: [1, 1, 1],
  opacity: 1,
  alphaMode: 'opaque',
  alphaCutoff: 0.5,
  map: null,
  vertexColors: false,
  unlit: false,
  emissive: [0, 0, 0],
  emissiveMap: null,
  metalness: 0,
  roughness: null,
  metalRoughMap: null,
  normalMap: null,
  normalScale: 1,
};

/**
 * Roughness below this makes no narrower highlight: its exponent is 121,932. The smallest one that
 * a float32 renderer can tell from a mirror, by Filament's documentation ("Physically Based
 * Rendering in Filament", section 4.8.3.3).
 */
export const LEAST_ROUGHNESS = 0.045;

/**
 * The (n + 2)/(2π) of Lafortune and Willems' modified Phong lobe, without 1/(2π), at the default
 * exponent 32.
 */
export const FULL_LOBE = 34;

/**
 * Reached at a roughness of 0.76. A smaller one makes a flat patch that ends in an edge where R·V
 * reaches 0.
 */
export const LEAST_FILE_EXPONENT = 1;

/**
 * The exponent n of R·V for a roughness of 0–1: 1 from 0.76 on, 7.5 for 0.5, 312 for 0.2.
 *
 * Roughness is squared (alpha, Burley, "Physically-Based Shading at Disney", 2012). A Blinn–Phong
 * lobe of that alpha has the exponent 2/alpha² − 2 (Walter and others, "Microfacet Models for
 * Refraction through Rough Surfaces", 2007). R turns twice as fast as H, so R·V needs a quarter of
 * it (Fisher and Woo, "R.E versus N.H Specular Highlights", Graphics Gems IV, 1994).
 */
export function exponentOfRoughness(roughness: number): number {
  const least = Math.max(roughness, LEAST_ROUGHNESS);
  const alpha = least * least;
  return Math.max(0.5 / (alpha * alpha) - 0.5, LEAST_FILE_EXPONENT);
}

/**
 * The share of Ks that is left for a lobe of exponent n, at most 1: a broad lobe then reflects as
 * much light as one of the default exponent (Lafortune and Willems, "Using the Modified Phong
 * Reflectance Model for Physically Based Rendering", 1994). Metals keep all of Ks, which is the
 * only light that they reflect.
 */
export const lobeScale = (n: number): number => Math.min((n + 2) / FULL_LOBE, 1);

export const emits = ({ unlit, emissive }: BaseLook): boolean => !unlit && !isBlack(emissive);

export const hasMetalness = ({ unlit, metalness }: BaseLook): boolean => !unlit && metalness > 0;

/** A vertex has no texture: Gouraud shading takes the roughness without its map. */
export const usesRoughnessMap = (
  { unlit, roughness, metalRoughMap }: BaseLook,
  { shading }: ShadingStyle,
): boolean => !unlit && roughness !== null && metalRoughMap !== null && shading !== 'gouraud';
