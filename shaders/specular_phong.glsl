// Phong's lobe (Bui Tuong Phong, "Illumination for computer generated pictures", CACM 18(6), 1975). Needs power.

/** max(dot(R, V), 0)^n with R = 2 NoL N - L. N, L, V unit (V may be zero: then 0); NoL > 0. */
float specularLobe(vec3 N, vec3 L, vec3 V, float NoL, float n) {
  vec3 R = 2.0 * NoL * N - L;
  vec3 d = R - V;
  // 1 - dot(R, V) of unit vectors, without cancelling at the highlight's centre.
  return powerNearOne(dot(R, V), 0.5 * dot(d, d), n);
}
