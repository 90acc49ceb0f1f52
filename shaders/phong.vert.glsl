// Places a vertex on the screen and passes its point and normal in shading space to the fragments.
// Gouraud shading sums the lights here, for both faces: a vertex does not know from which side it
// will be seen.

in vec3 position;
in vec3 normal;
// three.js's names, because it sends these with each mesh and the material's own uniforms once.
// Both are to shading space.
uniform mat4 modelViewMatrix;
uniform mat3 normalMatrix;
uniform mat4 uShadingToClip;
#ifdef HAS_UV
in vec2 uv;
#endif
#ifdef HAS_UV1
in vec2 uv1;
#endif
#ifdef HAS_UV2
in vec2 uv2;
#endif
#ifdef HAS_UV3
in vec2 uv3;
#endif
// Each map's texture coordinates: MAP_UV and its like name the attribute.
#ifdef HAS_MAP
uniform mat3 uMapTransform;
out vec2 vMapUv;
#endif
#ifdef HAS_EMISSIVE_MAP
uniform mat3 uEmissiveMapTransform;
out vec2 vEmissiveMapUv;
#endif
#ifdef HAS_METAL_ROUGH_MAP
uniform mat3 uMetalRoughMapTransform;
out vec2 vMetalRoughMapUv;
#endif
#ifdef HAS_NORMAL_MAP
uniform mat3 uNormalMapTransform;
uniform float uMirrored; // -1 where the model's matrix mirrors, else 1
out vec2 vNormalMapUv;
in vec4 tangent; // unit; w is the side of the texture's v
out vec4 vTangent;
#endif
#ifdef HAS_VERTEX_COLOR
in vec4 color; // an attribute of three numbers gets w = 1
out vec4 vColor;
#endif

#ifdef IS_UNLIT
#elif defined(SHADING_GOURAUD)
uniform vec3 uEye;
uniform float uShininess;
out vec3 vFrontAmbient;
out vec3 vFrontDiffuse;
out vec3 vFrontSpecular;
out vec3 vBackAmbient;
out vec3 vBackDiffuse;
out vec3 vBackSpecular;
uniform vec3 uKa;
uniform vec3 uKd;
uniform vec3 uKs;

/** The terms stay apart: textures multiply Ka, Kd and Ks per fragment. */
void shadeFace(vec3 p, vec3 N, vec3 V, out vec3 ambient, out vec3 diffuse, out vec3 specular) {
  LightSums sums = lightSums(p, N, V, uShininess);
  ambient = uKa * sums.ambient;
  diffuse = uKd * sums.diffuse;
  specular = uKs * sums.specular;
}
#else
out vec3 vPosition;
out vec3 vNormal;
#endif

void main() {
  vec3 p = (modelViewMatrix * vec4(position, 1.0)).xyz;
#ifdef HAS_MAP
  vMapUv = (uMapTransform * vec3(MAP_UV, 1.0)).xy;
#endif
#ifdef HAS_EMISSIVE_MAP
  vEmissiveMapUv = (uEmissiveMapTransform * vec3(EMISSIVE_MAP_UV, 1.0)).xy;
#endif
#ifdef HAS_METAL_ROUGH_MAP
  vMetalRoughMapUv = (uMetalRoughMapTransform * vec3(METAL_ROUGH_MAP_UV, 1.0)).xy;
#endif
#ifdef HAS_NORMAL_MAP
  vNormalMapUv = (uNormalMapTransform * vec3(NORMAL_MAP_UV, 1.0)).xy;
  // Tangents lie in the surface: they turn with the model's own matrix, which may mirror.
  vTangent = vec4(unitOrZero(mat3(modelViewMatrix) * tangent.xyz), tangent.w * uMirrored);
#endif
#ifdef HAS_VERTEX_COLOR
  vColor = color;
#ifdef DECODES_VERTEX_COLOR
  vColor.rgb = srgbDecode(color.rgb);
#endif
#endif
#ifndef IS_UNLIT
  vec3 N = unitOrZero(normalMatrix * normal);
#ifdef SHADING_GOURAUD
  vec3 V = unitOrZero(uEye - p);
  shadeFace(p, N, V, vFrontAmbient, vFrontDiffuse, vFrontSpecular);
  shadeFace(p, -N, V, vBackAmbient, vBackDiffuse, vBackSpecular);
#else
  vPosition = p;
  vNormal = N;
#endif
#endif
  gl_Position = uShadingToClip * vec4(p, 1.0);
}
