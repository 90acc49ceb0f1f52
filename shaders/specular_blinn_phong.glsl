// Blinn's lobe (James F. Blinn, "Models of light reflection for computer synthesized pictures", SIGGRAPH 1977).
// Needs guard and power.

/**
 * |L + V|² below this is rounding alone: light and eye are opposite each other. Unit vectors of float32 are 1e-7 off.
 * Without this limit an H200 made a half vector of the rounding, and a highlight of up to 201/255 where there is none.
 */
const float LEAST_SUM = 1e-12;

/** What the lobe compares with: V itself. */
vec3 specularView(vec3 N, vec3 V) {
  return V;
}

#ifndef FILTER_HIGHLIGHTS
/** max(dot(N, H), 0)^n with H = (L + V)/|L + V|. N, L, V unit (V may be zero); NoL > 0. */
float specularLobe(vec3 N, vec3 L, vec3 V, float n) {
  // Where light and eye are almost opposite the sum is short, and errors of the two lengths are most of it.
  vec3 sum = refined(L) + refined(V);
  float squared = dot(sum, sum);
#if defined(INTEGER_SHININESS)
  float NoH = dot(N, sum) * inversesqrt(max(squared, LEAST_SUM));
  return squared >= LEAST_SUM ? powInteger(clamp(NoH, 0.0, 1.0), INTEGER_SHININESS) : 0.0;
#else
  vec3 H = squared >= LEAST_SUM ? sum * inversesqrt(squared) : vec3(0.0);
#if defined(SHININESS_TO_64)
  return powTo64(dot(N, H), n);
#else
  vec3 d = N - H;
  return powNearOne(dot(N, H), 0.5 * dot(d, d), n);
#endif
#endif
}
#endif
