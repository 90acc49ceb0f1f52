// Loss of light with distance. `shape` says what of it a light has: see light_loop.

/**
 * 1 / max(kc + kl·d + kq·d², 1); k = (kc, kl, kq), each >= 0; d >= 0 and `squared`, its square, in scene units. In (0, 1].
 */
float attenuation(vec3 k, float d, float squared, int shape) {
  float sum = (shape & SHAPE_LINEAR) != 0 ? k.x + d * (k.y + d * k.z) : k.x + squared * k.z;
  return 1.0 / ((shape & SHAPE_CLAMPED) != 0 ? max(sum, 1.0) : sum);
}
