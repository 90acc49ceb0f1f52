// The spots of one cell of a light grid (src/phong/light/light-grid.ts). Needs light_rows.

/** A range of the grid's list of spots: those that can reach one cell. */
struct CellSpots {
  int first;
  int count;
};

/**
 * The cell that p, in shading space, lies in; the nearest one for points outside the grid's box.
 */
CellSpots cellSpots(vec3 p) {
  int grid = int(lightRow(HEADER_COUNTS).w);
  vec4 low = lightRow(grid + GRID_LOW);
  vec4 scale = lightRow(grid + GRID_SCALE);
  vec3 size = lightRow(grid + GRID_SIZE).xyz;
  vec3 cell = clamp(floor((p - low.xyz) * scale.xyz), vec3(0.0), size - 1.0);
  vec2 range = lightRow(int(low.w) + int(cell.x + size.x * (cell.y + size.y * cell.z))).xy;
  return CellSpots(int(range.x), int(range.y));
}

/** The number of leading spots that stand in no list: they reach most cells. */
int unlistedSpots() {
  int grid = int(lightRow(HEADER_COUNTS).w);
  return int(lightRow(grid + GRID_SIZE).w);
}

/** The first row of the spot at an index of the grid's list, four indices to a row. */
int listedRow(int index) {
  int grid = int(lightRow(HEADER_COUNTS).w);
  vec4 four = lightRow(int(lightRow(grid + GRID_SCALE).w) + (index >> 2));
  return int(four[index & 3]);
}
