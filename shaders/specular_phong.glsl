// Phong's lobe (Bui Tuong Phong, "Illumination for computer generated pictures", CACM 18(6), 1975). Needs power,
// and footprint with FILTER_HIGHLIGHTS.

/**
 * What of the eye the lobe compares with: W = 2 NoV N - V, the same for all lights, because dot(R, V) = dot(L, W), and
 * |R - V| = |L - W|: a reflection keeps lengths. N, V unit; zero for a zero V.
 */
vec3 specularView(vec3 N, vec3 V) {
  return 2.0 * dot(N, V) * N - V;
}

#ifdef FILTER_HIGHLIGHTS
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
#else
/** max(dot(R, V), 0)^n with R = 2 NoL N - L. N, L unit, W as above; NoL > 0. */
float specularLobe(vec3 N, vec3 L, vec3 W, float n) {
  float RoV = dot(L, W);
#if defined(WHOLE_SHININESS)
  return wholePower(clamp(RoV, 0.0, 1.0), WHOLE_SHININESS);
#elif defined(MILD_SHININESS)
  return mildPower(RoV, n);
#else
  vec3 d = L - W;
  return powerNearOne(RoV, 0.5 * dot(d, d), n); // 1 - dot(R, V) of unit vectors, without cancelling at the highlight's centre
#endif
}
#endif
