// The light loop with everything that any program here may ask of it: averaged highlights, and what only programs for exactly some
// lights have, lists of cells and rows in the text.
import cellList from '../../shaders/cell_list.glsl?raw';
import constantRows from '../../shaders/constant_rows.glsl?raw';
import { AVERAGES_GLSL } from '../../src/material/averaged-highlights.js';
import { lightLoop } from '../../src/material/program/source.js';

export const WHOLE_LOOP_GLSL = lightLoop(
  [AVERAGES_GLSL, cellList, '#ifdef LIGHT_CONSTANTS', constantRows, '#endif'].join('\n'),
);
