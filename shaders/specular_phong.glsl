// Phong's lobe (Bui Tuong Phong, "Illumination for computer generated pictures", CACM 18(6), 1975). Needs power.

/**
 * What the lobe compares L with: W = 2 NoV N - V, the mirrored view, the same for all lights. dot(R, V) = dot(L, W) and
 * |R - V| = |L - W|, because a reflection keeps lengths. N, V unit; zero for a zero V.
 */
vec3 specularView(vec3 N, vec3 V) {
  return 2.0 * dot(N, V) * N - V;
}

#ifndef FILTER_HIGHLIGHTS
/** max(dot(R, V), 0)^n with R = 2 NoL N - L. N, L unit, W from specularView; NoL > 0. */
float specularLobe(vec3 N, vec3 L, vec3 W, float n) {
  float RoV = dot(L, W);
#if defined(INTEGER_SHININESS)
  return powInteger(clamp(RoV, 0.0, 1.0), INTEGER_SHININESS);
#elif defined(SHININESS_TO_64)
  return powTo64(RoV, n);
#else
  vec3 d = L - W;
  return powNearOne(RoV, 0.5 * dot(d, d), n); // 1 - dot(R, V) of unit vectors, without cancelling at the highlight's centre
#endif
}
#endif
