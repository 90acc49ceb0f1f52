// Unit vectors of anything: zero, tiny and huge included.

/** The unit vector along v, or zero where v is zero. Any finite v: scaled by its largest component before squaring. */
vec3 unitOrZero(vec3 v) {
  vec3 a = abs(v);
  float largest = max(a.x, max(a.y, a.z));
  // Below the smallest normal float32 a device may flush to zero: no direction is left to speak of.
  if (!(largest >= 1.17549435e-38)) return vec3(0.0);
  vec3 s = v / largest;
  return s * inversesqrt(dot(s, s));
}
