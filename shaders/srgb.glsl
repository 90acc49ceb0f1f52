// The sRGB transfer curve (IEC 61966-2-1); its constants are defined by the program's head.

vec3 srgbDecode(vec3 encoded) {
  vec3 e = max(encoded, 0.0);
  vec3 line = e / SRGB_SLOPE;
  vec3 curve = pow((e + SRGB_OFFSET) / (1.0 + SRGB_OFFSET), vec3(SRGB_EXPONENT));
  return mix(curve, line, lessThanEqual(e, vec3(SRGB_ENCODED_KNEE)));
}

vec3 srgbEncode(vec3 linear) {
  vec3 l = max(linear, 0.0);
  vec3 line = l * SRGB_SLOPE;
  vec3 curve = (1.0 + SRGB_OFFSET) * pow(max(l, SRGB_LINEAR_KNEE), vec3(1.0 / SRGB_EXPONENT)) - SRGB_OFFSET;
  return mix(curve, line, lessThanEqual(l, vec3(SRGB_LINEAR_KNEE)));
}
