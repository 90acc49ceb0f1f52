// The colour of a fragment: the sum over the lights times the material, clamped to what a screen holds.

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
#ifdef CONSTANT_KA
const vec3 uKa = CONSTANT_KA;
const vec3 uKd = CONSTANT_KD;
const vec3 uKs = CONSTANT_KS;
#else
uniform vec3 uKa;
uniform vec3 uKd;
uniform vec3 uKs;
#endif
uniform float uShininess;
in vec3 vPosition;
in vec3 vNormal;
#endif

layout(location = 0) out highp vec4 outColor;

/** Colours of models are kept encoded: read as they are, or decoded where the picture is linear. */
vec4 decodeBase(vec4 color) {
#ifdef IS_LINEAR
  color.rgb = srgbDecode(color.rgb);
#endif
  return color;
}

/** What the model's own texture and vertex colours multiply Ka and Kd with, and the opacity in w. */
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
  bool masked = base.a < uAlphaCutoff; // discarded at the end: neighbours take derivatives of it
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
  vec3 color = surfaceColor(vPosition, normal, uEye, base.rgb * uKa, base.rgb * uKd, uKs, uShininess);
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
