// Phong's lobe (Bui Tuong Phong, "Illumination for computer generated pictures", CACM 18(6), 1975). Needs power.

/**
 * What of the eye the lobe compares with: W = 2 NoV N - V, the same for all lights, because dot(R, V) = dot(L, W), and
 * |R - V| = |L - W|: a reflection keeps lengths. N, V unit; a zero V gives what no light is near to.
 */
vec3 specularView(vec3 N, vec3 V) {
  vec3 W = 2.0 * dot(N, V) * N - V;
#ifdef WHOLE_SHININESS
  W = dot(V, V) > 0.0 ? W : vec3(3.0);
#endif
  return W;
}

/** max(dot(R, V), 0)^n with R = 2 NoL N - L. N, L unit, W as above; NoL > 0. */
float specularLobe(vec3 N, vec3 L, vec3 W, float n) {
  vec3 d = L - W;
  float y = 0.5 * dot(d, d); // 1 - dot(R, V) of unit vectors, without cancelling at the highlight's centre
#ifdef WHOLE_SHININESS
  return wholePower(max(1.0 - y, 0.0), WHOLE_SHININESS);
#elif defined(MILD_SHININESS)
  return mildPower(dot(L, W), n);
#else
  return powerNearOne(dot(L, W), y, n);
#endif
}
