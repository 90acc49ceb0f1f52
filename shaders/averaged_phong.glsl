// Phong's lobe averaged over the pixel, instead of the lobe itself. Needs specular_phong and footprint.

/** W, how W and p change across the pixel, and the footprint of L - W. */
struct PixelView {
  vec3 W;
  vec3 dxW;
  vec3 dyW;
  vec3 dxP;
  vec3 dyP;
  Footprint pixel;
};

/** The view at p, for directional lights. Call only in uniform control flow: uses dFdx/dFdy. */
PixelView pixelView(vec3 p, vec3 N, vec3 V, float n) {
  vec3 W = mirroredView(N, V);
  vec3 dxW = dFdx(W);
  vec3 dyW = dFdy(W);
  return PixelView(W, dxW, dyW, dFdx(p), dFdy(p), footprintOf(dxW, dyW, n));
}

/** The same for a light at distance `d` along L: L turns too across the pixel, against p. */
PixelView pixelViewNear(PixelView view, vec3 L, float d, float n) {
  vec3 dx = view.dxW + turning(L, view.dxP, d * d);
  vec3 dy = view.dyW + turning(L, view.dyP, d * d);
  view.pixel = footprintOf(dx, dy, n);
  return view;
}

/** max(dot(R, V), 0)^n averaged over the pixel. N, L unit; NoL > 0. */
float specularLobe(vec3 N, vec3 L, PixelView view, float n) {
  // A zero W is no view: its lobe is 0, not the one of a chord of length 1.
  float average = averagedLobe(L - view.W, n, view.pixel);
  return dot(view.W, view.W) > 0.5 ? average : 0.0;
}
