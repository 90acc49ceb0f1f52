// The sum over the lights at one point, in shading space. The caller applies the material's colours once. Needs
// light_rows, guard, power, attenuation, spot, diffuse_lobe and one specular lobe.
//
// `features` is a sum of FEATURE_… bits: the code that lights need. It is a literal at every call, so compilers drop
// the rest. By default there is a loop for each kind of light, with the number of turns read from the header and the
// features of everything declared: DECLARED_FEATURES, an integer literal. LIGHT_STATEMENTS, where it is defined,
// replaces the loops: a specialised program's statements. Nothing branches on a fragment: measured, that is 0.8 of
// the time in software and as fast on a GPU.

/** Σ Ia·decay, Σ Id·att·NoL·decay and Σ Is·att·spec·decay, before the material. */
struct LightSums {
  vec3 ambient;
  vec3 diffuse;
  vec3 specular;
  /** Lights whose three channels are equal; lightSums adds these to the other sums at its end. */
  float greyDiffuse;
  float greySpecular;
};

#ifndef DECLARED_FEATURES
#define DECLARED_FEATURES 0
#endif

// What lights of each kind need. A program with a light grid defines these for its own lights.
#ifndef DIRECTIONAL_FEATURES
#define DIRECTIONAL_FEATURES DECLARED_FEATURES
#endif
#ifndef POINT_FEATURES
#define POINT_FEATURES DECLARED_FEATURES
#endif
#ifndef SPOT_FEATURES
// Without FEATURE_CHORDS an H200 takes 0.93 to 0.96 of the time under 8 to 256 lights.
#define SPOT_FEATURES DECLARED_FEATURES
#endif

bool has(int features, int bit) {
  return (features & bit) != 0;
}

/** Adds a colour times an amount: grey colours to one channel, a third of the work. */
void addColor(inout vec3 sum, inout float grey, vec3 color, float amount, bool tinted) {
  if (tinted) sum += color * amount;
  else grey += color.r * amount;
}

/** Adds one light's diffuse and specular terms times `factor`. L unit, or zero where there is no direction. */
void addLobes(inout LightSums sums, vec3 N, vec3 view, vec3 L, float n, vec3 diffuse, vec3 specular, float factor, int features) {
  float NoL = dot(N, L);
  if (has(features, FEATURE_DIFFUSE)) {
    float amount = factor * diffuseLobe(NoL);
    addColor(sums.diffuse, sums.greyDiffuse, diffuse, amount, has(features, FEATURE_TINTED_DIFFUSE));
  }
  if (has(features, FEATURE_SPECULAR)) {
    float amount = NoL > 0.0 ? factor * specularLobe(N, L, view, n) : 0.0;
    addColor(sums.specular, sums.greySpecular, specular, amount, has(features, FEATURE_TINTED_SPECULAR));
  }
}

/** L from p to a light's position, the distance d and its square; L and d are zero where the light is at p. */
vec3 towardLight(vec3 position, vec3 p, out float d, out float squared) {
  vec3 v = position - p;
  squared = dot(v, v);
  float inverse = squared < NEAREST_SQUARED ? 0.0 : inversesqrt(max(squared, NEAREST_SQUARED));
  d = squared * inverse;
  return v * inverse;
}

/** Adds the directional light whose first row is `row`. All three functions take the same arguments. */
void addDirectional(inout LightSums sums, int row, vec3 p, vec3 N, vec3 view, float n, int features) {
  vec3 L = lightRow(row + DIRECTIONAL_DIRECTION).xyz;
  addLobes(sums, N, view, L, n, lightRow(row + DIRECTIONAL_DIFFUSE).rgb, lightRow(row + DIRECTIONAL_SPECULAR).rgb, 1.0, features);
}

/** Adds a positional light's lobes; `factor` is what its cone leaves. */
void addAttenuated(inout LightSums sums, int row, vec3 L, float d, float squared, vec3 N, vec3 view, float n, float factor, int features) {
  vec4 diffuse = lightRow(row + POINT_DIFFUSE);
  vec4 specular = lightRow(row + POINT_SPECULAR);
  if (has(features, FEATURE_ATTENUATED)) {
    vec3 k = vec3(lightRow(row + POINT_POSITION).w, diffuse.w, specular.w);
    factor *= attenuation(k, d, squared, features);
  }
  addLobes(sums, N, view, L, n, diffuse.rgb, specular.rgb, factor, features);
}

void addPoint(inout LightSums sums, int row, vec3 p, vec3 N, vec3 view, float n, int features) {
  float d, squared;
  vec3 L = towardLight(lightRow(row + POINT_POSITION).xyz, p, d, squared);
  addAttenuated(sums, row, L, d, squared, N, view, n, 1.0, features);
}

void addSpot(inout LightSums sums, int row, vec3 p, vec3 N, vec3 view, float n, int features) {
  float d, squared;
  vec3 L = towardLight(lightRow(row + SPOT_POSITION).xyz, p, d, squared);
  vec4 axis = lightRow(row + SPOT_AXIS);
  vec4 ambient = lightRow(row + SPOT_AMBIENT);
  // cos² and sin² of half the angle to the axis A; L points to the light, so c = dot(L, -A).
  bool chords = has(features, FEATURE_CHORDS);
  float cosHalfSquared = chords ? quarterLengthSquared(L - axis.xyz) : 0.5 - 0.5 * dot(L, axis.xyz);
  float sinHalfSquared = quarterLengthSquared(L + axis.xyz); // unused, and so removed, where a cosine will do
  // At the light itself there is no angle: inside any cone, no decay.
  sinHalfSquared = d > 0.0 ? sinHalfSquared : 0.0;
  cosHalfSquared = d > 0.0 ? cosHalfSquared : 1.0;
  bool inside = insideCone(sinHalfSquared, cosHalfSquared, ambient.w, features);
  float factor = inside ? spotDecay(sinHalfSquared, cosHalfSquared, axis.w, features) : 0.0;
  if (has(features, FEATURE_AMBIENT)) sums.ambient += ambient.rgb * factor;
  addAttenuated(sums, row, L, d, squared, N, view, n, factor, features);
}

/**
 * Sums all lights at point p. N is unit, or zero: then only ambient light is left. V is the unit vector toward the eye,
 * or zero: then there is no specular light. n >= 0 is the specular exponent.
 */
LightSums lightSums(vec3 p, vec3 N, vec3 V, float n) {
  LightSums sums = LightSums(vec3(0.0), vec3(0.0), vec3(0.0), 0.0, 0.0);
#if (DECLARED_FEATURES & FEATURE_AMBIENT) != 0
  sums.ambient = lightRow(HEADER_AMBIENT).rgb;
#endif
  vec3 view = specularView(N, V);
#ifdef LIGHT_STATEMENTS
  LIGHT_STATEMENTS
#else
  ivec3 counts = ivec3(lightRow(HEADER_COUNTS).xyz);
  int row = HEADER_ROWS;
#if (DECLARED_FEATURES & FEATURE_DIRECTIONAL) != 0
  for (int i = 0; i < counts.x; i++, row += DIRECTIONAL_ROWS) addDirectional(sums, row, p, N, view, n, DIRECTIONAL_FEATURES);
#endif
#if (DECLARED_FEATURES & FEATURE_POINT) != 0
  for (int i = 0; i < counts.y; i++, row += POINT_ROWS) addPoint(sums, row, p, N, view, n, POINT_FEATURES);
#endif
#if (DECLARED_FEATURES & FEATURE_SPOT) != 0
#ifdef HAS_LIGHT_GRID
  CellSpots cell = cellSpots(p);
  for (int i = 0; i < cell.count; i++) addSpot(sums, listedRow(cell.first + i), p, N, view, n, SPOT_FEATURES);
  counts.z = unlistedSpots();
#endif
  for (int i = 0; i < counts.z; i++, row += SPOT_ROWS) addSpot(sums, row, p, N, view, n, SPOT_FEATURES);
#endif
#endif
  sums.diffuse += sums.greyDiffuse;
  sums.specular += sums.greySpecular;
  return sums;
}
