// Blinn's lobe (James F. Blinn, "Models of light reflection for computer synthesized pictures", SIGGRAPH 1977).
// Needs guard and power, and footprint with FILTER_HIGHLIGHTS.

/**
 * A squared |L + V| below this is nothing but rounding, and light and eye are opposite each other: unit vectors of float32 are
 * 1e-7 off. Without it an H200 made a half vector of what was left, and a highlight of up to 201/255 where there is none.
 */
const float LEAST_SUM = 1e-12;

/** What of the eye the lobe compares with: V. */
vec3 specularView(vec3 N, vec3 V) {
  return V;
}

#ifdef FILTER_HIGHLIGHTS
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
#else
/** max(dot(N, H), 0)^n with H = (L + V)/|L + V|. N, L, V unit (V may be zero); NoL > 0. */
float specularLobe(vec3 N, vec3 L, vec3 V, float n) {
  // Where light and eye are almost opposite, the sum is short and errors of their lengths are most of it.
  vec3 sum = refined(L) + refined(V);
  float squared = dot(sum, sum);
#if defined(WHOLE_SHININESS)
  float NoH = dot(N, sum) * inversesqrt(max(squared, LEAST_SUM));
  return squared >= LEAST_SUM ? wholePower(clamp(NoH, 0.0, 1.0), WHOLE_SHININESS) : 0.0;
#else
  vec3 H = squared >= LEAST_SUM ? sum * inversesqrt(squared) : vec3(0.0);
#if defined(MILD_SHININESS)
  return mildPower(dot(N, H), n);
#else
  vec3 d = N - H;
  return powerNearOne(dot(N, H), 0.5 * dot(d, d), n);
#endif
#endif
}
#endif
