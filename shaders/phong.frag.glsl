// The colour of a fragment: the sum over the lights times the material, as an 8-bit code.

uniform float uOpacity;
uniform float uMapBias; // levels by which maps are sampled coarser
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
#ifdef HAS_EMISSIVE
uniform vec3 uEmissive;
#endif
#ifdef HAS_EMISSIVE_MAP
uniform sampler2D uEmissiveMap;
in vec2 vEmissiveMapUv;
#endif
#ifdef HAS_METAL_ROUGH_MAP
uniform sampler2D uMetalRoughMap; // green: roughness, blue: metalness
in vec2 vMetalRoughMapUv;
#endif
#if defined(HAS_METALNESS) || defined(IS_UNLIT)
uniform vec3 uBaseColor; // otherwise a factor of uKa and uKd already
#endif
#ifdef HAS_METALNESS
uniform float uMetalness;
uniform float uLobeScale;
#endif
#ifdef HAS_ROUGHNESS
uniform float uRoughness;
#endif
#ifdef HAS_NORMAL_MAP
uniform sampler2D uNormalMap;
uniform float uNormalScale;
in vec2 vNormalMapUv;
in vec4 vTangent;
#endif

#ifdef IS_UNLIT
#elif defined(SHADING_GOURAUD)
in vec3 vFrontAmbient;
in vec3 vFrontDiffuse;
in vec3 vFrontSpecular;
in vec3 vBackAmbient;
in vec3 vBackDiffuse;
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

/** The factor of Ka and Kd from texture and vertex colours; opacity in w. */
vec4 baseColor() {
  vec4 color = vec4(1.0, 1.0, 1.0, uOpacity);
#ifdef HAS_MAP
  vec4 texel = texture(uMap, vMapUv, uMapBias);
#ifdef DECODES_MAP
  texel.rgb = srgbDecode(texel.rgb);
#endif
  color *= texel;
#endif
#ifdef HAS_VERTEX_COLOR
#ifdef ENCODES_VERTEX_COLOR
  color *= vec4(srgbEncode(vColor.rgb), vColor.a);
#else
  color *= vColor;
#endif
#endif
  return color;
}

void main() {
  vec4 base = baseColor();
#ifdef HAS_ALPHA_MASK
  if (base.a < uAlphaCutoff) discard;
#endif
#ifndef IS_BLENDED
  base.a = 1.0;
#endif

#ifdef IS_UNLIT
  vec3 color = base.rgb * uBaseColor;
#else
  vec3 kd = base.rgb;
  vec3 ks = vec3(1.0);
#ifdef HAS_METAL_ROUGH_MAP
  vec3 metalRough = texture(uMetalRoughMap, vMetalRoughMapUv, uMapBias).rgb;
#endif
#ifdef HAS_ROUGHNESS
  float n = exponentOfRoughness(uRoughness * metalRough.g);
  float scale = lobeScale(n);
  ks *= scale;
#endif
#ifdef HAS_METALNESS
  float m = uMetalness;
#ifdef HAS_METAL_ROUGH_MAP
  m *= metalRough.b;
#endif
#ifndef HAS_ROUGHNESS
  float scale = uLobeScale;
#endif
  kd *= 1.0 - m;
  ks = mix(vec3(scale), base.rgb * uBaseColor, m);
#endif
#ifdef SHADING_GOURAUD
  vec3 color = gl_FrontFacing
    ? base.rgb * vFrontAmbient + kd * vFrontDiffuse + ks * vFrontSpecular
    : base.rgb * vBackAmbient + kd * vBackDiffuse + ks * vBackSpecular;
#else
#ifndef HAS_ROUGHNESS
  float n = uShininess;
#endif
#ifdef HAS_NORMAL_MAP
  vec3 normal = mappedNormal(vNormal, vTangent, texture(uNormalMap, vNormalMapUv, uMapBias).xyz, uNormalScale);
#else
  vec3 normal = vNormal;
#endif
  normal = gl_FrontFacing ? normal : -normal;
  // Interpolated between unit vectors: shorter, and zero where they cancel.
  vec3 color = unitSurfaceColor(vPosition, unitInRange(normal), uEye, base.rgb * uKa, kd * uKd, ks * uKs, n);
#endif
#ifdef HAS_EMISSIVE
  vec3 emissive = uEmissive;
#ifdef HAS_EMISSIVE_MAP
  vec3 emitted = texture(uEmissiveMap, vEmissiveMapUv, uMapBias).rgb;
#ifdef DECODES_EMISSIVE_MAP
  emitted = srgbDecode(emitted);
#endif
  emissive *= emitted;
#endif
  color += emissive;
#endif
#endif
#ifdef IS_LINEAR
  color = srgbEncode(color);
#endif
  outColor = vec4(nearestCode(color) * base.a, base.a);
}
