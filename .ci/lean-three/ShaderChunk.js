// The one piece of GLSL that three.js puts before every ShaderMaterial's own.

import colorspace_pars_fragment from 'three/src/renderers/shaders/ShaderChunk/colorspace_pars_fragment.glsl.js';

export const ShaderChunk = { colorspace_pars_fragment };
