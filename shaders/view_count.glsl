// How many lights add something, in place of the surface's colour. Takes the place of surface_color. Needs light_loop,
// and light_grid with HAS_LIGHT_GRID. Lights are packed in rows of their own (COUNTED_…) by
// src/material/view/count-lights.ts.

uniform float uViewLights; // lights that could be counted, at least 1
uniform float uViewOpen; // leading lights that have no cone

/** A bit for each channel that is not black: red 1, green 2, blue 4. */
int channelBits(vec3 color) {
  return int(color.r > 0.0) + 2 * int(color.g > 0.0) + 4 * int(color.b > 0.0);
}

/**
 * A fragment: its point, normal and view, and the channels of Ka (bits 0–2), Kd (3–5) and Ks (6–8) that are not black.
 */
struct Counted {
  vec3 p;
  vec3 N; // unit, or zero
  vec3 view; // as specularLobe takes it
  int channels;
  bool glossy; // the lobe is 1 in every direction
};

/**
 * Whether a light whose cone the fragment is in adds a term. `light`: its first row; v points to it from the fragment,
 * at any length.
 */
bool adds(vec4 light, vec3 v, Counted at) {
  int channels = int(light.w) & at.channels;
#ifdef REFLECTION_BLINN_PHONG
  bool shines = at.glossy || dot(at.N, unitInRange(v) + at.view) > 0.0;
#else
  bool shines = at.glossy || dot(v, at.view) > 0.0;
#endif
  bool faces = dot(at.N, v) > 0.0 && dot(v, v) >= NEAREST_SQUARED;
  return (channels & 7) != 0 || (faces && ((channels & 56) != 0 || ((channels & 448) != 0 && shines)));
}

/** 1 if the light whose first row is `row` adds something, else 0. */
int countLight(int row, Counted at) {
  vec4 light = lightRow(row + COUNTED_POSITION);
  vec4 axis = lightRow(row + COUNTED_AXIS);
  float d, squared;
  vec3 L = towardLight(light.xyz, at.p, d, squared);
  // A limit below 0 is compared on the far side of the axis: see insideCone.
  float side = axis.w < 0.0 ? -1.0 : 1.0;
  float limited = quarterLengthSquared(L + side * axis.xyz);
  bool inside = d == 0.0 || (limited - abs(axis.w)) * side <= 0.0;
  return int(inside && adds(light, light.xyz - at.p, at));
}

/** The count's colour. Shading space. N is unit, or zero. */
vec3 unitSurfaceColor(vec3 p, vec3 N, vec3 eye, vec3 ka, vec3 kd, vec3 ks, float n) {
  int count = 0;
#ifndef VIEW_UNLIT
  int channels = channelBits(ka) + 8 * channelBits(kd) + 64 * channelBits(ks);
  Counted at = Counted(p, N, specularView(N, unitInRange(eye - p)), channels, n < LEAST_EXPONENT);
  int row = HEADER_ROWS;
#ifdef HAS_LIGHT_GRID
  CellSpots cell = cellSpots(p);
  for (int i = 0; i < cell.count; i++) count += countLight(listedRow(cell.first + i), at);
  int spots = unlistedSpots();
  for (int i = 0; i < spots; i++, row += COUNTED_ROWS) count += countLight(row, at);
#else
  int open = int(uViewOpen);
  for (int i = 0; i < open; i++, row += COUNTED_ROWS) {
    vec4 light = lightRow(row + COUNTED_POSITION);
    count += int(adds(light, light.xyz - p, at));
  }
#if (DECLARED_FEATURES & FEATURE_WIDE) != 0
  int cones = int(lightRow(HEADER_COUNTS).z) - open;
  for (int i = 0; i < cones; i++, row += COUNTED_ROWS) count += countLight(row, at);
#endif
#endif
#endif
  float t = float(count) / uViewLights;
  return SCALE_COLOR; // of t
}
