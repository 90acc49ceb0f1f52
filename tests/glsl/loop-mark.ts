// Tells whether a measurement is of the light loop as it is now.
import lightGrid from '../../shaders/light_grid.glsl?raw';
import lightLoop from '../../shaders/light_loop.glsl?raw';
import { LARGEST_MILD_POWER } from '../../src/phong/light/precision.js';
import { LIGHT_LOOP_GLSL } from '../../src/phong/material/program/source.js';
import { hashOf } from '../support/hash.mjs';

/** Eight hexadecimal digits of a GLSL text, its comments and spaces aside. */
export function markOf(glsl: string): string {
  const text = glsl.replace(/\/\*[^]*?\*\/|\/\/[^\n]*/g, '').replace(/\s+/g, ' ');
  return hashOf(text).toString(16).padStart(8, '0');
}

/** The shipped loop, with what programs with a light grid add. */
export const WHOLE_LOOP_GLSL = LIGHT_LOOP_GLSL.replace(
  lightLoop,
  (loop) => `#if defined(HAS_LIGHT_GRID)\n${lightGrid}\n#endif\n${loop}`,
);

/** Of the shipped loop, and of the exponents that its cheaper power is used for. */
export const LOOP_MARK = markOf(`${WHOLE_LOOP_GLSL} ${LARGEST_MILD_POWER}`);
