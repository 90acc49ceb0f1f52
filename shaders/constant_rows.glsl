// Rows of lights that have their numbers in the program: LIGHT_CONSTANTS is all of them. A light's shape tells whether it is one of
// those; addLight, which has that shape, is all that reads rows in such a program.

const vec4 LIGHT_ROWS[] = LIGHT_CONSTANTS;

vec4 rowOf(int row, int shape) {
  if ((shape & SHAPE_CONSTANT) != 0) return LIGHT_ROWS[row];
  return lightRow(row);
}

#define lightRow(row) rowOf(row, shape)
