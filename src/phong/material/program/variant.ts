// A variant is the defines and the text of one program. A material's general variant works for any
// number of lights; specialised variants are derived from it for the current ones.
import type { Texture } from 'three';
import { kindFeatures } from '../../light/light-features.js';
import { FEATURES, HEADER, ROWS } from '../../light/light-layout.js';
import { KINDS, type LightKind, type Term } from '../../light/light-state.js';
import { forEachLight, type PackedLights } from '../../light/pack-lights.js';
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

const storageDefines = (capacity: number): Record<string, string> =>
  capacity > 0
    ? { LIGHT_STORAGE: 'STORAGE_UNIFORMS', LIGHT_ROWS: String(capacity) }
    : { LIGHT_STORAGE: 'STORAGE_TEXTURE' };

/**
 * Sorts the defines: three.js's program key depends on their order. `surface`: see {@link
 * shadersOf}.
 */
export function variantOf(defines: Readonly<Record<string, string>>, surface?: string): Variant {
  // Gouraud shading sums the lights at the vertices, everything else at the fragments.
  const lit = 'IS_UNLIT' in defines ? null : 'SHADING_GOURAUD' in defines ? 'vertex' : 'fragment';
  const sorted = Object.entries(defines).sort(([a], [b]) => (a < b ? -1 : 1));
  return {
    defines: Object.fromEntries(sorted),
    key: sorted.map((pair) => pair.join('=')).join(' '),
    ...shadersOf(lit, surface),
  };
}

/** What a specialised variant takes from its material besides the general variant. */
export interface MaterialTerms {
  readonly terms: readonly Term[];
  /** The specular exponent where it is an integer that is multiplied out; else null. */
  readonly integerShininess: number | null;
}

/**
 * How a specialised variant holds its lights. `counted`: loops of literal length, which a GPU's
 * compiler unrolls. `inlined`: each light by itself with its numbers as constants, which a software
 * renderer's compiler folds. `grid`: run-time loops over the lights of the fragment's cell, from a
 * texture.
 */
export const FORMS = ['counted', 'inlined', 'grid'] as const;
export type Form = (typeof FORMS)[number];

export function specialisedVariant(
  general: Variant,
  { terms, integerShininess }: MaterialTerms,
  form: Form,
  packed: Readonly<PackedLights>,
): Variant {
  const defines: Record<string, string> = { ...general.defines };
  const mask = maskOf(terms);
  defines[DECLARED] = String(Number(defines[DECLARED]) & mask);
  if (integerShininess !== null) {
    defines['INTEGER_SHININESS'] = String(integerShininess);
  }
  if (form !== 'counted') {
    delete defines['LIGHT_ROWS'];
  }
  switch (form) {
    case 'counted':
      defines['LIGHT_STATEMENTS'] = countedLoops(packed, mask);
      break;
    case 'inlined':
      defines['LIGHT_STORAGE'] = 'STORAGE_INLINED';
      defines['LIGHT_ROW_LITERALS'] = rowLiterals(packed);
      defines['LIGHT_STATEMENTS'] = calls(packed, mask);
      break;
    case 'grid':
      Object.assign(defines, storageDefines(0), { HAS_LIGHT_GRID: '' });
      for (const [kind, features] of Object.entries(kindFeatures(packed))) {
        defines[`${kind.toUpperCase()}_FEATURES`] = String(features & mask);
      }
  }
  return variantOf(defines);
}

const DECLARED = 'DECLARED_FEATURES';

/** All features but those of values that enter none of these terms. */
function maskOf(terms: readonly Term[]): number {
  let mask = ~0;
  for (const { bit, terms: own } of FEATURES) {
    if (!own.some((term) => terms.includes(term))) {
      mask &= ~bit;
    }
  }
  return mask;
}

/**
 * Most lights whose rows have literal addresses too. An H200's driver unrolls such loops: 16 lights
 * take 0.71 of MeshPhongMaterial's time instead of 0.82. But with 32 the first frame takes 65 ms
 * longer (OpenGL), without 29.
 */
const MOST_UNROLLED = 16;

/** A loop for each kind, its bounds literals. */
function countedLoops(packed: Readonly<PackedLights>, mask: number): string {
  const features = kindFeatures(packed);
  const unrolled = packed.sent <= MOST_UNROLLED;
  let first: number = HEADER.rows;
  const loops = KINDS.map((kind) => {
    const { rows } = ROWS[kind];
    const row = unrolled ? `${String(first)}+i*${String(rows)}` : 'row';
    const step = unrolled ? '' : `,row+=${String(rows)}`;
    const count = packed.counts[kind];
    first += count * rows;
    const call = add(kind, row, features[kind] & mask);
    return count > 0 ? `for(int i=0;i<${String(count)};i++${step})${call}` : '';
  });
  return (unrolled ? '' : `int row=${String(HEADER.rows)};`) + loops.join('');
}

function calls(packed: Readonly<PackedLights>, mask: number): string {
  let text = '';
  forEachLight(packed, (light, kind, row) => {
    text += add(kind, String(row), packed.features[light]! & mask);
  });
  return text;
}

/** Adds one light; the arguments besides row and features are lightSums' own. */
const add = (kind: LightKind, row: string, features: number): string =>
  `add${kind.charAt(0).toUpperCase()}${kind.slice(1)}(sums,${row},p,N,view,n,${String(features)});`;

/** All rows as a GLSL array. Nine digits are all that float32 has. */
function rowLiterals({ data, rows }: Readonly<PackedLights>): string {
  const row = (i: number): string =>
    `vec4(${Array.from(data.subarray(i * 4, i * 4 + 4), (x) => x.toExponential(8)).join()})`;
  return `vec4[](${Array.from({ length: rows }, (_, i) => row(i)).join()})`;
}
