// Blinn's lobe (James F. Blinn, "Models of light reflection for computer synthesized pictures", SIGGRAPH 1977).
// Needs guard and power.

/** What of the eye the lobe compares with: V. */
vec3 specularView(vec3 N, vec3 V) {
  return V;
}

/** max(dot(N, H), 0)^n with H = (L + V)/|L + V|. N, L, V unit (V may be zero); NoL > 0. */
float specularLobe(vec3 N, vec3 L, vec3 V, float n) {
  // Where light and eye are almost opposite, the sum is short and errors of their lengths are most of it.
  vec3 sum = refined(L) + refined(V);
  float squared = dot(sum, sum);
  vec3 H = squared >= TINY ? sum * inversesqrt(squared) : vec3(0.0);
  vec3 d = N - H;
  float y = 0.5 * dot(d, d);
#ifdef WHOLE_SHININESS
  return squared >= TINY ? wholePower(max(1.0 - y, 0.0), WHOLE_SHININESS) : 0.0;
#elif defined(MILD_SHININESS)
  return mildPower(dot(N, H), n);
#else
  return powerNearOne(dot(N, H), y, n);
#endif
}
