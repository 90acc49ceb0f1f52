// Blinn's lobe (James F. Blinn, "Models of light reflection for computer synthesized pictures",
// SIGGRAPH 1977). Needs guard and power.

/**
 * |L + V|² below this is rounding alone: light and eye are opposite each other. Unit vectors of float32 are 1e-7 off.
 * Without this limit an H200 made a half vector of the rounding, and a highlight of up to 201/255 where there is none.
 */
const float LEAST_SUM = 1e-12;

/** What the lobe compares with: V itself. */
vec3 specularView(vec3 N, vec3 V) {
  return V;
}

/** max(dot(N, H), 0)^n with H = (L + V)/|L + V|. N, L, V unit (V may be zero); NoL > 0. */
float specularLobe(vec3 N, vec3 L, vec3 V, float n) {
  // Where light and eye are almost opposite the sum is short, and errors of the two lengths are
  // most of it.
  vec3 sum = refined(L) + refined(V);
  float squared = dot(sum, sum);
  bool hasHalf = squared >= LEAST_SUM;
  vec3 H = sum * inversesqrt(max(squared, LEAST_SUM));
  float NoH = hasHalf ? dot(N, H) : 0.0;
#if defined(INTEGER_SHININESS)
  return powInteger(max(NoH, 0.0), INTEGER_SHININESS);
#elif defined(SHININESS_IS_MILD)
  return powMild(NoH, n);
#else
  vec3 d = N - H;
  return powNearOne(NoH, 0.5 * dot(d, d), n); // 1 - dot(N, H) by a chord, as in specular_phong
#endif
}
