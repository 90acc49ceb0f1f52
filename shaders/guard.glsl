// Unit vectors of anything: zero, tiny and huge included.

/**
 * A unit vector that inversesqrt has left up to 2 ULP too long or too short, as it may, to about half an ULP: one step of
 * Newton's. Zero stays zero.
 */
vec3 refined(vec3 unit) {
  return unit * (1.5 - 0.5 * dot(unit, unit));
}

/** The unit vector along v, or zero where v is zero. Any finite v; denormal ones as far as the device keeps them. */
vec3 unitOrZero(vec3 v) {
  vec3 a = abs(v);
  float largest = max(a.x, max(a.y, a.z));
  // Squares must neither overflow nor lose small components to flushed denormals: a power of two, which rounds nothing,
  // brings the largest component between 2^-59 and 2^62 first.
  float s = largest > 1.152921504606847e18 ? 1.3552527156068805e-20 // > 2^60: by 2^-66
    : largest < 9.094947017729282e-13 ? 1.2379400392853803e27 // < 2^-40: by 2^90
    : 1.0;
  vec3 u = v * s;
  float squared = dot(u, u);
  // Zero, or flushed to zero by the device: no direction is left to speak of.
  return squared >= TINY ? refined(u * inversesqrt(squared)) : vec3(0.0);
}
