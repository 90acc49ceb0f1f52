// The sum over the lights at one point, in shading space. The caller applies the material's colours
// once. Needs light_rows, guard, power, attenuation, spot, diffuse_lobe and one specular lobe.
//
// `features` is a sum of FEATURE_… bits: the code that lights need. It is a literal at every call,
// so compilers drop the rest. By default there is a loop for each kind of light, with the number of
// turns read from the header and the features of everything declared: DECLARED_FEATURES, an integer
// literal. LIGHT_STATEMENTS, where it is defined, replaces the loops: a specialised program's
// statements. There is no per-fragment branch: it would take 1.25 times as long in software and
// gain nothing on a GPU.

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

/**
 * Adds one light's diffuse and specular terms times `factor`. L unit, or zero where there is no
 * direction.
 */
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

/**
 * L from p to a light's position, the distance d and its square; L and d are zero where the light
 * is at p.
 */
vec3 towardLight(vec3 position, vec3 p, out float d, out float squared) {
  vec3 v = position - p;
  squared = dot(v, v);
  float inverse = squared < NEAREST_SQUARED ? 0.0 : inversesqrt(max(squared, NEAREST_SQUARED));
  d = squared * inverse;
  return v * inverse;
}

/**
 * Adds the directional light whose first row is `row`. All three functions take the same arguments.
 */
void addDirectional(inout LightSums sums, int row, vec3 p, vec3 N, vec3 view, float n, int features) {
  DirectionalLight light = directionalLight(row);
  addLobes(sums, N, view, light.direction, n, light.diffuse, light.specular, 1.0, features);
}

void addPoint(inout LightSums sums, int row, vec3 p, vec3 N, vec3 view, float n, int features) {
  PointLight light = pointLight(row);
  float d, squared;
  vec3 L = towardLight(light.position, p, d, squared);
  float factor = has(features, FEATURE_ATTENUATED) ? attenuation(light.attenuation, d, squared, features) : 1.0;
  addLobes(sums, N, view, L, n, light.diffuse, light.specular, factor, features);
}

void addSpot(inout LightSums sums, int row, vec3 p, vec3 N, vec3 view, float n, int features) {
  SpotLight light = spotLight(row);
  float d, squared;
  vec3 L = towardLight(light.position, p, d, squared);
  // cos² and sin² of half the angle to the axis A; L points to the light, so c = dot(L, -A).
  bool chords = has(features, FEATURE_CHORDS);
  float cosHalfSquared = chords ? quarterLengthSquared(L - light.axis) : 0.5 - 0.5 * dot(L, light.axis);
  float sinHalfSquared = quarterLengthSquared(L + light.axis); // unused, and so removed, where a cosine will do
  // At the light itself there is no angle: inside any cone, no decay.
  sinHalfSquared = d > 0.0 ? sinHalfSquared : 0.0;
  cosHalfSquared = d > 0.0 ? cosHalfSquared : 1.0;
  bool inside = insideCone(sinHalfSquared, cosHalfSquared, light.aperture, features);
  float factor = inside ? spotDecay(sinHalfSquared, cosHalfSquared, light.cutoff, features) : 0.0;
  if (has(features, FEATURE_AMBIENT)) sums.ambient += light.ambient * factor;
  if (has(features, FEATURE_ATTENUATED)) factor *= attenuation(light.attenuation, d, squared, features);
  addLobes(sums, N, view, L, n, light.diffuse, light.specular, factor, features);
}

/**
 * Sums all lights at point p. N is unit, or zero: then only ambient light is left. V is the unit
 * vector toward the eye, or zero: then there is no specular light. n >= 0 is the specular exponent.
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
