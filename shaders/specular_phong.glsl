// Phong's lobe (Bui Tuong Phong, "Illumination for computer generated pictures", CACM 18(6), 1975).
// Needs power.

/**
 * The mirrored view W = 2 NoV N - V, the same for all lights. dot(R, V) = dot(L, W) and |R - V| =
 * |L - W|, because a reflection keeps lengths. N, V unit; zero for a zero V.
 */
vec3 mirroredView(vec3 N, vec3 V) {
  return 2.0 * dot(N, V) * N - V;
}

/**
 * What the lobe compares L with: W. Without a view it is -N, which is behind every L with NoL > 0.
 */
vec3 specularView(vec3 N, vec3 V) {
  return dot(V, V) > 0.5 ? mirroredView(N, V) : -N;
}

/** max(dot(R, V), 0)^n with R = 2 NoL N - L. N, L unit, W from specularView; NoL > 0. */
float specularLobe(vec3 N, vec3 L, vec3 W, float n) {
#if defined(INTEGER_SHININESS)
  return powInteger(max(dot(L, W), 0.0), INTEGER_SHININESS);
#elif defined(SHININESS_IS_MILD)
  return powMild(dot(L, W), n);
#else
  // 1 - dot(R, V), without cancelling at the highlight's centre. There it hardly depends on the
  // vectors' lengths either, whose errors inversesqrt brings: those of N count four times in W. A
  // cosine gives all of them to the power.
  vec3 d = L - W;
  return powNearOne(dot(L, W), 0.5 * dot(d, d), n);
#endif
}
