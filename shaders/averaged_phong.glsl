// Phong's lobe averaged over the pixel, instead of the lobe itself. Needs specular_phong and footprint.

/** W, what it and p do from one side of the pixel to the other, and the footprint of L - W. */
struct Seen {
  vec3 W;
  vec3 dxW;
  vec3 dyW;
  vec3 dxP;
  vec3 dyP;
  Footprint pixel;
};

/** At p, for light from far away. Where all fragments come by: it takes derivatives. */
Seen seenAcross(vec3 p, vec3 N, vec3 V, float n) {
  vec3 W = specularView(N, V);
  vec3 dxW = dFdx(W);
  vec3 dyW = dFdy(W);
  return Seen(W, dxW, dyW, dFdx(p), dFdy(p), footprintOf(dxW, dyW, n));
}

/** The same for light from a place that is `d` away along L: across the pixel L turns too, against p. */
Seen seenNear(Seen seen, vec3 L, float d, float n) {
  vec3 dx = seen.dxW + turning(L, seen.dxP, d * d);
  vec3 dy = seen.dyW + turning(L, seen.dyP, d * d);
  seen.pixel = footprintOf(dx, dy, n);
  return seen;
}

/** max(dot(R, V), 0)^n averaged over the pixel. N, L unit; NoL > 0. */
float specularLobe(vec3 N, vec3 L, Seen seen, float n) {
  // A zero W is no view: its lobe is 0, not the one of a chord of length 1.
  float average = averagedLobe(L - seen.W, dot(L, seen.W), n, seen.pixel);
  return dot(seen.W, seen.W) > 0.5 ? average : 0.0;
}
