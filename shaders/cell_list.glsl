// The lights of one cell of a divided box; see src/light/light-grid.ts. Stands before light_loop where EXACT_LIGHTS asks for it.
// Needs light_rows.

/** The lights that can reach the part of a divided box that p is in; see src/light/light-grid.ts. */
struct CellList {
  int first;
  int points;
  int spots;
};

CellList cellList(vec3 p) {
  int grid = int(lightRow(HEADER_COUNTS).w);
  vec4 low = lightRow(grid + GRID_LOW);
  vec4 scale = lightRow(grid + GRID_SCALE);
  vec3 size = lightRow(grid + GRID_SIZE).xyz;
  vec3 cell = clamp(floor((p - low.xyz) * scale.xyz), vec3(0.0), size - 1.0);
  vec4 list = lightRow(int(low.w) + int(cell.x + size.x * (cell.y + size.y * cell.z)));
  return CellList(int(list.x), int(list.y), int(list.z));
}

/** The first row of the light that stands at a place of a list. */
int listedRow(int place) {
  int grid = int(lightRow(HEADER_COUNTS).w);
  vec4 four = lightRow(int(lightRow(grid + GRID_SCALE).w) + (place >> 2));
  return int(four[place & 3]);
}
