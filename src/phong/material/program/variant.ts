// A variant is the defines and the text of one program. A material's general variant works for any
// number of lights; specialised variants (special-variant.ts) are derived from it for the current
// ones.
import type { Texture } from 'three';
import { FEATURES } from '../../light/light-layout.js';
import type { Term } from '../../light/light-state.js';
import { isDecodable } from '../decoded-texture.js';
import { emits, hasMetalness, usesRoughnessMap, type BaseLook } from '../file-surface.js';
import type { ShadingStyle } from '../material-values.js';
import { type Shaders, shadersOf } from './source.js';

/** What a general variant depends on besides its lights. */
export interface MaterialFeatures {
  readonly look: BaseLook;
  /** `terms` are those whose code is needed. */
  readonly style: ShadingStyle;
  /** Shading happens in linear light: `color-interpolation="linear"`. */
  readonly linear: boolean;
  /** All exponents so far were mild: see LARGEST_MILD_POWER. */
  readonly mildShininess: boolean;
}

/** The defines and the text of one program; `key` identifies the variant. */
export interface Variant extends Shaders {
  readonly defines: Readonly<Record<string, string>>;
  readonly key: string;
}

/**
 * The variant for any number of lights. `capacity`: rows of its uniform array, or 0 for a texture.
 */
export function generalVariant(
  { look, style, linear, mildShininess }: MaterialFeatures,
  declared: number,
  capacity: number,
): Variant {
  const { unlit, alphaMode } = look;
  const needed = unlit ? 0 : declared & maskOf(style.terms);
  // Flat differs from phong in its geometry alone: every vertex carries its triangle's own normal.
  const gouraud = style.shading === 'gouraud';
  const flags: Record<string, boolean> = {
    SHADING_GOURAUD: gouraud,
    REFLECTION_BLINN_PHONG: style.reflection === 'blinn-phong',
    SHININESS_IS_MILD: mildShininess,
    IS_LINEAR: linear,
    IS_UNLIT: unlit,
    IS_BLENDED: alphaMode === 'blend',
    HAS_ALPHA_MASK: alphaMode === 'mask',
    HAS_VERTEX_COLOR: look.vertexColors !== false,
    DECODES_VERTEX_COLOR: linear && look.vertexColors === true,
    ENCODES_VERTEX_COLOR: !linear && look.vertexColors === 'linear',
    HAS_EMISSIVE: emits(look),
    HAS_METALNESS: hasMetalness(look),
    HAS_ROUGHNESS: usesRoughnessMap(look, style),
  };
  const defines: Record<string, string> = {
    ...storageDefines(capacity),
    [DECLARED]: String(needed),
  };
  for (const [name, on] of Object.entries(flags)) {
    if (on) {
      defines[name] = '';
    }
  }
  for (const [name, map] of Object.entries(sampledMaps(look, style))) {
    if (map === null) continue;
    const uv = map.channel === 0 ? 'uv' : `uv${String(map.channel)}`;
    Object.assign(defines, {
      [`HAS_${name}`]: '',
      [`${name}_UV`]: uv,
      [`HAS_${uv.toUpperCase()}`]: '',
    });
    if (linear && !isDecodable(map)) {
      defines[`DECODES_${name}`] = '';
    }
  }
  return variantOf(defines);
}

/** The maps that a program samples, by their names in the shaders. */
function sampledMaps(
  look: BaseLook,
  style: ShadingStyle,
): Readonly<Record<string, Texture | null>> {
  const readsMetalRough = hasMetalness(look) || usesRoughnessMap(look, style);
  return {
    MAP: look.map,
    EMISSIVE_MAP: emits(look) ? look.emissiveMap : null,
    METAL_ROUGH_MAP: readsMetalRough ? look.metalRoughMap : null,
    NORMAL_MAP: !look.unlit && style.shading === 'phong' ? look.normalMap : null,
  };
}

export const storageDefines = (capacity: number): Record<string, string> =>
  capacity > 0
    ? { LIGHT_STORAGE: 'STORAGE_UNIFORMS', LIGHT_ROWS: String(capacity) }
    : { LIGHT_STORAGE: 'STORAGE_TEXTURE' };

/**
 * Sorts the defines: three.js's program key depends on their order. `surface` and `grid`: see
 * {@link shadersOf}.
 */
export function variantOf(
  defines: Readonly<Record<string, string>>,
  surface?: string,
  grid?: string,
): Variant {
  // Gouraud shading sums the lights at the vertices, everything else at the fragments.
  const lit = 'IS_UNLIT' in defines ? null : 'SHADING_GOURAUD' in defines ? 'vertex' : 'fragment';
  const sorted = Object.entries(defines).sort(([a], [b]) => (a < b ? -1 : 1));
  return {
    defines: Object.fromEntries(sorted),
    key: sorted.map((pair) => pair.join('=')).join(' '),
    ...shadersOf(lit, surface, grid),
  };
}

export const DECLARED = 'DECLARED_FEATURES';

/** All features but those of values that enter none of these terms. */
export function maskOf(terms: readonly Term[]): number {
  let mask = ~0;
  for (const { bit, terms: own } of FEATURES) {
    if (!own.some((term) => terms.includes(term))) {
      mask &= ~bit;
    }
  }
  return mask;
}
