// Blinn's lobe averaged over the pixel, instead of the lobe itself. Needs specular_blinn_phong and footprint.

/** V, and what L + V, N and p do from one side of the pixel to the other. */
struct Seen {
  vec3 V;
  vec3 dxSum;
  vec3 dySum;
  vec3 dxN;
  vec3 dyN;
  vec3 dxP;
  vec3 dyP;
};

/** At p, for light from far away. Where all fragments come by: it takes derivatives. */
Seen seenAcross(vec3 p, vec3 N, vec3 V, float n) {
  return Seen(V, dFdx(V), dFdy(V), dFdx(N), dFdy(N), dFdx(p), dFdy(p));
}

/** The same for light from a place that is `d` away along L: across the pixel L turns too, against p. */
Seen seenNear(Seen seen, vec3 L, float d, float n) {
  seen.dxSum -= turning(L, seen.dxP, d * d);
  seen.dySum -= turning(L, seen.dyP, d * d);
  return seen;
}

/** max(dot(N, H), 0)^n averaged over the pixel. N, L, V unit (V may be zero); NoL > 0. */
float specularLobe(vec3 N, vec3 L, Seen seen, float n) {
  vec3 sum = refined(L) + refined(seen.V);
  float squared = dot(sum, sum);
  vec3 H = sum * inversesqrt(max(squared, LEAST_SUM));
  vec3 e = N - H;
  vec3 dx = seen.dxN - turning(H, seen.dxSum, squared);
  vec3 dy = seen.dyN - turning(H, seen.dySum, squared);
  float average = averagedLobe(e, 1.0 - 0.5 * dot(e, e), n, footprintOf(dx, dy, n));
  return squared >= LEAST_SUM ? average : 0.0;
}
