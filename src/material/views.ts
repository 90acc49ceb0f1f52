// The names of the views. What they show is in view/view-table.ts, which is fetched with the first one.

/**
 * `shaded`: the equation. `ambient`, `diffuse`, `specular`: one term's sum. `normals`: (N + 1)/2 per channel in world
 * space. `n-dot-l`, `r-dot-v`, `attenuation`, `decay`: of one light, grey from 0 to 1. `light-count`: how many lights
 * add something. `triangles`: each triangle for itself. `error`: how far the picture is from the equation in float64,
 * amplified.
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
