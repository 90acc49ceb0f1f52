// The light loop for programs of others: with everything that a program may ask of it.
import { AVERAGES_GLSL } from './averaged-highlights.js';
import { lightLoop } from './shader-source.js';

/**
 * The light loop alone, for any GLSL ES 3.00 program: put it after `#version` and `precision highp float; precision
 * highp int;`, define LIGHT_STORAGE (STORAGE_BLOCK, STORAGE_TEXTURE, or STORAGE_OWN with a `vec4 lightRow(int)` of your own) and
 * the HAS_… facts before it, and call `surfaceColor(p, normal, eye, ka, kd, ks, shininess)` or, for the sums before the
 * material, `lightSums(p, N, V, shininess)`, with everything in the space that the lights were packed for.
 * With FILTER_HIGHLIGHTS the specular lobe is averaged over the pixel: call it then in a fragment shader, where all fragments
 * come by (in no branch or loop, before any `discard`), because it takes derivatives of what it is given.
 */
export const LIGHT_LOOP_GLSL = lightLoop(AVERAGES_GLSL);
