// The whole equation at one point of a surface. Needs guard and light_loop.

/**
 * The colour at point p before clamping: Ka·ΣIa·decay + Kd·ΣId·att·NoL·decay +
 * Ks·ΣIs·att·spec·decay. Everything in shading space. N is unit, or zero: then only ambient light
 * is left. n >= 0.
 */
vec3 unitSurfaceColor(vec3 p, vec3 N, vec3 eye, vec3 ka, vec3 kd, vec3 ks, float n) {
  LightSums sums = lightSums(p, N, unitInRange(eye - p), n);
  return ka * sums.ambient + kd * sums.diffuse + ks * sums.specular;
}

/** The same for a normal of any length; zero leaves ambient light only. */
vec3 surfaceColor(vec3 p, vec3 normal, vec3 eye, vec3 ka, vec3 kd, vec3 ks, float n) {
  return unitSurfaceColor(p, unitOrZero(normal), eye, ka, kd, ks, n);
}
