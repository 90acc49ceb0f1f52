// The sum over the lights at one point. Everything is in one shading space; colours of the material are applied by
// the caller, once. Needs light_rows, guard, power, attenuation, spot, diffuse_lobe and one specular lobe.
//
// What a light needs beyond its kind is its shape: a sum of SHAPE_… bits. Shapes are literals wherever lights are added, so
// compilers drop what a shape lacks. By default all lights have the shape of everything declared (the HAS_… facts), in
// a loop; EXACT_LIGHTS, where it is defined, is the statements that add each light with its very own one.
// LIGHTS_APART is for lights that are known to be nowhere near p.
// FILTER_HIGHLIGHTS averages the specular lobe over the pixel: in fragment shaders alone, where all fragments call it.
// Nothing branches on a fragment: measured, that is 0.8 of the time in software and as fast on a GPU.

/** What the lights bring before the material: Σ Ia·decay, Σ Id·att·NoL·decay, Σ Is·att·spec·decay. */
struct LightSums {
  vec3 ambient;
  vec3 diffuse;
  vec3 specular;
  /** Of lights whose channels are alike; part of the others once lightSums has returned. */
  float greyDiffuse;
  float greySpecular;
};

#ifndef EXACT_LIGHTS
const int DECLARED_SHAPE = 0
#ifdef HAS_AMBIENT
  + SHAPE_AMBIENT
#endif
#ifdef HAS_DIFFUSE
  + SHAPE_DIFFUSE + SHAPE_TINTED_DIFFUSE
#endif
#ifdef HAS_SPECULAR
  + SHAPE_SPECULAR + SHAPE_TINTED_SPECULAR
#endif
#ifdef HAS_ATTENUATION
  + SHAPE_ATTENUATED + SHAPE_CLAMPED + SHAPE_LINEAR
#endif
#ifdef HAS_CONE
  + SHAPE_NARROW + SHAPE_WIDE
#endif
#ifdef HAS_DECAY
  + SHAPE_DECAY
#endif
#if defined(HAS_CONE) || defined(HAS_DECAY)
  + SHAPE_CHORDS
#endif
  ;
#endif

/** What of the eye a lobe compares with; see the lobes. */
#ifdef FILTER_HIGHLIGHTS
#define SEEN Seen
#else
#define SEEN vec3
#endif

bool has(int shape, int bit) {
  return (shape & bit) != 0;
}

/** Adds so much of a colour to a sum, or where it is grey one channel to another: a third of the work. */
void addColor(inout vec3 sum, inout float grey, vec3 color, float amount, bool tinted) {
  if (tinted) sum += color * amount;
  else grey += color.r * amount;
}

/** Adds one light's diffuse and specular terms, each times `factor`. L unit, or zero where there is no direction. */
void addLobes(inout LightSums sums, vec3 N, SEEN seen, vec3 L, float n, vec3 diffuse, vec3 specular, float factor, int shape) {
  float NoL = dot(N, L);
  if (has(shape, SHAPE_DIFFUSE)) {
    float amount = factor * diffuseLobe(NoL);
    addColor(sums.diffuse, sums.greyDiffuse, diffuse, amount, has(shape, SHAPE_TINTED_DIFFUSE));
  }
  if (has(shape, SHAPE_SPECULAR)) {
    float amount = NoL > 0.0 ? factor * specularLobe(N, L, seen, n) : 0.0;
    addColor(sums.specular, sums.greySpecular, specular, amount, has(shape, SHAPE_TINTED_SPECULAR));
  }
}

/** L toward a positional light, its distance d and that squared; L and d zero where the light is at the fragment. */
vec3 towardLight(vec3 place, vec3 p, out float d, out float squared) {
  vec3 v = place - p;
  squared = dot(v, v);
#ifdef LIGHTS_APART
  float inverse = inversesqrt(squared);
#else
  float inverse = squared < NEAREST_SQUARED ? 0.0 : inversesqrt(max(squared, NEAREST_SQUARED));
#endif
  d = squared * inverse;
  return v * inverse;
}

const int KIND_DIRECTIONAL = 0;
const int KIND_POINT = 1;
const int KIND_SPOT = 2;

/**
 * Adds the light that begins at `row`. All kinds begin with the same rows: a place or a direction, two colours. For a literal
 * kind, as in EXACT_LIGHTS, nothing of the others is left.
 */
void addLight(inout LightSums sums, int row, int kind, vec3 p, vec3 N, SEEN seen, float n, int shape) {
  vec4 place = lightRow(row + POINT_POSITION);
  vec4 diffuse = lightRow(row + POINT_DIFFUSE);
  vec4 specular = lightRow(row + POINT_SPECULAR);
  vec3 L = place.xyz;
  float factor = 1.0;
#if defined(EXACT_LIGHTS) || defined(HAS_POINT) || defined(HAS_SPOT)
  if (kind != KIND_DIRECTIONAL) {
    float d, squared;
    L = towardLight(place.xyz, p, d, squared);
#if defined(EXACT_LIGHTS) || defined(HAS_SPOT)
    if (kind == KIND_SPOT) {
      vec4 axis = lightRow(row + SPOT_AXIS);
      vec4 ambient = lightRow(row + SPOT_AMBIENT);
      bool chords = has(shape, SHAPE_CHORDS);
      float toBack = chords ? quarterSquare(L - axis.xyz) : 0.5 - 0.5 * dot(L, axis.xyz); // (1 + c)/2
      float toAxis = quarterSquare(L + axis.xyz); // (1 - c)/2; nothing asks for it where a cosine will do
#ifndef LIGHTS_APART
      // At the light itself there is no angle: inside any cone, no decay.
      toAxis = d > 0.0 ? toAxis : 0.0;
      toBack = d > 0.0 ? toBack : 1.0;
#endif
      bool inside = insideCone(toAxis, toBack, ambient.w, shape);
      factor = inside ? spotDecay(toAxis, toBack, axis.w, shape) : 0.0;
      if (has(shape, SHAPE_AMBIENT)) sums.ambient += ambient.rgb * factor;
    }
#endif
    if (has(shape, SHAPE_ATTENUATED)) factor *= attenuation(vec3(place.w, diffuse.w, specular.w), d, squared, shape);
#ifdef FILTER_HIGHLIGHTS
    seen = seenNear(seen, L, d, n);
#endif
  }
#endif
  addLobes(sums, N, seen, L, n, diffuse.rgb, specular.rgb, factor, shape);
}

/**
 * Sums all lights at point p with unit normal N (or zero: then only ambient light stays), unit view vector V toward
 * the eye (or zero: then no specular light), and specular exponent n >= 0.
 */
LightSums lightSums(vec3 p, vec3 N, vec3 V, float n) {
  LightSums sums = LightSums(vec3(0.0), vec3(0.0), vec3(0.0), 0.0, 0.0);
#ifdef HAS_AMBIENT
  sums.ambient = lightRow(HEADER_AMBIENT).rgb;
#endif
#ifdef FILTER_HIGHLIGHTS
  SEEN seen = seenAcross(p, N, V, n);
#else
  SEEN seen = specularView(N, V);
#endif

#ifdef EXACT_LIGHTS
  EXACT_LIGHTS
#else
  // One loop for all kinds, which stand in this order: software compiles it in 0.7 of the time that a loop for each takes.
  ivec3 counts = ivec3(lightRow(HEADER_COUNTS).xyz);
  int spots = counts.x + counts.y;
  int row = HEADER_ROWS;
  for (int i = 0; i < spots + counts.z; i++) {
    int kind = KIND_SPOT;
#ifdef HAS_POINT
    if (i < spots) kind = KIND_POINT;
#endif
#ifdef HAS_DIRECTIONAL
    if (i < counts.x) kind = KIND_DIRECTIONAL;
#endif
    addLight(sums, row, kind, p, N, seen, n, DECLARED_SHAPE);
    row += kind == KIND_DIRECTIONAL ? DIRECTIONAL_ROWS : kind == KIND_POINT ? POINT_ROWS : SPOT_ROWS;
  }
#endif
  sums.diffuse += sums.greyDiffuse;
  sums.specular += sums.greySpecular;
  return sums;
}
