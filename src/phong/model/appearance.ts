// How a part of a mesh looks: its element's values, then its file's, then the defaults.
import type { Sides } from '../material/back-faces.js';
import type { BaseLook } from '../material/file-surface.js';
import type { Shading, ShadingStyle, SurfaceValues } from '../material/material-values.js';
import type { MeshState } from './mesh-fields.js';
import type { ContentPart } from './model.js';

/**
 * All that a mesh says about its material. Values are replaced when they change, never written to.
 */
export interface Appearance {
  readonly look: BaseLook;
  readonly sides: Sides;
  readonly surface: Readonly<SurfaceValues>;
  /** Null: as the picture. */
  readonly shading: Shading | null;
  readonly reflection: ShadingStyle['reflection'] | null;
}

/** How a part looks. `shading`: by default the mesh's own. */
export function appearanceOf(
  state: MeshState,
  source: ContentPart,
  shading: Appearance['shading'] = state.values.shading ?? null,
): Appearance {
  const { reflection = null } = state.values;
  return {
    look: lookOf(state, source),
    sides: source.sides,
    surface: surfaceOf(state, source),
    shading,
    reflection,
  };
}

/** Attributes win, then the file's values, then the defaults. */
function surfaceOf(state: MeshState, { surface }: ContentPart): SurfaceValues {
  const { values } = state;
  const valueOf = <K extends keyof SurfaceValues>(key: K): SurfaceValues[K] =>
    (state.given(key) ? undefined : surface[key]) ?? values[key];
  return {
    ka: valueOf('ka'),
    kd: valueOf('kd'),
    ks: valueOf('ks'),
    shininess: valueOf('shininess'),
  };
}

/** The file's look. An exponent that the author gives replaces the file's roughness. */
function lookOf(state: MeshState, { look }: ContentPart): BaseLook {
  if (look.roughness === null || !state.given('shininess')) return look;
  const copy = smooth.get(look) ?? { ...look, roughness: null };
  smooth.set(look, copy);
  return copy;
}

/**
 * Looks without their roughness: the same object each time, because materials are compared by it.
 */
const smooth = new WeakMap<BaseLook, BaseLook>();
