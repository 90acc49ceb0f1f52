// Loss of light with distance.

/**
 * 1 / max(kc + kl·d + kq·d², 1), in (0, 1]. k = (kc, kl, kq), each >= 0; d >= 0 in scene units, and
 * its square. `features`: without FEATURE_LINEAR kl is 0, without FEATURE_CLAMPED the sum is at
 * least 1.
 */
float attenuation(vec3 k, float d, float squared, int features) {
  float sum = (features & FEATURE_LINEAR) != 0 ? k.x + d * (k.y + d * k.z) : k.x + squared * k.z;
  return 1.0 / ((features & FEATURE_CLAMPED) != 0 ? max(sum, 1.0) : sum);
}
