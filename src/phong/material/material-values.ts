// What an author says about a surface: its values in HTML's units (255 = 1) with their domains and
// defaults, and how it is shaded. Names that markup, panel, material and programs share.
import { LIMITS, type Term, TERMS } from '../light/light-state.js';
import { colorField, type Field, numberField } from '../fields/field.js';
import type { Vec3 } from '../math/vector.js';

export interface SurfaceValues {
  /**
   * Ka: the share of ambient light that is reflected, per channel; 255 is all of it. Default 200
   * 200 200.
   */
  ka: Vec3;
  /** Kd: the same of diffuse light. Default 200 200 200. */
  kd: Vec3;
  /** Ks: the same of specular light. Default 128 128 128. */
  ks: Vec3;
  /** Specular exponent n. Below 1e-6 it makes a constant lobe. Default 32. */
  shininess: number;
}

const colors = { min: 0, max: LIMITS.color };

export const SURFACE_FIELDS: { readonly [K in keyof SurfaceValues]: Field<SurfaceValues[K]> } = {
  ka: colorField([200, 200, 200], colors),
  kd: colorField([200, 200, 200], colors),
  ks: colorField([128, 128, 128], colors),
  shininess: numberField(32, { min: 0, max: LIMITS.exponent }),
};

export const SHADINGS = ['phong', 'gouraud', 'flat'] as const;
export const REFLECTIONS = ['phong', 'blinn-phong'] as const;

export type Shading = (typeof SHADINGS)[number];
export type Reflection = (typeof REFLECTIONS)[number];

/**
 * How a surface is shaded, besides its colours. `flat` needs a geometry that carries the triangles'
 * own normals.
 */
export interface ShadingStyle {
  readonly shading: Shading;
  readonly reflection: Reflection;
  readonly terms: readonly Term[];
}

export const DEFAULT_STYLE: ShadingStyle = { shading: 'phong', reflection: 'phong', terms: TERMS };
