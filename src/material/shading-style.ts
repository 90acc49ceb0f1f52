// How a surface is shaded, besides its colours. Names that markup, panel, material and programs share.

export const SHADINGS = ['phong', 'gouraud', 'flat'] as const;
export const REFLECTIONS = ['phong', 'blinn-phong'] as const;
export const TERMS = ['ambient', 'diffuse', 'specular'] as const;
export const ANTIALIASES = ['edges', 'highlights', 'full'] as const;

export type Shading = (typeof SHADINGS)[number];
export type Reflection = (typeof REFLECTIONS)[number];
export type Term = (typeof TERMS)[number];
export type Antialias = (typeof ANTIALIASES)[number];

/** How a surface is shaded, besides its colours. `flat` needs a geometry that carries the triangles' own normals. */
export interface ShadingStyle {
  readonly shading: Shading;
  readonly reflection: Reflection;
  readonly terms: readonly Term[];
  /**
   * `edges` (default): one sample per pixel inside faces; the renderer smooths edges. `highlights`: the specular lobe
   * is also averaged over each pixel, so that highlights smaller than a pixel keep their brightness; not under
   * `gouraud`. `full`: like `edges`; the picture is drawn many times, its pixels displaced, and averaged.
   */
  readonly antialias: Antialias;
}

export const DEFAULT_STYLE: ShadingStyle = {
  ...{ shading: 'phong', reflection: 'phong', terms: TERMS },
  antialias: 'edges',
};
