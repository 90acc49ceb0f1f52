// A spot's cone and its decay away from the axis. c is the cosine between the axis and the
// fragment. Steep cones and decays use chords: (1 - c)/2 = sin²(angle/2) = |a - b|²/4 for unit a, b
// does not cancel at small angles. Needs power.

/** |v|²/4: sin² of half the angle between unit a and b for v = a - b, cos² of it for v = a + b. */
float quarterLengthSquared(vec3 v) {
  return 0.25 * dot(v, v);
}

/**
 * Whether the fragment is inside the cone. sinHalfSquared = (1 - c)/2, cosHalfSquared = (1 + c)/2.
 * `limit` as packed: >= 0 is the largest sinHalfSquared allowed, < 0 is minus the smallest
 * cosHalfSquared.
 */
bool insideCone(float sinHalfSquared, float cosHalfSquared, float limit, int features) {
  bool narrow = (features & FEATURE_NARROW) != 0;
  bool wide = (features & FEATURE_WIDE) != 0;
  if (narrow && wide) return limit < 0.0 ? cosHalfSquared >= -limit : sinHalfSquared <= limit;
  if (narrow) return sinHalfSquared <= limit;
  if (wide) return cosHalfSquared >= -limit;
  return true;
}

/** ((c + 1)/2)^cutoff. */
float spotDecay(float sinHalfSquared, float cosHalfSquared, float cutoff, int features) {
  int integer = features >> FEATURE_POWER_SHIFT;
  bool chords = (features & FEATURE_CHORDS) != 0;
  if (integer > 0) return powInteger(chords ? 1.0 - sinHalfSquared : cosHalfSquared, integer);
  if ((features & FEATURE_DECAY) != 0 && !chords) return powFrom1(cosHalfSquared, cutoff);
  if ((features & FEATURE_DECAY) != 0) return powNearOne(cosHalfSquared, sinHalfSquared, cutoff);
  return 1.0;
}
