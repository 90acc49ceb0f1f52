// One quantity of the equation in place of the surface's colour: the normal, or a number of one light. Takes the place of
// surface_color. Needs light_loop. VIEW_… names the quantity.

#ifndef VIEW_NORMALS
uniform vec4 uViewPosition; // of the light, in shading space; w = 0: xyz is L, unit or zero
uniform vec4 uViewAxis; // A, unit or zero; w = cutoff
uniform vec4 uViewAttenuation; // kc, kl, kq; w = 1, or 0 without a light
#endif

/** Grey from 0 to 1, or (N + 1)/2. Shading space. N is unit, or zero. */
vec3 unitSurfaceColor(vec3 p, vec3 N, vec3 eye, vec3 ka, vec3 kd, vec3 ks, float n) {
#ifdef VIEW_NORMALS
  return 0.5 * N + 0.5;
#else
  float d = 0.0;
  float squared = 0.0;
  vec3 L = uViewPosition.xyz;
  if (uViewPosition.w > 0.0) L = towardLight(L, p, d, squared);
  float value = 1.0;
#if defined(VIEW_N_DOT_L)
  value = diffuseLobe(dot(N, L));
#elif defined(VIEW_R_DOT_V)
  // The lobe with the exponent 1.
  value = dot(N, L) > 0.0 ? specularLobe(N, L, specularView(N, unitInRange(eye - p)), 1.0) : 0.0;
#elif defined(VIEW_ATTENUATION)
  if (uViewPosition.w > 0.0) value = attenuation(uViewAttenuation.xyz, d, squared, FEATURE_CLAMPED + FEATURE_LINEAR);
#elif defined(VIEW_DECAY)
  bool aimed = dot(L, L) > 0.5 && dot(uViewAxis.xyz, uViewAxis.xyz) > 0.5; // unit vectors or zero
  float sinHalfSquared = quarterLengthSquared(L + uViewAxis.xyz);
  float cosHalfSquared = quarterLengthSquared(L - uViewAxis.xyz);
  if (aimed) value = spotDecay(sinHalfSquared, cosHalfSquared, uViewAxis.w, FEATURE_DECAY + FEATURE_CHORDS);
#endif
  return vec3(value * uViewAttenuation.w);
#endif
}
