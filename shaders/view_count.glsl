// How many lights add something, in place of the surface's colour. Takes the place of surface_color. Needs light_loop, and
// light_grid with HAS_LIGHT_GRID. Every light is packed as a spot: src/material/view/count-lights.ts.

uniform float uViewLights; // lights that could be counted, at least 1
const vec3 SCALE[] = vec3[](SCALE_COLORS);

/** The colour for t in [0, 1]: linear between the colours of SCALE, which are evenly spaced. */
vec3 scaleColor(float t) {
  float at = t * float(SCALE.length() - 1);
  int low = min(int(at), SCALE.length() - 2);
  return mix(SCALE[low], SCALE[low + 1], at - float(low));
}

/** 1 if the light whose first row is `row` adds a term that is not black, else 0. N is unit, or zero; no component is negative. */
int adds(int row, vec3 p, vec3 N, vec3 view, vec3 ka, vec3 kd, vec3 ks, float n) {
  float d, squared;
  vec3 L = towardLight(lightRow(row + SPOT_POSITION).xyz, p, d, squared);
  vec3 axis = lightRow(row + SPOT_AXIS).xyz;
  vec4 ambient = lightRow(row + SPOT_AMBIENT);
  float sinHalfSquared = d > 0.0 ? quarterLengthSquared(L + axis) : 0.0;
  float cosHalfSquared = d > 0.0 ? quarterLengthSquared(L - axis) : 1.0;
  bool inside = insideCone(sinHalfSquared, cosHalfSquared, ambient.w, FEATURE_NARROW + FEATURE_WIDE);
#ifdef REFLECTION_BLINN_PHONG
  bool glossy = dot(N, L + view) > 0.0;
#else
  bool glossy = dot(L, view) > 0.0;
#endif
  bool shines = dot(ks, lightRow(row + SPOT_SPECULAR).rgb) > 0.0 && (glossy || n < LEAST_EXPONENT);
  bool lit = dot(N, L) > 0.0 && (shines || dot(kd, lightRow(row + SPOT_DIFFUSE).rgb) > 0.0);
  return inside && (lit || dot(ka, ambient.rgb) > 0.0) ? 1 : 0;
}

/** The count's colour. Shading space. N is unit, or zero. */
vec3 unitSurfaceColor(vec3 p, vec3 N, vec3 eye, vec3 ka, vec3 kd, vec3 ks, float n) {
  int count = 0;
#ifndef VIEW_UNLIT
  vec3 view = specularView(N, unitInRange(eye - p));
  int row = HEADER_ROWS;
#ifdef HAS_LIGHT_GRID
  int spots = unlistedSpots();
  CellSpots cell = cellSpots(p);
  for (int i = 0; i < cell.count; i++) count += adds(listedRow(cell.first + i), p, N, view, ka, kd, ks, n);
#else
  int spots = int(lightRow(HEADER_COUNTS).z);
#endif
  for (int i = 0; i < spots; i++, row += SPOT_ROWS) count += adds(row, p, N, view, ka, kd, ks, n);
#endif
  return scaleColor(float(count) / uViewLights);
}
