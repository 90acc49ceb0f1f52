// One quantity of the equation in place of the surface's colour: the normal, or a number of one
// light. Takes the place of surface_color. Needs light_loop. VIEW_VALUE calls the function of the
// view, viewNDotL for n-dot-l.

uniform vec4 uViewPosition; // of the light, in shading space; w = 0: xyz is L, unit or zero
uniform vec4 uViewAxis; // A, unit or zero; w = cutoff
uniform vec4 uViewAttenuation; // kc, kl, kq; w = 1, or 0 without a light

/** A fragment, and where the view's light is from there. Shading space. */
struct Viewed {
  vec3 N; // unit, or zero
  vec3 V; // unit, or zero
  vec3 L; // unit, or zero where there is no direction
  float d; // distance; 0 for a directional light
  float squared; // d²
};

vec3 viewNormals(Viewed at) {
  return 0.5 * at.N + 0.5;
}

/** A number of the light; 0 without one. */
vec3 ofLight(float value) {
  return vec3(value * uViewAttenuation.w);
}

float viewNDotL(Viewed at) {
  return diffuseLobe(dot(at.N, at.L));
}

/** The lobe with the exponent 1. */
float viewRDotV(Viewed at) {
  return dot(at.N, at.L) > 0.0 ? specularLobe(at.N, at.L, specularView(at.N, at.V), 1.0) : 0.0;
}

float viewAttenuation(Viewed at) {
  if (uViewPosition.w == 0.0) return 1.0;
  return attenuation(uViewAttenuation.xyz, at.d, at.squared, FEATURE_CLAMPED + FEATURE_LINEAR);
}

float viewDecay(Viewed at) {
  bool aimed = dot(at.L, at.L) > 0.5 && dot(uViewAxis.xyz, uViewAxis.xyz) > 0.5; // unit vectors or zero
  float sinHalfSquared = quarterLengthSquared(at.L + uViewAxis.xyz);
  float cosHalfSquared = quarterLengthSquared(at.L - uViewAxis.xyz);
  return aimed ? spotDecay(sinHalfSquared, cosHalfSquared, uViewAxis.w, FEATURE_DECAY + FEATURE_CHORDS) : 1.0;
}

/** Shading space. N is unit, or zero. */
vec3 unitSurfaceColor(vec3 p, vec3 N, vec3 eye, vec3 ka, vec3 kd, vec3 ks, float n) {
  float d = 0.0;
  float squared = 0.0;
  vec3 L = uViewPosition.xyz;
  if (uViewPosition.w > 0.0) L = towardLight(L, p, d, squared);
  Viewed at = Viewed(N, unitInRange(eye - p), L, d, squared);
  return VIEW_VALUE;
}
