// Places a vertex on the screen and passes its point and normal in shading space to the fragments. Gouraud shading sums
// the lights here, for both faces: a vertex does not know from which side it will be seen.

in vec3 position;
in vec3 normal;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform mat4 uModelToShading;
uniform mat3 uNormalToShading;
#ifdef HAS_MAP
in vec2 uv;
uniform mat3 uMapTransform;
out vec2 vMapUv;
#endif
#ifdef HAS_VERTEX_COLOR
in vec4 color; // an attribute of three numbers gets w = 1
out vec4 vColor;
#endif

#ifdef SHADING_GOURAUD
uniform vec3 uEye;
uniform float uShininess;
out vec3 vFrontBase;
out vec3 vFrontSpecular;
out vec3 vBackBase;
out vec3 vBackSpecular;
uniform vec3 uKa;
uniform vec3 uKd;
uniform vec3 uKs;

/** Base and specular stay apart: a texture multiplies Ka and Kd per fragment, and not Ks. */
void shadeFace(vec3 p, vec3 N, vec3 V, out vec3 base, out vec3 specular) {
  LightSums sums = lightSums(p, N, V, uShininess);
  base = uKa * sums.ambient + uKd * sums.diffuse;
  specular = uKs * sums.specular;
}
#else
out vec3 vPosition;
out vec3 vNormal;
#endif

void main() {
  vec3 p = (uModelToShading * vec4(position, 1.0)).xyz;
  vec3 N = unitOrZero(uNormalToShading * normal);
#ifdef HAS_MAP
  vMapUv = (uMapTransform * vec3(uv, 1.0)).xy;
#endif
#ifdef HAS_VERTEX_COLOR
  vColor = color;
#endif
#ifdef SHADING_GOURAUD
  vec3 V = unitOrZero(uEye - p);
  shadeFace(p, N, V, vFrontBase, vFrontSpecular);
  shadeFace(p, -N, V, vBackBase, vBackSpecular);
#else
  vPosition = p;
  vNormal = N;
#endif
  gl_Position = projectionMatrix * (modelViewMatrix * vec4(position, 1.0));
}
