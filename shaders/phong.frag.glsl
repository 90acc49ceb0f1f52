// The colour of a fragment: the sum over the lights times the material, as an 8-bit code.

uniform float uOpacity;
#ifdef HAS_MAP
uniform sampler2D uMap;
in vec2 vMapUv;
#endif
#ifdef HAS_VERTEX_COLOR
in vec4 vColor;
#endif
#ifdef HAS_ALPHA_MASK
uniform float uAlphaCutoff;
#endif

#ifdef SHADING_GOURAUD
in vec3 vFrontBase;
in vec3 vFrontSpecular;
in vec3 vBackBase;
in vec3 vBackSpecular;
#else
uniform vec3 uEye;
uniform vec3 uKa;
uniform vec3 uKd;
uniform vec3 uKs;
uniform float uShininess;
in vec3 vPosition;
in vec3 vNormal;
#endif

layout(location = 0) out highp vec4 outColor;

/** Colours of models are stored encoded: used as they are, or decoded for linear shading. */
vec4 decodeBase(vec4 color) {
#ifdef IS_LINEAR
  color.rgb = srgbDecode(color.rgb);
#endif
  return color;
}

/** The factor of Ka and Kd from texture and vertex colours; opacity in w. */
vec4 baseColor() {
  vec4 color = vec4(1.0, 1.0, 1.0, uOpacity);
#ifdef HAS_MAP
  color *= decodeBase(texture(uMap, vMapUv));
#endif
#ifdef HAS_VERTEX_COLOR
  color *= decodeBase(vColor);
#endif
  return color;
}

void main() {
  vec4 base = baseColor();
#ifdef HAS_ALPHA_MASK
#ifdef FILTER_HIGHLIGHTS
  bool masked = base.a < uAlphaCutoff; // discarded at the end: neighbours use this fragment's derivatives
#else
  if (base.a < uAlphaCutoff) discard;
#endif
#endif
#ifndef IS_BLENDED
  base.a = 1.0;
#endif

#ifdef SHADING_GOURAUD
  vec3 color = base.rgb * (gl_FrontFacing ? vFrontBase : vBackBase) + (gl_FrontFacing ? vFrontSpecular : vBackSpecular);
#else
  vec3 normal = gl_FrontFacing ? vNormal : -vNormal;
#ifdef FILTER_HIGHLIGHTS
  vec3 color = surfaceColor(vPosition, normal, uEye, base.rgb * uKa, base.rgb * uKd, uKs, uShininess);
#else
  // Interpolated between unit vectors: shorter, and zero where they cancel.
  vec3 color = unitSurfaceColor(vPosition, unitInRange(normal), uEye, base.rgb * uKa, base.rgb * uKd, uKs, uShininess);
#endif
#endif
#ifdef IS_LINEAR
  color = srgbEncode(color);
#endif
#ifdef FILTER_HIGHLIGHTS
#ifdef HAS_ALPHA_MASK
  if (masked) discard;
#endif
#endif
  outColor = vec4(nearestCode(color) * base.a, base.a);
}
