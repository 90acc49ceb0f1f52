// Which code a program holds: the facts of material and lights that the shader is specialised by, as defines.
// Two states make at most a handful of programs each; none of them depends on how many lights there are.
import type { LightFacts } from '../light/light-kind.js';

export type Shading = 'phong' | 'gouraud' | 'flat';
export type Reflection = 'phong' | 'blinn-phong';
export type Term = 'ambient' | 'diffuse' | 'specular';
export type Antialias = 'edges' | 'highlights';
export type AlphaMode = 'opaque' | 'mask' | 'blend';

export const SHADINGS = ['phong', 'gouraud', 'flat'] as const satisfies readonly Shading[];
export const REFLECTIONS = ['phong', 'blinn-phong'] as const satisfies readonly Reflection[];
export const ANTIALIASES = ['edges', 'highlights'] as const satisfies readonly Antialias[];
export const TERMS = ['ambient', 'diffuse', 'specular'] as const satisfies readonly Term[];

export interface Variant {
  readonly shading: Shading;
  readonly reflection: Reflection;
  /** The terms whose code is needed. */
  readonly terms: readonly Term[];
  /** Shading happens in linear light: `color-interpolation="linear"`. */
  readonly linear: boolean;
  readonly antialias: Antialias;
  readonly map: boolean;
  readonly vertexColors: boolean;
  readonly alphaMode: AlphaMode;
}

/** The defines of a program, each present only where its code is needed. Values are empty: presence is the meaning. */
export function variantDefines(variant: Variant, facts: Readonly<LightFacts>): Record<string, string> {
  const { shading, reflection, terms, alphaMode } = variant;
  const needed = { ...facts };
  for (const term of TERMS) needed[term] &&= terms.includes(term);
  const wanted: Record<string, boolean> = {
    // Flat differs from phong in its geometry alone: every vertex carries its triangle's own normal.
    SHADING_GOURAUD: shading === 'gouraud',
    REFLECTION_BLINN_PHONG: reflection === 'blinn-phong',
    // A vertex has no pixel.
    FILTER_HIGHLIGHTS: variant.antialias === 'highlights' && needed.specular && shading !== 'gouraud',
    IS_LINEAR: variant.linear,
    HAS_MAP: variant.map,
    HAS_VERTEX_COLOR: variant.vertexColors,
    HAS_ALPHA_MASK: alphaMode === 'mask',
    IS_BLENDED: alphaMode === 'blend',
  };
  // HAS_SPOT, HAS_AMBIENT and so on.
  for (const [fact, on] of Object.entries(needed)) wanted[`HAS_${fact.toUpperCase()}`] = on;
  const defines: Record<string, string> = { LIGHT_STORAGE: 'STORAGE_TEXTURE' };
  for (const [name, on] of Object.entries(wanted)) if (on) defines[name] = '';
  return defines;
}
