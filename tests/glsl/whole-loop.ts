// The light loop with everything that any program here may ask of it: averaged highlights, and the lists of cells, which only programs
// for exactly some lights have.
import cellList from '../../shaders/cell_list.glsl?raw';
import { AVERAGES_GLSL } from '../../src/material/averaged-highlights.js';
import { lightLoop } from '../../src/material/shader-source.js';

export const WHOLE_LOOP_GLSL = lightLoop(`${AVERAGES_GLSL}\n${cellList}`);
