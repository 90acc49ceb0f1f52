// Which quantities can a picture show in place of the shaded colour? Names and types only, shared by markup, material and legend: the
// code of views is fetched with the first one.
import type { Mesh } from 'three';
import type { LightValues } from '../light/light-state.js';
import type { PackSpace } from '../light/pack-lights.js';
import type { PhongLighting } from './lighting.js';
import type { ProgramChoice } from './program/program-choice.js';
import type { Term } from './shading-style.js';

/**
 * `shaded`: the equation. `ambient`, `diffuse`, `specular`: one term's sum. `normals`: (N + 1)/2 per channel in world space. `n-dot-l`,
 * `r-dot-v`, `attenuation`, `decay`: of one light, grey from 0 to 1. `light-count`: how many lights add something. `triangles`: each triangle
 * for itself. `error`: how far the picture is from the equation in float64, amplified.
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
  'light-count',
  'triangles',
  'error',
] as const;

export type View = (typeof VIEWS)[number];

/** What a picture shows in place of all lights' shaded colours. */
export interface PictureView {
  /** The only term that is summed, without emissive and unlit colours. Null: the terms of each material's style. */
  readonly term: Term | null;
  /** Every triangle has its own vertices, so that a vertex's index identifies the triangle. */
  readonly separate: boolean;
  /** The lights that are packed, for these. Called whenever lights, origin or the axes of camera space have changed. */
  lights(lights: readonly Readonly<LightValues>[], space: PackSpace): readonly Readonly<LightValues>[];
  /** The program in place of a material's own one. Adds the uniforms that it needs. Null: programs as without a view. */
  readonly choose:
    | ((
        programs: Pick<ProgramChoice, 'general'>,
        lighting: PhongLighting,
        mesh: Mesh,
        uniforms: Record<string, unknown>,
      ) => ReturnType<ProgramChoice['choose']>)
    | null;
}
