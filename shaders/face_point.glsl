// The point of a flat face that a pixel sees, from the pixel's ray. Rasterisers interpolate positions over huge
// triangles with errors that grow with the triangle's side over the eye's distance.

/**
 * Least inverse depth, for pixels whose centre lies beyond the horizon: only a part of them shows the face. Deeper than
 * any scene, and squares of what lies there are finite.
 */
const float HORIZON = 1e-17;

/**
 * Where the ray through a pixel meets the plane of a face. `pixel`: its centre, seen from the viewport's. rays *
 * (pixel, 1) is the ray at depth 1, and dot(face, (pixel, 1)) the inverse of the plane's depth along it.
 */
vec3 pointOnFace(vec3 eye, mat3 rays, vec3 face, vec2 pixel) {
  vec3 at = vec3(pixel, 1.0);
  float depth = 1.0 / max(dot(face, at), HORIZON);
  return eye + depth * (rays * at);
}
