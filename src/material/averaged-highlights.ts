// GLSL for FILTER_HIGHLIGHTS: specular lobes averaged over the pixel. Apart from all other GLSL, because few pictures ask for it.
import averagedBlinnPhong from '../../shaders/averaged_blinn_phong.glsl?raw';
import averagedPhong from '../../shaders/averaged_phong.glsl?raw';
import footprint from '../../shaders/footprint.glsl?raw';

/** Stands before the light loop. */
export const AVERAGES_GLSL = [
  '#ifdef FILTER_HIGHLIGHTS',
  footprint,
  '#ifdef REFLECTION_BLINN_PHONG',
  averagedBlinnPhong,
  '#else',
  averagedPhong,
  '#endif',
  '#endif',
].join('\n');
