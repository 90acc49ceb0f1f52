// Unit vectors of anything: zero, tiny and huge included.

/**
 * A unit vector that inversesqrt has left up to 2 ULP too long or too short, as it may, to about half an ULP: one step of
 * Newton's. Zero stays zero.
 */
vec3 refined(vec3 unit) {
  return unit * (1.5 - 0.5 * dot(unit, unit));
}

#ifdef USUAL_LENGTHS
/** The same for vectors of lengths from 1e-10 to 1e15, and shorter ones that are nothing but rounding: those give zero. */
vec3 unitOrZero(vec3 v) {
  float squared = dot(v, v);
  return squared >= 1e-20 ? v * inversesqrt(max(squared, 1e-20)) : vec3(0.0);
}
#else
/** The unit vector along v, or zero where v is zero. Any finite v; denormal ones as far as the device keeps them. */
vec3 unitOrZero(vec3 v) {
  float squared = dot(v, v);
  // Squares beyond these overflow, or lose small components to flushed denormals: a power of two, which rounds nothing,
  // brings the largest component between 2^-59 and 2^62 first. As a branch this costs an H200 nothing; chosen by ?: for
  // every vector it made a picture with one light take 1.1 to 1.2 times as long.
  if (!(squared >= 1e-20 && squared <= 1e30)) {
    vec3 a = abs(v);
    float largest = max(a.x, max(a.y, a.z));
    v *= largest > 1.0 ? 1.3552527156068805e-20 : 1.2379400392853803e27; // 2^-66, 2^90
    squared = dot(v, v);
    // Zero, or flushed to zero by the device: no direction is left to speak of.
    if (!(squared >= TINY)) return vec3(0.0);
  }
  return v * inversesqrt(squared);
}
#endif
