// Blinn's lobe averaged over the pixel, instead of the lobe itself. Needs specular_blinn_phong and footprint.

/** V, and how L + V, N and p change across the pixel. */
struct PixelView {
  vec3 V;
  vec3 dxSum;
  vec3 dySum;
  vec3 dxN;
  vec3 dyN;
  vec3 dxP;
  vec3 dyP;
};

/** The view at p, for directional lights. Call only in uniform control flow: uses dFdx/dFdy. */
PixelView pixelView(vec3 p, vec3 N, vec3 V, float n) {
  return PixelView(V, dFdx(V), dFdy(V), dFdx(N), dFdy(N), dFdx(p), dFdy(p));
}

/** The same for a light at distance `d` along L: L turns too across the pixel, against p. */
PixelView pixelViewNear(PixelView view, vec3 L, float d, float n) {
  view.dxSum -= turning(L, view.dxP, d * d);
  view.dySum -= turning(L, view.dyP, d * d);
  return view;
}

/** max(dot(N, H), 0)^n averaged over the pixel. N, L, V unit (V may be zero); NoL > 0. */
float specularLobe(vec3 N, vec3 L, PixelView view, float n) {
  vec3 sum = refined(L) + refined(view.V);
  float squared = dot(sum, sum);
  vec3 H = sum * inversesqrt(max(squared, LEAST_SUM));
  vec3 e = N - H;
  vec3 dx = view.dxN - turning(H, view.dxSum, squared);
  vec3 dy = view.dyN - turning(H, view.dySum, squared);
  float average = averagedLobe(e, n, footprintOf(dx, dy, n));
  return squared >= LEAST_SUM ? average : 0.0;
}
