// Tells triangles and their corners apart. Stands after phong.vert, whose main is named shadedMain.

flat out int vTriangle;
out vec3 vCorner; // 1 at one corner, 0 at the others

void main() {
  shadedMain();
  vTriangle = gl_VertexID / 3;
  int corner = gl_VertexID - 3 * vTriangle;
  vCorner = vec3(corner == 0, corner == 1, corner == 2);
}
