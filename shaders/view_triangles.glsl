// A colour for each triangle, in place of the surface's colour. Takes the place of surface_color.
// Triangles share no vertices.

flat in int vTriangle;
in vec3 vCorner;

/** How dark the lines between triangles are, beside the triangle's colour. */
const float LINE = 0.3;

vec3 unitSurfaceColor(vec3 p, vec3 N, vec3 eye, vec3 ka, vec3 kd, vec3 ks, float n) {
  // The finalizer of a hash: every bit of the number changes about half of the bits of the result.
  uint hash = uint(vTriangle) * 2654435769u;
  hash = (hash ^ (hash >> 15)) * 2246822519u;
  hash ^= hash >> 13;
  // From 80 to 255: dark lines stand out against every colour.
  vec3 color = (80.0 + floor(vec3(uvec3(hash, hash >> 8, hash >> 16) & 255u) * (175.0 / 255.0))) / 255.0;
  // Distances to the edges in pixels. Triangles of less than 3 pixels have no line: nothing would
  // be left of their colour.
  vec3 step = fwidth(vCorner);
  vec3 pixels = vCorner / max(step, TINY);
  float widest = max(step.x, max(step.y, step.z));
  float line = clamp(1.5 - min(pixels.x, min(pixels.y, pixels.z)), 0.0, 1.0) * clamp(2.0 - 6.0 * widest, 0.0, 1.0);
  return color * mix(1.0, LINE, line);
}
