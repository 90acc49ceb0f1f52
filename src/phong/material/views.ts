// The names of the views, and what lighting and materials know of one. What they show is in view/,
// fetched when used.
import type { IUniform } from 'three';
import type { LightValues, Term } from '../light/light-state.js';
import type { PackedLights, PackSpace } from '../light/pack-lights.js';
import type { Variant } from './program/variant.js';

/**
 * `shaded`: the equation. `ambient`, `diffuse`, `specular`: one term's sum. `normals`: (N + 1)/2
 * per channel in world space. `n-dot-l`, `r-dot-v`, `attenuation`, `decay`: of one light, grey from
 * 0 to 1. `triangles`: each for itself.
 */
export const VIEWS = [
  'shaded',
  'ambient',
  'diffuse',
  'specular',
  'normals',
  'n-dot-l',
  'r-dot-v',
  'attenuation',
  'decay',
  'triangles',
] as const;

export type View = (typeof VIEWS)[number];

/** What a picture shows in place of all lights' shaded colours. */
export interface PictureView {
  /**
   * The only term that is summed, without emissive and unlit colours. Null: the terms of each
   * material's style.
   */
  readonly term: Term | null;
  /** Every triangle has its own vertices, so that a vertex's index identifies the triangle. */
  readonly separate: boolean;
  /**
   * Packs the lights that the view reads. Called whenever lights, origin or the axes of camera
   * space have changed.
   */
  pack(lights: readonly Readonly<LightValues>[], space: PackSpace, into: PackedLights): void;
  /** The programs in place of the materials' own. Null: programs as without a view. */
  readonly program: {
    /** Uniforms of the view's own, added to each material's. */
    readonly uniforms: Readonly<Record<string, IUniform>>;
    /** The program in place of a material's general one. */
    variant(general: Variant): Variant;
  } | null;
}
