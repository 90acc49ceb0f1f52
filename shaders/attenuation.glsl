// Loss of light with distance.

/** 1 / max(kc + kl·d + kq·d², 1); k = (kc, kl, kq), each >= 0; d >= 0, in scene units. In (0, 1]. */
float attenuation(vec3 k, float d) {
  return 1.0 / max(k.x + d * (k.y + d * k.z), 1.0);
}
