// Unit vectors of any input: zero, tiny and huge vectors included.

/**
 * Corrects a unit vector's length by one Newton step. inversesqrt may be 2 ULP off; this leaves
 * about half an ULP. Zero stays zero.
 */
vec3 refined(vec3 unit) {
  return unit * (1.5 - 0.5 * dot(unit, unit));
}

/**
 * The unit vector along v for lengths from 1e-15 to 1e19; zero for shorter ones. In software a
 * picture with 4 lights takes 0.8 of the time that it takes with unitOrZero, whose branch is not
 * free there.
 */
vec3 unitInRange(vec3 v) {
  float squared = dot(v, v);
  return squared >= NEAREST_SQUARED ? v * inversesqrt(max(squared, NEAREST_SQUARED)) : vec3(0.0);
}

/**
 * The unit vector along v, or zero where v is zero. Any finite v; denormal ones as far as the
 * device keeps them.
 */
vec3 unitOrZero(vec3 v) {
  float squared = dot(v, v);
  // Squares outside this range overflow, or lose small components to flushed denormals. Multiply by
  // a power of two first, which rounds nothing: it brings the largest component between 2^-59 and
  // 2^62. A branch costs an H200 nothing; `?:` on every vector made a picture with one light take
  // 1.1 to 1.2 times as long.
  if (!(squared >= 1e-20 && squared <= 1e30)) {
    vec3 a = abs(v);
    float largest = max(a.x, max(a.y, a.z));
    v *= largest > 1.0 ? 1.3552527156068805e-20 : 1.2379400392853803e27; // 2^-66, 2^90
    squared = dot(v, v);
    // Zero, or flushed to zero by the device: no direction is left.
    if (!(squared >= TINY)) return vec3(0.0);
  }
  return v * inversesqrt(squared);
}
