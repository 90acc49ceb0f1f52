// What a model's textures say about a surface: its exponent, its metalness, its normal. Needs guard
// and the program's head.

/**
 * The exponent for a roughness of 0–1. Burley's alpha = roughness², Blinn–Phong's 2/alpha² - 2
 * (Walter and others 2007), a quarter of it for R·V (Fisher and Woo 1994).
 * src/phong/material/file-surface.ts has the same function in float64.
 */
float exponentOfRoughness(float roughness) {
  float alpha = max(roughness, LEAST_ROUGHNESS);
  alpha *= alpha;
  return max(0.5 / (alpha * alpha) - 0.5, LEAST_FILE_EXPONENT);
}

/**
 * The share of Ks that keeps a broad lobe's light that of the default exponent's lobe; 1 for
 * narrower ones.
 */
float lobeScale(float n) {
  return min((n + 2.0) / FULL_LOBE, 1.0);
}

/**
 * The normal that a normal map's texel stands for; its length is of no meaning. `normal` is the
 * interpolated one, `tangent` points along the texture's u, its w gives the side of v. A zero
 * tangent leaves the normal as it is.
 */
vec3 mappedNormal(vec3 normal, vec4 tangent, vec3 texel, float scale) {
  vec3 N = unitInRange(normal);
  vec3 B = cross(N, tangent.xyz) * tangent.w;
  vec3 t = texel * 2.0 - 1.0;
  return scale * (t.x * tangent.xyz + t.y * B) + t.z * N;
}
